"""How far each expression moves the skin: largest and mean displacement, as a table.

usage: pvpython expressions.py        or in four processes: mpirun -np 4 pvbatch expressions.py
The plugin is that of the build tree, or the file that MIEN_PLUGIN names.
"""
import os
import sys

from paraview import simple
from paraview.servermanager import vtkProcessModule

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
plugin = os.environ.get("MIEN_PLUGIN", os.path.join(root, "build/paraview/plugin/lib/paraview-5.11/plugins/Mien/Mien.so"))
simple.LoadPlugin(plugin, remote=False, ns=globals())
from paraview.vtk.vtkParallelCore import vtkMultiProcessController  # noqa: E402

curves = MienGenericFace()
neutral = MienPDEFace(Input=curves, Resolution=[448, 320])
if vtkProcessModule.GetProcessModule().GetSymmetricMPIMode():
    sys.exit("expressions.py runs in the first process and asks the others: leave --sym out")
first = vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0
if first:
    print("expression   largest displacement (mm)")
for expression in ("Joy", "Sadness", "Anger", "Fear", "Disgust", "Surprise"):
    animated = MienFAPAnimation(Input=curves, **{expression: 1.0})
    moved = MienPDEFace(Input=animated, Resolution=[448, 320])
    vectors = MienMotionVectors(Input=moved, Neutral=neutral)
    vectors.UpdatePipeline()
    largest = vectors.GetDataInformation().GetPointDataInformation().GetArrayInformation("Magnitude").GetComponentRange(0)[1]
    if first:
        print("%-12s %.2f" % (expression.lower(), largest))
