"""How the six schemes differ: seams, and distance to the spline scheme."""

import mien

spline = mien.Face().surface()
for scheme in mien.vtkPDEFaceFilter.GetSchemeNames():
    face = mien.Face(scheme=scheme)
    angle = face.continuity()["g1_max_deg"].max()
    rms = mien.compare(face.surface(), spline)["rms_mm"][0]
    print(f"{scheme:12} largest seam angle {angle:8.3f} degrees, {rms:.3f} mm RMS from spline")
