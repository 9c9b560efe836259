#include "VectorSampling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "NumberText.h"

namespace mien {

namespace {

using Places = Eigen::Matrix<double, Eigen::Dynamic, 2>;

constexpr double closest = 0.75;   // of the spacing: vertices near neighbouring points of the lattice both are kept
constexpr double peakShare = 0.5;  // of the longest
constexpr double latticeRounding = 1e-6;  // of the spacing: mirrored vertices are equally far from the lattice

/// Distance to the nearest point of the hexagonal lattice with rows along the first axis and a point at the origin.
double distanceToLattice(const Eigen::Vector2d& place, double spacing) {
  const double height = spacing * std::sqrt(0.75);
  const double row = std::floor(place[1] / height);
  double least = 1e300;
  for (const double candidate : {row, row + 1.0}) {
    const double shift = std::fmod(std::abs(candidate), 2.0) * 0.5 * spacing;
    const double x = std::remainder(place[0] - shift, spacing);
    least = std::min(least, std::hypot(x, place[1] - candidate * height));
  }
  return least;
}

/// Vertices already chosen, found by where they are.
class ChosenPlaces {
 public:
  ChosenPlaces(const Places& places, double spacing) : places_(places), spacing_(spacing) {}

  bool hasNear(int vertex) const {
    const auto [x, y] = cellOf(vertex);
    for (long long i = x - 1; i <= x + 1; ++i)
      for (long long j = y - 1; j <= y + 1; ++j) {
        const auto found = cells_.find({i, j});
        if (found == cells_.end()) continue;
        for (const int other : found->second)
          if ((places_.row(other) - places_.row(vertex)).norm() < spacing_ * (1.0 - latticeRounding)) return true;
      }
    return false;
  }

  void add(int vertex) { cells_[cellOf(vertex)].push_back(vertex); }

 private:
  std::pair<long long, long long> cellOf(int vertex) const {
    return {std::llround(places_(vertex, 0) / spacing_), std::llround(places_(vertex, 1) / spacing_)};
  }

  const Places& places_;
  double spacing_;
  std::map<std::pair<long long, long long>, std::vector<int>> cells_;
};

/// The candidates that are longer than all others within the spacing, and not short beside the longest.
std::vector<int> peaks(std::vector<int> candidates, const Places& places, double spacing,
                       const Eigen::VectorXd& lengths) {
  std::stable_sort(candidates.begin(), candidates.end(), [&](int a, int b) { return lengths[a] > lengths[b]; });
  ChosenPlaces longer(places, spacing);
  std::vector<int> found;
  for (const int vertex : candidates) {
    if (!(lengths[vertex] > 0.0) || lengths[vertex] < peakShare * lengths[candidates.front()]) break;
    if (!longer.hasNear(vertex)) found.push_back(vertex);
    longer.add(vertex);
  }
  return found;
}

std::vector<int> evenly(const std::vector<int>& candidates, const Places& places, double spacing,
                        const Eigen::VectorXd& lengths) {
  std::vector<std::pair<double, int>> order;
  if (lengths.size() > 0)
    for (const int vertex : peaks(candidates, places, spacing, lengths)) order.emplace_back(-1.0, vertex);
  for (const int vertex : candidates) {
    const double distance = distanceToLattice(places.row(vertex), spacing) / spacing;
    order.emplace_back(std::round(distance / latticeRounding), vertex);
  }
  std::sort(order.begin(), order.end());
  ChosenPlaces near(places, closest * spacing);
  std::vector<int> chosen;
  for (const auto& [distance, vertex] : order) {
    if (near.hasNear(vertex)) continue;
    near.add(vertex);
    chosen.push_back(vertex);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace

std::string VectorSampling::parse(const std::string& text) {
  if (text == "auto") {
    kind = Kind::Automatic;
    return {};
  }
  const size_t colon = text.find(':');
  const std::string kindName = text.substr(0, colon);
  std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kindName == "even" && value.size() > 2 && value.substr(value.size() - 2) == "mm") value.resize(value.size() - 2);
  const auto number = parseNumber(value);
  if ((kindName != "every" && kindName != "even") || !number)
    return "sampling '" + text + "' is unknown; write auto, every:N (every N-th vertex) or even:SPACING (mm)";
  if (kindName == "every" && !(*number >= 1.0 && *number <= largestStep && std::floor(*number) == *number))
    return "sampling '" + text + "' counts no vertices; N is a whole number from 1 up";
  if (kindName == "even" && !(*number >= leastSpacing && *number <= largestSpacing))
    return "sampling '" + text + "' has a spacing outside 0.1 .. 1000 mm";
  kind = kindName == "every" ? Kind::Every : Kind::Even;
  if (kind == Kind::Every) step = static_cast<int>(*number);
  if (kind == Kind::Even) spacing = *number;
  return {};
}

std::string VectorSampling::text() const {
  if (kind == Kind::Automatic) return "auto";
  std::string number;
  appendNumber(number, kind == Kind::Every ? step : spacing);
  return (kind == Kind::Every ? "every:" : "even:") + number;
}

std::string VectorSampling::description() const {
  if (kind == Kind::Even) return "vectors " + text().substr(5) + " mm apart";
  return kind == Kind::Automatic || step == 1 ? "all vertices" : "one of " + std::to_string(step) + " vertices";
}

std::vector<int> VectorSampling::choose(const std::vector<int>& candidates, const Places& places, int columns,
                                        const Eigen::VectorXd& lengths) const {
  if (kind == Kind::Even) return evenly(candidates, places, spacing, lengths);
  if (kind == Kind::Automatic) return candidates;
  const auto isLeftOut = [&](int vertex) {
    const int row = columns > 0 ? vertex / columns : 0, column = columns > 0 ? vertex % columns : vertex;
    return (column + row) % step != 0;
  };
  std::vector<int> chosen;
  std::remove_copy_if(candidates.begin(), candidates.end(), std::back_inserter(chosen), isLeftOut);
  return chosen;
}

}  // namespace mien
