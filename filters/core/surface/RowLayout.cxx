#include "RowLayout.h"

#include <algorithm>
#include <cmath>

#include "FaceLayout.h"

namespace mien {

namespace {

constexpr int lastPatchAboveMouth = 6;
constexpr int curveIntervalsPerPatch = FaceLayout::curvesPerPatch - 1;

bool liesOnCurve(const FaceRow& row, int patch, int position) {
  return row.patch == patch && std::abs(row.u * curveIntervalsPerPatch - position) < 1e-9;
}

}  // namespace

RowLayout::RowLayout(int rowCount, bool uniform) {
  if (uniform)
    spreadUniformly(rowCount);
  else
    dealEvenly(rowCount);
}

void RowLayout::add(int patch, double u) {
  rows_.push_back({patch, u, (patch + u) / FaceLayout::patchCount});
}

// A seam belongs to the patch above it. Patch p ends after floor((p + 1) intervals / 9) intervals.
void RowLayout::dealEvenly(int rowCount) {
  const int intervals = rowCount - 2;
  add(0, 0.0);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    const int begin = patch * intervals / FaceLayout::patchCount;
    const int end = (patch + 1) * intervals / FaceLayout::patchCount;
    if (patch == lastPatchAboveMouth + 1) add(patch, 0.0);
    for (int i = 1; i <= end - begin; ++i) add(patch, static_cast<double>(i) / (end - begin));
    if (patch == lastPatchAboveMouth) upperLipRow_ = static_cast<int>(rows_.size()) - 1;
  }
}

void RowLayout::spreadUniformly(int rowCount) {
  const int intervals = rowCount - 2;
  const double lips = lastPatchAboveMouth + 1.0;
  const int nearestToLips = static_cast<int>(std::lround(lips / FaceLayout::patchCount * intervals));
  for (int i = 0; i <= intervals; ++i) {
    if (i == nearestToLips) {
      add(lastPatchAboveMouth, 1.0);
      upperLipRow_ = static_cast<int>(rows_.size()) - 1;
      add(lastPatchAboveMouth + 1, 0.0);
      continue;
    }
    const double u = static_cast<double>(i) * FaceLayout::patchCount / intervals;
    const int patch = std::clamp(static_cast<int>(std::ceil(u - 1e-12)) - 1, 0, FaceLayout::patchCount - 1);
    add(patch, u - patch);
  }
}

std::vector<std::string> RowLayout::missedCurves() const {
  std::vector<std::string> missed;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    const bool startsChain = patch == 0 || patch == lastPatchAboveMouth + 1;
    for (int position = startsChain ? 0 : 1; position < FaceLayout::curvesPerPatch; ++position)
      if (std::none_of(rows_.begin(), rows_.end(),
                       [&](const FaceRow& row) { return liesOnCurve(row, patch, position); }))
        missed.push_back(FaceLayout::curveName(FaceLayout::firstCurve[patch] + position));
  }
  return missed;
}

}  // namespace mien
