#include "VectorPicture.h"

#include <algorithm>

#include "ContourSight.h"
#include "SurfaceContour.h"
#include "SurfaceOcclusion.h"
#include "VectorScale.h"

namespace mien {

namespace {

constexpr double lift = 0.4;            // mm: lines are looked for a little above the surface they lie on
constexpr double shortestGap = 6.0;     // mm
constexpr double shortestPart = 8.0;    // mm
constexpr double bridge = 6.0;          // mm: ends of an outline that are nearer are one place
constexpr double longestSliver = 60.0;  // mm: of a line that goes on at both ends of it
constexpr double frameMargin = 0.04;    // of a region's longer side

using Line = VectorPicture::Line;
using Places = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Turns runs of `value` inside a line that are shorter than `least` (mm) around.
void turnShortRuns(const Places& places, bool value, double least, std::vector<bool>& seen) {
  const int count = static_cast<int>(seen.size());
  for (int begin = 0, end = 0; begin < count; begin = end) {
    double length = 0.0;
    for (end = begin; end < count && seen[end] == seen[begin]; ++end)
      if (end + 1 < count) length += (places.row(end + 1) - places.row(end)).norm();
    const bool whole = begin == 0 && end == count;
    if (seen[begin] == value && !whole && length < least) std::fill(seen.begin() + begin, seen.begin() + end, !value);
  }
}

/// Runs that are seen but not kept, with kept ones at both of their ends, are kept where they are short.
void keepPassing(const Places& places, const std::vector<bool>& seen, std::vector<bool>& kept) {
  const std::vector<bool> before = kept;
  const int count = static_cast<int>(seen.size());
  for (int begin = 0, end = 0; begin < count; begin = end) {
    double length = 0.0;
    for (end = begin + 1; end < count && !before[begin] && !before[end] && seen[end]; ++end)
      length += (places.row(end) - places.row(end - 1)).norm();
    const bool passes = begin > 0 && before[begin - 1] && end < count && before[end];
    if (seen[begin] && !before[begin] && passes && length < longestSliver)
      std::fill(kept.begin() + begin, kept.begin() + end, true);
  }
}

/// Appends the parts of a line that are seen. Near a cusp a line flickers between seen and hidden: gaps are closed and
/// crumbs left out.
void appendParts(const Places& places, std::vector<bool> seen, std::vector<Line>& parts) {
  turnShortRuns(places, false, shortestGap, seen);
  turnShortRuns(places, true, shortestPart, seen);
  const int count = static_cast<int>(seen.size());
  for (int begin = 0, end = 0; begin < count; begin = end + 1) {
    for (end = begin; end < count && seen[end];) ++end;
    if (end - begin > 1) parts.push_back(places.middleRows(begin, end - begin));
  }
}

/// The nearer of a line's ends to a place, turned so that it is the last.
Line endingNear(const Line& line, const Eigen::RowVector2d& place) {
  const bool first = (line.row(0) - place).norm() < (line.row(line.rows() - 1) - place).norm();
  return first ? Line(line.colwise().reverse()) : line;
}

bool isClosed(const Line& line) {
  return line.row(0) == line.row(line.rows() - 1);
}

/// Joins lines whose ends nearly meet: one contour that goes on in front of another.
void joinNearEnds(std::vector<Line>& lines) {
  for (size_t i = 0; i < lines.size(); ++i)
    for (size_t k = i + 1; k < lines.size(); ++k)
      for (const int end : {0, static_cast<int>(lines[i].rows()) - 1}) {
        const Eigen::RowVector2d place = lines[i].row(end);
        const Line other = endingNear(lines[k], place);
        if (isClosed(lines[i]) || isClosed(other)) continue;
        if ((other.row(other.rows() - 1) - place).norm() > bridge) continue;
        const Line one = end == 0 ? lines[i] : Line(lines[i].colwise().reverse());
        Line both(other.rows() + one.rows(), 2);
        both << other, one;
        lines[i] = both;
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
        k = i;  // all others again, as the ends are new
        break;
      }
}

class PictureMaker {
 public:
  PictureMaker(const MotionField& field, const VectorPictureOptions& options)
      : field_(field), options_(options), occlusion_(field.surface, options.plane), places_(projected(field.origins)) {}

  VectorPicture make() {
    if (options_.lines) addLines();
    findCandidates();
    chooseFrame();
    addArrows();
    return std::move(picture_);
  }

 private:
  Places projected(const MotionField::Points& points) const {
    Places places(points.rows(), 2);
    places << points * options_.plane.right, points * options_.plane.up;
    return places;
  }

  bool isSeen(int index) const {
    if (options_.hidden) return true;
    const Eigen::Vector3d origin = field_.origins.row(index);
    if (field_.normals.rows() == 0) return !occlusion_.hides(origin);
    const Eigen::Vector3d normal = field_.normals.row(index);
    return normal.dot(options_.plane.out) > 0.0 && !occlusion_.hides(origin + lift * normal);
  }

