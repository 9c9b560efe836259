#include "RenamedChoice.h"

#include <vector>

namespace mien {

namespace {

struct RenamedChoice {
  QString list, before, now;
};

const std::vector<RenamedChoice>& renamedChoices() {
  static const std::vector<RenamedChoice> all = {
      {"colorBy", QStringLiteral("Largest curvature \u03ba1 (1/mm)"), QStringLiteral("Curvature \u03ba1 (1/mm)")},
      {"colorBy", QStringLiteral("Smallest curvature \u03ba2 (1/mm)"), QStringLiteral("Curvature \u03ba2 (1/mm)")},
      {"colorBy", "Difference of A and B (mm)", QStringLiteral("Difference A\u2013B (mm)")},
      {"continuityMeasure", "C1 jump", "C1 jump (relative)"},
      {"continuityMeasure", "C2 jump", "C2 jump (relative)"},
      {"continuityPart", "front only", "Front only"},
      {"continuityPart", "whole", "Whole"},
      {"deformationMean", "nearest mean", "Nearest mean"},
      {"faceMesh", "Shaded with mesh", "Both"},
      {"scanDistances", "not shown", "Not shown"},
      {"scanDistances", "on the face", "On the face"},
      {"scanDistances", "on the scan", "On the scan"},
      {"scanUnit", "Unit found", "Unit: automatic"},
  };
  return all;
}

}  // namespace

QString presentChoice(const QString& list, const QString& kept) {
  for (const RenamedChoice& choice : renamedChoices())
    if (choice.list == list && choice.before == kept) return choice.now;
  return kept;
}

}  // namespace mien
