"""The filters in a pipeline of one's own: curves, FAPs, surface, and a file for ParaView."""

from vtkmodules.vtkIOXML import vtkXMLStructuredGridWriter

import mien

curves = mien.vtkBoundaryCurveReader()  # without a file: the generic face
animation = mien.vtkFAPAnimationFilter()
animation.SetInputConnection(curves.GetOutputPort())
animation.SetFAP(3, 400)  # open the jaw, in FAP units
face = mien.vtkPDEFaceFilter()
face.SetInputConnection(animation.GetOutputPort())
face.SetResolution(164, 160)
face.GenerateCurvaturesOn()

writer = vtkXMLStructuredGridWriter()
writer.SetInputConnection(face.GetOutputPort())
writer.SetFileName("face.vts")
mien.update(writer)
print(f"{face.GetOutput().GetNumberOfPoints()} points in face.vts")
