#pragma once

#include "SeamMeasures.h"

namespace mien {

/// Largest and mean measures over many samples of seams, every sample weighing the same.
///
/// Undefined measures (NaN) are left out; a measure that is defined nowhere, as all are without samples, stays NaN.
class SeamSummary {
 public:
  SeamSummary();

  void add(const SeamMeasures& sample);
  void add(const SeamSummary& other);

  int count() const { return count_; }
  const SeamMeasures& max() const { return max_; }
  SeamMeasures mean() const;

 private:
  int count_ = 0;
  SeamMeasures max_, sum_, defined_;  ///< `defined_` counts the samples where a measure is defined
};

}  // namespace mien
