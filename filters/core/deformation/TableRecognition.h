#pragma once

#include <array>
#include <string>
#include <vector>

#include "TableFit.h"

namespace mien {

/// The largest displacement (pupil units; 0.3 mm) below which the nearest expression means nothing.
constexpr double leastRecognisedMovement = 0.01;

/// How near a recording is to an expression, and where the two differ most.
struct RecognitionScore {
  int expression = 0;      ///< index of the mean
  double distance = 0.0;   ///< root mean square of the movement that the mean does not explain, pupil units
  double intensity = 1.0;  ///< of the mean that suits the recording best, 0.5 .. 1.5
  std::array<double, FacialRegions::count> regions{};  ///< the distance in each region alone; 0 without points
};

/// Scores a recording against the mean tables of expressions, nearest first: each mean predicts how the recording's own
/// points move, at the intensity that suits it best, and what is left is measured. Of a shift, rotation and scale of
/// the whole face in the plane as much is taken out as pupils that were seen 0.05 beside their place explain. Regions
/// that a mean does not know are left out for all of them.
/// @return nothing, or one sentence that says what is missing
std::string recognise(const TableSamples& samples, const std::vector<DeformationTable>& means,
                      std::vector<RecognitionScore>& scores);

/// The same for a table alone, at points around the regions' centres.
std::string recognise(const DeformationTable& table, const FacialRegions& regions,
                      const std::vector<DeformationTable>& means, std::vector<RecognitionScore>& scores);

/// The regions that speak most for the nearest against the second nearest mean, most decisive first.
std::vector<int> decisiveRegions(const std::vector<RecognitionScore>& scores, int count = 3);

}  // namespace mien
