#include "TableFit.h"

#include "NumberText.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

/// 1 for the upper lip's landmarks between the mouth corners, -1 for the lower lip's, 0 for every other marker.
LipSide lipSideOf(const std::string& name) {
  if (name.rfind("landmark", 0) != 0) return 0.0;
  const auto number = parseWholeNumber(std::string_view(name).substr(8));
  if (!number) return 0.0;
  const auto within = [&](int first, int last) { return *number >= first && *number <= last; };
  if (within(49, 53) || within(61, 63)) return 1.0;
  return within(55, 59) || within(65, 67) ? -1.0 : 0.0;
}

std::string listed(const std::vector<int>& regions) {
  std::string text = regions.size() == 1 ? "region " : "regions ";
  for (std::size_t i = 0; i < regions.size(); ++i) text += (i ? ", " : "") + std::to_string(regions[i]);
  return text;
}

QuadraticFit fitRegion(const TableSamples& samples, int region) {
  const Eigen::Index count = std::count(samples.regions.begin(), samples.regions.end(), region);
  PlanePoints before(count, 2), after(count, 2);
  for (std::size_t i = 0, row = 0; i < samples.regions.size(); ++i) {
    if (samples.regions[i] != region) continue;
    before.row(row) = samples.before.row(i);
    after.row(row++) = samples.after.row(i);
  }
  return fitQuadraticMap(before, after);
}

std::string describeFault(const TableSamples& samples) {
  if (!samples.before.allFinite() || !samples.after.allFinite()) return "a point is not finite; remove it";
  std::vector<int> empty;
  for (int region = 1; region <= FacialRegions::count; ++region)
    if (std::find(samples.regions.begin(), samples.regions.end(), region) == samples.regions.end())
      empty.push_back(region);
  return empty.empty() ? "" : "no point lies in " + listed(empty) + "; every region needs one at least, better ten";
}

}  // namespace

TableSamples samplesOf(const MarkerTable& markers, const FacialRegions& regions) {
  TableSamples samples;
  const Eigen::Index count = static_cast<Eigen::Index>(markers.markers.size());
  samples.before.resize(count, 2);
  samples.after.resize(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Marker& marker = markers.markers[i];
    samples.before.row(i) = markers.neutral.apply(marker.neutral).head<2>();
    samples.after.row(i) = markers.expression.apply(marker.expression).head<2>();
    samples.regions.push_back(
        marker.region ? marker.region : regions.nearest(samples.before.row(i), lipSideOf(marker.name)));
  }
  return samples;
}

std::vector<int> TableFit::sparseRegions() const {
  std::vector<int> sparse;
  for (int region = 1; region <= FacialRegions::count; ++region)
    if (regions[region - 1].sparse()) sparse.push_back(region);
  return sparse;
}

std::string TableFit::fit(const TableSamples& samples, bool strict) {
  const std::string fault = describeFault(samples);
  if (!fault.empty()) return fault;
  TableFit result;
  double squares = 0.0;
  for (int i = 0; i < FacialRegions::count; ++i) {
    const QuadraticFit& region = result.regions[i] = fitRegion(samples, i + 1);
    result.table.maps[i] = region.map;
    result.table.largestDisplacement = std::max(result.table.largestDisplacement, region.largestDisplacement);
    squares += region.points * region.rms * region.rms;
  }
  result.rms = std::sqrt(squares / double(samples.regions.size()));
  const std::vector<int> sparse = result.sparseRegions();
  if (strict && !sparse.empty()) return listed(sparse) + " has fewer than 6 independent points; add markers there";
  *this = result;
  return {};
}

}  // namespace mien