  void addLine(const MotionField::Points& points, const MotionField::Points& lifted, std::vector<Line>& lines) const {
    std::vector<bool> seen(points.rows());
    for (size_t i = 0; i < seen.size(); ++i) seen[i] = !occlusion_.hides(lifted.row(i).transpose());
    appendParts(projected(points), seen, lines);
  }

  /// The edges of slivers are left out at the ends of what is seen; a line that passes close behind another, as a cheek
  /// behind the nose, stays whole.
  void addContour(const ContourLine& line) {
    const ContourSight sight(occlusion_, options_.plane);
    std::vector<bool> seen(line.points.rows()), kept(line.points.rows());
    for (size_t i = 0; i < seen.size(); ++i) {
      const Eigen::Vector3d point = line.points.row(i), inward = line.inwards.row(i);
      seen[i] = !occlusion_.hides(point + lift * line.normals.row(i).transpose()) && !sight.isDoubled(point, inward);
      kept[i] = seen[i] && !sight.isSliver(point, inward);
    }
    const Places places = projected(line.points);
    turnShortRuns(places, true, shortestPart, kept);
    keepPassing(places, seen, kept);
    appendParts(places, kept, picture_.outline);
  }

  void addLines() {
    const TriangleMesh& surface = field_.surface;
    for (const auto& lines :
         {silhouettes(surface, field_.surfaceNormals, options_.plane), borders(surface, field_.surfaceNormals)})
      for (const ContourLine& line : lines) addContour(line);
    joinNearEnds(picture_.outline);
    for (const MotionField::Points& seam : field_.seams) addLineAbove(seam, picture_.seams);
    for (const MotionField::Points& line : field_.landmarks) addLineAbove(line, picture_.landmarks);
  }

  void addLineAbove(const MotionField::Points& line, std::vector<Line>& lines) const {
    addLine(line, line.rowwise() + lift * options_.plane.out.transpose(), lines);
  }

  void findCandidates() {
    for (int i = 0; i < field_.origins.rows(); ++i)
      if (options_.region.contains(field_, i, options_.plane) && isSeen(i)) candidates_.push_back(i);
    for (const int i : candidates_) picture_.tails.extend(Eigen::Vector2d(places_.row(i)));
  }

  void chooseSampling() {
    picture_.sampling = options_.sampling;
    if (picture_.sampling.kind != VectorSampling::Kind::Automatic) return;
    picture_.sampling.kind = VectorSampling::Kind::Even;
    const Eigen::Vector2d size = picture_.frame.isEmpty() ? Eigen::Vector2d(1.0, 1.0) : picture_.frame.sizes();
    const double faceScale = (options_.paper.array() / size.array().max(1e-6)).minCoeff();
    picture_.sampling.spacing = std::max(VectorSampling::leastSpacing, automaticSpacing(printedSpacing, faceScale));
  }

  void addArrows() {
    chooseSampling();
    const Places moves = projected(field_.vectors);
    const Eigen::VectorXd magnitudes = field_.magnitudes();
    picture_.chosen = picture_.sampling.choose(candidates_, places_, field_.columns, magnitudes);
    for (const int i : picture_.chosen) {
      const double towards = field_.vectors.row(i).dot(options_.plane.out);
      if (magnitudes[i] > leastMotion)
        picture_.arrows.push_back({places_.row(i), moves.row(i), magnitudes[i], towards, i});
      else
        ++picture_.still;
    }
    std::stable_sort(picture_.arrows.begin(), picture_.arrows.end(),
                     [](const PictureArrow& a, const PictureArrow& b) { return a.magnitude < b.magnitude; });
  }

  void chooseFrame() {
    const VectorRegion& region = options_.region;
    picture_.frame = picture_.tails;
    if (region.rectangle) picture_.frame = *region.rectangle;
    const bool whole = region.isWhole() || options_.wholeFrame || picture_.frame.isEmpty();
    if (whole)
      for (const auto* lines : {&picture_.outline, &picture_.seams})
        for (const Line& line : *lines)
          for (int i = 0; i < line.rows(); ++i) picture_.frame.extend(Eigen::Vector2d(line.row(i)));
    if (whole || region.rectangle || picture_.frame.isEmpty()) return;
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(frameMargin * picture_.frame.sizes().maxCoeff() + 1.0);
    picture_.frame = Eigen::AlignedBox2d(picture_.frame.min() - margin, picture_.frame.max() + margin);
  }

  const MotionField& field_;
  const VectorPictureOptions& options_;
  SurfaceOcclusion occlusion_;
  Places places_;                ///< of the vectors' origins in the picture
  std::vector<int> candidates_;  ///< vectors of the region that are seen
  VectorPicture picture_;
};

}  // namespace

double VectorPicture::longest() const {
  double longest = 0.0;
  for (const PictureArrow& arrow : arrows) longest = std::max(longest, arrow.vector.norm());
  return longest;
}

double VectorPicture::largest() const {
  return arrows.empty() ? 0.0 : arrows.back().magnitude;
}

VectorPicture drawnVectors(const MotionField& field, const VectorPictureOptions& options) {
  return PictureMaker(field, options).make();
}

}  // namespace mien
