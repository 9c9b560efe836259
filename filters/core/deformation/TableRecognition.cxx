#include "TableRecognition.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mien {

namespace {

constexpr double weakest = 0.5, strongest = 1.5;
constexpr double reach = 0.4, step = 0.1;  // of the points that stand for a region, pupil units

/// Takes shift, rotation and scale of the whole face out of displacements, by a ridge of strength 1: a pupil is seen as
/// far beside its place as any other point.
class HeadMovement {
 public:
  explicit HeadMovement(const PlanePoints& points) : design_(2 * points.rows(), 4) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      design_.row(2 * i) << 1.0, 0.0, points(i, 0), -points(i, 1);
      design_.row(2 * i + 1) << 0.0, 1.0, points(i, 1), points(i, 0);
    }
    normal_.compute(design_.transpose() * design_ + Eigen::Matrix4d::Identity());
  }

  Eigen::VectorXd without(const PlanePoints& displacements) const {
    const Eigen::Map<const Eigen::VectorXd> all(displacements.data(), displacements.size());
    return all - design_ * normal_.solve(design_.transpose() * all);
  }

 private:
  Eigen::Matrix<double, Eigen::Dynamic, 4> design_;
  Eigen::LLT<Eigen::Matrix4d> normal_;
};

PlanePoints predicted(const TableSamples& samples, const DeformationTable& mean) {
  PlanePoints result(samples.before.rows(), 2);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    const Eigen::Vector2d point = samples.before.row(i);
    result.row(i) = (mean.maps[samples.regions[i] - 1].apply(point) - point).transpose();
  }
  return result;
}

RecognitionScore score(const TableSamples& samples, const Eigen::VectorXd& seen, const Eigen::VectorXd& expected) {
  RecognitionScore result;
  const double size = expected.squaredNorm();
  if (size > 0.0) result.intensity = std::clamp(seen.dot(expected) / size, weakest, strongest);
  const Eigen::VectorXd rest = seen - result.intensity * expected;
  std::array<int, FacialRegions::count> points{};
  for (std::size_t i = 0; i < samples.regions.size(); ++i) {
    result.regions[samples.regions[i] - 1] += rest.segment<2>(2 * i).squaredNorm();
    ++points[samples.regions[i] - 1];
  }
  for (int i = 0; i < FacialRegions::count; ++i)
    if (points[i]) result.regions[i] = std::sqrt(result.regions[i] / points[i]);
  result.distance = std::sqrt(2.0 * rest.squaredNorm() / double(rest.size()));
  return result;
}

/// The movement of a table at points around the centres.
TableSamples samplesOf(const DeformationTable& table, const FacialRegions& regions) {
  std::vector<Eigen::Vector2d> points;
  TableSamples samples;
  const int most = static_cast<int>(reach / step);
  for (int region = 1; region <= FacialRegions::count; ++region)
    for (int x = table.knows(region) ? -most : most + 1; x <= most; ++x)
      for (int y = -most; y <= most; ++y) {
        if (x * x + y * y > most * most) continue;
        points.push_back(regions.centre(region) + step * Eigen::Vector2d(x, y));
        samples.regions.push_back(region);
      }
  samples.before.resize(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) samples.before.row(i) = points[i].transpose();
  samples.after = samples.before + predicted(samples, table);
  return samples;
}

/// The points in regions that all tables know, so that each is compared over the same ones.
TableSamples knownTo(const std::vector<DeformationTable>& tables, const TableSamples& samples) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < samples.regions.size(); ++i)
    if (std::all_of(tables.begin(), tables.end(), [&](const auto& table) { return table.knows(samples.regions[i]); }))
      rows.push_back(static_cast<int>(i));
  TableSamples known;
  known.before.resize(rows.size(), 2);
  known.after.resize(rows.size(), 2);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    known.before.row(i) = samples.before.row(rows[i]);
    known.after.row(i) = samples.after.row(rows[i]);
    known.regions.push_back(samples.regions[rows[i]]);
  }
  return known;
}

}  // namespace

std::string recognise(const TableSamples& all, const std::vector<DeformationTable>& means,
                      std::vector<RecognitionScore>& scores) {
  if (means.empty()) return "there is no table to compare with; give the mean tables of the expressions";
  if (all.regions.empty()) return "there are no points to compare; give markers before and after";
  const TableSamples samples = knownTo(means, all);
  if (samples.regions.empty())
    return "no region with points is known to all tables it is compared with; give tables of the same regions";
  const HeadMovement movement(samples.before);
  const Eigen::VectorXd seen = movement.without(samples.after - samples.before);
  scores.clear();
  for (const DeformationTable& mean : means) {
    scores.push_back(score(samples, seen, movement.without(predicted(samples, mean))));
    scores.back().expression = static_cast<int>(scores.size()) - 1;
  }
  std::stable_sort(scores.begin(), scores.end(),
                   [](const RecognitionScore& a, const RecognitionScore& b) { return a.distance < b.distance; });
  return {};
}

std::string recognise(const DeformationTable& table, const FacialRegions& regions,
                      const std::vector<DeformationTable>& means, std::vector<RecognitionScore>& scores) {
  return recognise(samplesOf(table, regions), means, scores);
}

std::vector<int> decisiveRegions(const std::vector<RecognitionScore>& scores, int count) {
  std::vector<int> regions(FacialRegions::count);
  std::iota(regions.begin(), regions.end(), 1);
  if (scores.size() > 1) {
    const auto lead = [&](int region) {
      const double first = scores[0].regions[region - 1], second = scores[1].regions[region - 1];
      return second * second - first * first;
    };
    std::stable_sort(regions.begin(), regions.end(), [&](int a, int b) { return lead(a) > lead(b); });
  }
  regions.resize(std::min<std::size_t>(std::max(count, 0), regions.size()));
  return regions;
}

}  // namespace mien
