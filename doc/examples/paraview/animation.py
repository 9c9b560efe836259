"""Plays an MPEG-4 facial animation on a face and writes a picture of every tenth frame.

usage: pvpython --force-offscreen-rendering animation.py [ANIMATION.fap [FOLDER]]
The plugin is that of the build tree, or the file that MIEN_PLUGIN names. Without a display: xvfb-run -a pvpython ...
"""
import os
import sys

from paraview import simple

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
plugin = os.environ.get("MIEN_PLUGIN", os.path.join(root, "build/paraview/plugin/lib/paraview-5.11/plugins/Mien/Mien.so"))
simple.LoadPlugin(plugin, remote=False, ns=globals())

animation = sys.argv[1] if len(sys.argv) > 1 else os.path.join(root, "data/animation/demo.fap")
folder = sys.argv[2] if len(sys.argv) > 2 else "."
os.makedirs(folder, exist_ok=True)

frames = simple.OpenDataFile(animation)
curves = MienGenericFace()  # or MienBoundaryCurveReader(FileName="face.vtp")
surface = MienPDEFace(Input=MienFAPAnimation(Input=curves, FAPs=frames), Resolution=[112, 80])
face = MienFacePolygons(Input=surface)  # outwards, as ParaView lights a surface by its winding

view = simple.CreateRenderView(ViewSize=[600, 700], Background=[1, 1, 1], UseColorPaletteForBackground=0,
                               OrientationAxesVisibility=0)
shown = simple.Show(face, view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = [0.93, 0.76, 0.65]
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, 0, 900], [0, 0, 40], [0, 1, 0]
view.ResetCamera()

for number, time in enumerate(frames.TimestepValues):
    if number % 10:
        continue
    view.ViewTime = time
    name = os.path.join(folder, "frame_%04d.png" % number)
    simple.SaveScreenshot(name, view)
    print("%s: %.2f s" % (name, time))
