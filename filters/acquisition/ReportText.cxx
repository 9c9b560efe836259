#include <cmath>
#include <cstdio>
#include <string>

#include "Acquire.h"

namespace mien {

namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string landmarkLine(const ScanReport& r) {
  std::string text = r.landmarksGiven ? "  landmarks  given" : "  landmarks  fitted";
  if (r.completedLandmarks > 0) text += line(", %d of 68 completed from the generic face", r.completedLandmarks);
  if (r.landmarksGiven) text += line(", %.2f mm (median) off the scan", r.landmarkDepth);
  if (r.fitted && r.landmarksGiven)
    text += line("; fitted ones lie %.2f mm RMS from them, at most %.2f mm", r.landmarkRMS, r.landmarkMaximum);
  return text + "\n";
}

}  // namespace

std::string reportText(const AcquireResult& result) {
  const ScanReport& r = result.report;
  std::string text = result.scan + "\n";
  text += line("  unit       %s%s (1 unit is %g mm; outer eye corners %.1f mm apart)\n",
               r.unit.empty() ? "of --scale" : r.unit.c_str(), r.unitRecognised ? ", recognised" : ", given",
               r.millimetres, r.eyes);
  text += line("  pose       %s, %.1f degrees from the generic face's\n",
               r.moved ? "moved onto the generic face" : "kept as it is", r.turned * 180.0 / M_PI);
  text += line(
      "  mesh       %d triangles, %d holes and rims; %d of %d parts left out, %d vertices merged, %d triangles without "
      "area\n",
      r.triangles, r.holes, r.droppedParts, r.parts, r.mergedVertices, r.degenerateTriangles);
  if (r.windsInwards) text += "  winding    inwards: the scan may be mirrored (left-handed)\n";
  text += landmarkLine(r);
  if (r.fitted)
    text +=
        line("  fit        generic face %.2f mm RMS from the scan before bending, relief agrees by %.2f, size %.2f\n",
             r.fitDistance, r.fitRelief, r.fitSize);
  text += line("  distance   frontal spline face of these curves to scan %.3f mm RMS, at most %.2f mm\n",
               result.frontalRMS, result.frontalMaximum);
  return text + line("  crossings  %d", result.crossings) +
         (result.crossingCurves.empty() ? "" : ": " + result.crossingCurves) + "\n";
}

std::string matrixText(const ScanReport& report) {
  const Similarity& motion = report.scanToFace;
  std::string text;
  for (int r = 0; r < 3; ++r) {
    const Eigen::RowVector3d row = motion.scale * motion.rotation.row(r);
    text += line("  %s %12.6f %12.6f %12.6f %12.4f\n", r == 0 ? "matrix    " : "          ", row[0], row[1], row[2],
                 motion.translation[r]);
  }
  return text + line("             %12.6f %12.6f %12.6f %12.4f\n", 0.0, 0.0, 0.0, 1.0);
}

}  // namespace mien
