#include "SeamSummary.h"

#include <cmath>
#include <limits>

namespace mien {

namespace {

constexpr double SeamMeasures::*allMeasures[] = {&SeamMeasures::g0, &SeamMeasures::g1, &SeamMeasures::c1,
                                                 &SeamMeasures::g2, &SeamMeasures::c2};

}  // namespace

SeamSummary::SeamSummary() {
  for (const auto measure : allMeasures) max_.*measure = std::numeric_limits<double>::quiet_NaN();
}

void SeamSummary::add(const SeamMeasures& sample) {
  ++count_;
  for (const auto measure : allMeasures) {
    if (std::isnan(sample.*measure)) continue;
    max_.*measure = std::fmax(max_.*measure, sample.*measure);
    sum_.*measure += sample.*measure;
    defined_.*measure += 1.0;
  }
}

void SeamSummary::add(const SeamSummary& other) {
  count_ += other.count_;
  for (const auto measure : allMeasures) {
    max_.*measure = std::fmax(max_.*measure, other.max_.*measure);
    sum_.*measure += other.sum_.*measure;
    defined_.*measure += other.defined_.*measure;
  }
}

SeamMeasures SeamSummary::mean() const {
  SeamMeasures mean;
  for (const auto measure : allMeasures) mean.*measure = sum_.*measure / defined_.*measure;
  return mean;
}

}  // namespace mien
