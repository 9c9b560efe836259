"""How far each expression moves the face: largest and mean motion, and the table as a file."""

import csv

import mien

face = mien.Face()
with open("expressions.csv", "w", newline="", encoding="utf-8") as file:
    table = csv.writer(file)
    table.writerow(["expression", "largest_mm", "mean_mm"])
    for expression in mien.vtkFAPAnimationFilter.GetExpressionNames():
        motion = face.animate(expression).motion().point_data["Magnitude"]
        table.writerow([expression, motion.max(), motion.mean()])
        print(f"{expression:10} largest {motion.max():5.2f} mm, mean {motion.mean():5.2f} mm")
