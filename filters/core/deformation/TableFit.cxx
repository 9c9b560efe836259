#include "TableFit.h"

#include <algorithm>
#include <cmath>

#include "FaceSides.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double largestMovement = 4.0;  // of a point, pupil units; a jaw drops by two
constexpr const char* mistakenUnits =
    "; the pupils and the points of both states must be in one unit, and the points the same ones";

std::string listed(const std::vector<int>& regions) {
  std::string text = regions.size() == 1 ? "region " : "regions ";
  for (std::size_t i = 0; i < regions.size(); ++i) text += (i ? ", " : "") + std::to_string(regions[i]);
  return text;
}

/// The identity for a region without points.
QuadraticFit fitRegion(const TableSamples& samples, int region, double noise) {
  const Eigen::Index count = std::count(samples.regions.begin(), samples.regions.end(), region);
  if (count == 0) return {};
  PlanePoints before(count, 2), after(count, 2);
  for (std::size_t i = 0, row = 0; i < samples.regions.size(); ++i) {
    if (samples.regions[i] != region) continue;
    before.row(row) = samples.before.row(i);
    after.row(row++) = samples.after.row(i);
  }
  return fitQuadraticMap(before, after, noise);
}

/// Standard deviation of a coordinate about the maps, over the regions that determine their maps.
double noiseOf(const std::array<QuadraticFit, FacialRegions::count>& regions) {
  double squares = 0.0;
  int freedom = 0;
  for (const QuadraticFit& region : regions) {
    if (region.sparse()) continue;
    squares += region.points * region.rms * region.rms;
    freedom += 2 * (region.points - region.rank);
  }
  return freedom > 0 ? std::sqrt(squares / freedom) : 0.0;
}

std::string describeFault(const TableSamples& samples, const FitOptions& options) {
  if (!samples.before.allFinite() || !samples.after.allFinite()) return "a point is not finite; remove it";
  if (samples.regions.empty()) return "there is no point besides the pupils; give more markers";
  std::vector<int> empty;
  for (int region = 1; region <= FacialRegions::count; ++region)
    if (std::find(samples.regions.begin(), samples.regions.end(), region) == samples.regions.end())
      empty.push_back(region);
  return empty.empty() || (options.allowEmpty && !options.strict)
             ? ""
             : "no point lies in " + listed(empty) + "; every region needs one at least, better ten";
}

std::vector<int> chosenRegions(const std::array<QuadraticFit, FacialRegions::count>& regions,
                               bool (*chosen)(const QuadraticFit&)) {
  std::vector<int> numbers;
  for (int region = 1; region <= FacialRegions::count; ++region)
    if (chosen(regions[region - 1])) numbers.push_back(region);
  return numbers;
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
    samples.regions.push_back(marker.region
                                  ? marker.region
                                  : regions.nearest(samples.before.row(i), landmarkSide(landmarkNumber(marker.name))));
  }
  return samples;
}

std::vector<int> TableFit::sparseRegions() const {
  return chosenRegions(regions, [](const QuadraticFit& fit) { return fit.points > 0 && fit.sparse(); });
}

std::vector<int> TableFit::emptyRegions() const {
  return chosenRegions(regions, [](const QuadraticFit& fit) { return fit.points == 0; });
}

std::string TableFit::warning() const {
  const std::vector<int> sparse = this->sparseRegions(), empty = this->emptyRegions();
  std::string text;
  if (!empty.empty()) text = listed(empty) + (empty.size() == 1 ? " has" : " have") + " no point and will not move";
  if (!sparse.empty())
    text += (text.empty() ? "" : "; ") + listed(sparse) + (sparse.size() == 1 ? " has" : " have") +
            " fewer than 6 independent points and " + (sparse.size() == 1 ? "leans" : "lean") + " on an affine fit";
  return text.empty() ? text : text + "; add markers there";
}

std::string TableFit::fit(const TableSamples& samples, const FitOptions& options) {
  const std::string fault = describeFault(samples, options);
  if (!fault.empty()) return fault;
  TableFit result;
  for (int i = 0; i < FacialRegions::count; ++i) result.regions[i] = fitRegion(samples, i + 1, 0.0);
  result.noise = noiseOf(result.regions);
  double squares = 0.0;
  for (int i = 0; i < FacialRegions::count; ++i) {
    QuadraticFit& region = result.regions[i];
    if (region.weak() && region.points > 0) region = fitRegion(samples, i + 1, result.noise);
    result.table.maps[i] = region.map;
    result.table.largestDisplacement = std::max(result.table.largestDisplacement, region.largestDisplacement);
    squares += region.points * region.rms * region.rms;
  }
  if (!result.emptyRegions().empty()) {
    result.table.counts.emplace();
    for (int i = 0; i < FacialRegions::count; ++i) result.table.counts->at(i) = result.regions[i].points > 0;
  }
  result.rms = std::sqrt(squares / double(samples.regions.size()));
  const std::string excess = result.table.describeExcess();
  if (!excess.empty()) return excess + mistakenUnits;
  if (result.table.largestDisplacement > largestMovement)
    return "a point moves by " + roundedText(result.table.largestDisplacement) +
           " pupil units, further than any face reaches" + mistakenUnits;
  if (options.strict && !result.sparseRegions().empty()) return result.warning();
  *this = result;
  return {};
}

}  // namespace mien
