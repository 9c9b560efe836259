#pragma once

#include <vector>

#include "TableFit.h"

namespace mien {

/// A sample that moves otherwise than those around it.
struct SampleOutlier {
  int sample = 0;           ///< row of the samples
  double difference = 0.0;  ///< of its displacement from the median of its neighbours', pupil units
};

/// Samples whose displacement differs by more than 0.3 pupil units, and by more than six robust standard deviations of
/// all such differences, from the median of the six nearest samples of its region (of all where the region has fewer
/// than five): a marker that was mistaken for another. Worst first.
std::vector<SampleOutlier> sampleOutliers(const TableSamples& samples);

}  // namespace mien
