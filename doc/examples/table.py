"""A facial deformation table fitted to an animated face, kept, and applied at half its strength."""

import mien

face = mien.Face(precision="double")
fit = mien.vtkFDTFitFilter()
fit.SetInputData(face.surface().data)
fit.SetExpressionData(face.animate("joy").surface().data)

writer = mien.vtkFDTWriter()
writer.SetInputConnection(fit.GetOutputPort())
writer.SetFileName("joy.csv")
mien.update(writer)

half = face.deform("joy.csv", 0.5)
print(f"fitted to {fit.GetRMS():.4f} pupil units; at half strength the face moves by "
      f"{half.motion().point_data['Magnitude'].max():.2f} mm")
