#include "ScanReportText.h"

#include <QCoreApplication>
#include <cmath>

#include "Acquire.h"

namespace mien {

namespace {

constexpr int nameLetters = 11;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(mien::ScanReportText)
};

QString fixed(double value, int decimals) {
  return QString::number(value, 'f', decimals);
}

ScanReportLine poseLine(const ScanReport& r) {
  const QString degrees = fixed(r.turned * 180.0 / M_PI, 1);
  ScanReportLine line = {
      Words::tr("Pose"),
      r.moved ? Words::tr("turned by %1\u00b0 to look straight ahead").arg(degrees)
              : Words::tr("looks straight ahead, but for %1\u00b0").arg(degrees),
      r.moved ? Words::tr("The scan was moved and turned onto the generic face")
              : Words::tr("The scan stays where it is: it is %1\u00b0 from the pose of the generic face").arg(degrees)};
  if (!r.windsInwards) return line;
  line.value += Words::tr("; its faces wind inwards: it may be mirrored");
  line.detail += Words::tr(
      ". Its faces show their back: where the scan is mirrored (left-handed), its left is its "
      "right; where they are only wound so, all is well");
  return line;
}

QString unitText(const ScanReport& r) {
  if (r.unit.empty()) return Words::tr("in units of %1 mm").arg(r.millimetres);
  return (r.unitRecognised ? Words::tr("in %1, recognised by the size of the head") : Words::tr("in %1, as chosen"))
      .arg(QString::fromStdString(r.unit));
}

ScanReportLine meshLine(const ScanReport& r) {
  const QString parts = r.droppedParts > 0 ? Words::tr("; %1 loose parts left out").arg(r.droppedParts) : QString();
  return {
      Words::tr("Mesh"),
      Words::tr("%1; %2 triangles, %3 holes or open edges").arg(unitText(r)).arg(r.triangles).arg(r.holes) + parts,
      Words::tr("1 unit of the file is %1 mm; the outer corners of the eyes are then %2 mm apart. %3 of %4 parts left "
                "out, %5 vertices merged, %6 triangles without area taken away")
          .arg(r.millimetres)
          .arg(fixed(r.eyes, 1))
          .arg(r.droppedParts)
          .arg(r.parts)
          .arg(r.mergedVertices)
          .arg(r.degenerateTriangles)};
}

QString fitDetail(const ScanReport& r) {
  return Words::tr(
             "Before it is bent, the generic face lies %1 mm RMS from the scan, at %2 of its size; the reliefs agree "
             "by %3 of 1")
      .arg(fixed(r.fitDistance, 2), fixed(r.fitSize, 2), fixed(r.fitRelief, 2));
}

ScanReportLine landmarkLine(const ScanReport& r) {
  QString value = r.landmarksGiven ? Words::tr("from the file, %1 mm off the skin").arg(fixed(r.landmarkDepth, 2))
                                   : Words::tr("found with a generic face, %1 mm RMS off").arg(fixed(r.fitDistance, 2));
  if (r.completedLandmarks > 0) value += Words::tr("; %1 of 68 from a generic face").arg(r.completedLandmarks);
  QString detail = r.fitted ? fitDetail(r) : Words::tr("Off the skin: the median of all landmarks");
  if (r.fitted && r.landmarksGiven)
    detail += Words::tr(". Landmarks found without the file lie %1 mm RMS from these, at most %2 mm")
                  .arg(fixed(r.landmarkRMS, 2), fixed(r.landmarkMaximum, 2));
  if (r.facePart > 0 && r.droppedParts > 0) {
    value += Words::tr("; on part %1 of %2, larger ones left out").arg(r.facePart + 1).arg(r.parts);
    detail += Words::tr(". Parts are counted by area, the largest first; mien acquire --all-parts keeps all");
  }
  return {Words::tr("Landmarks"), value, detail};
}

}  // namespace

QString ScanReportLine::text() const {
  return name.leftJustified(nameLetters) + value;
}

std::vector<ScanReportLine> scanReportLines(const AcquireResult& result) {
  const QString names = QString::fromStdString(result.crossingCurves);
  return {meshLine(result.report),
          poseLine(result.report),
          landmarkLine(result.report),
          {Words::tr("Distance"),
           Words::tr("the curves' face lies %1 mm RMS from the scan, %2 mm at most")
               .arg(fixed(result.frontalRMS, 2), fixed(result.frontalMaximum, 2)),
           Words::tr("Of the spline surface of these curves, in front of z = 50 mm")},
          {Words::tr("Crossings"),
           result.crossings == 0 ? Words::tr("no two curves cross")
                                 : Words::tr("%1 between curves: %2").arg(result.crossings).arg(names),
           Words::tr("Where two curves cross, the surface between them folds")}};
}

}  // namespace mien
