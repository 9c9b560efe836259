#include "FaceWarpLayout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "AffineFit.h"
#include "FaceLayout.h"
#include "SmoothWarp.h"

namespace mien {

namespace {

using Place = FacePlace;

constexpr int paperSide = 7;
constexpr double frontal = M_PI / 2;   // to either side of the midline
constexpr double startingShare = 0.8;  // of a picture, for a face whose place is unknown

constexpr std::array<const char*, 25> featurePlaces = {"4.6",
                                                       "4.4",
                                                       "brow_middle",
                                                       "4.3",
                                                       "4.5",  //
                                                       "3.12",
                                                       "3.2",
                                                       "nose_bridge",
                                                       "3.1",
                                                       "3.7",  //
                                                       "5.4",
                                                       "3.4",
                                                       "9.12",
                                                       "3.3",
                                                       "5.3",  //
                                                       "8.4",
                                                       "8.6",
                                                       "8.1",
                                                       "8.5",
                                                       "8.3",  //
                                                       "lower_lip_right",
                                                       "8.8",
                                                       "8.2",
                                                       "8.7",
                                                       "lower_lip_left"};

constexpr std::array<const char*, 19> fineCurves = {"C1",  "C3",  "C5",  "C6",  "C8",  "C9",  "C10",
                                                    "C11", "C13", "C15", "C17", "C18", "C20", "C21",
                                                    "C22", "C23", "C24", "C26", "C28"};
constexpr int fineColumns = 21;

constexpr int numbered = 68;           // landmarks of Multi-PIE
constexpr double largestStray = 12.0;  // mm on the face between a point and where the others put it
// Where the sides are held, and within what share of the width that the features tell.
constexpr std::array<const char*, 7> sideCurves = {"C1", "C10", "C14", "C17", "C21", "C25", "C28"};
constexpr double sideShare = 0.93;

std::string setPaper(const FaceCurves& face, FaceWarpLayout& layout) {
  std::array<Place, 25> inner;
  for (std::size_t i = 0; i < inner.size(); ++i)
    if (!placeNamed(face, featurePlaces[i], inner[i]))
      return std::string("the face lacks the feature point that place ") + featurePlaces[i] + " of the warp mesh needs";
  const auto within = [&](int i, int j) { return inner[(std::clamp(i, 1, 5) - 1) * 5 + std::clamp(j, 1, 5) - 1]; };
  layout = {paperSide, paperSide, {}};
  for (int i = 0; i < paperSide; ++i)
    for (int j = 0; j < paperSide; ++j) {
      Place place = within(i, j);
      if (i % 6 == 0 || j % 6 == 0) place.name.clear();
      if (i % 6 == 0) place.curve = i == 0 ? 0 : FaceLayout::curveCount - 1;
      if (j % 6 == 0) place.v = j == 0 ? M_PI - frontal : M_PI + frontal;
      layout.places.push_back(place);
    }
  return {};
}

void setFine(FaceWarpLayout& layout) {
  layout = {static_cast<int>(fineCurves.size()), fineColumns, {}};
  for (const char* curve : fineCurves)
    for (int j = 0; j < fineColumns; ++j)
      layout.places.push_back({"", static_cast<double>(FaceLayout::curveIndex(curve)),
                               M_PI + frontal * (2.0 * j / (fineColumns - 1) - 1.0)});
}

/// C22 and C22' lie at the same u.
double faceU(double curve) {
  const double lip = FaceLayout::upperLip;
  return (curve <= lip ? curve : std::max(lip, curve - 1.0)) / (FaceLayout::curveCount - 2.0);
}

/// As seen from the front, y down.
Eigen::Vector2d seen(const FaceCurves& face, const Place& place) {
  const int above = static_cast<int>(place.curve);
  const double share = place.curve - above;
  Eigen::Vector3d point = face.curves.at(above, place.v);
  if (share > 0.0) point += share * (face.curves.at(above + 1, place.v) - point);
  return {point.x(), -point.y()};
}

bool onNoseOrCheek(const std::string& name) {
  return name == "5.3" || name == "5.4" || name == "9.12";
}

std::vector<std::string> namesOf(const ImageLandmarks& landmarks) {
  std::vector<std::string> names(featurePlaces.begin(), featurePlaces.end());
  if (landmarks.count("0") == 0) return names;
  names.clear();
  for (int i = 0; i < numbered; ++i) names.push_back(std::to_string(i));
  return names;
}

std::string describePlace(const Eigen::Vector2d& point) {
  return "x = " + std::to_string(std::lround(point.x())) + ", y = " + std::to_string(std::lround(point.y()));
}

std::string describeOutside(const ImageLandmarks& landmarks, double width, double height) {
  for (const std::string& name : namesOf(landmarks)) {
    const auto found = landmarks.find(name);
    if (found == landmarks.end()) continue;
    const Eigen::Vector2d& p = found->second;
    if (p.minCoeff() < 0.0 || p.x() > width || p.y() > height)
      return "landmark " + name + " lies at " + describePlace(p) + ", beyond the picture of " +
             std::to_string(std::lround(width)) + " x " + std::to_string(std::lround(height)) +
             " pixels; give the landmarks of this picture, at its size";
  }
  return {};
}

struct PointPairs {
  SmoothWarp::Points from, to;

  PointPairs(const FaceCurves& face, const std::vector<PlacePair>& pairs) : from(pairs.size(), 2), to(pairs.size(), 2) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      from.row(i) = seen(face, pairs[i].first).transpose();
      to.row(i) = pairs[i].second.transpose();
    }
  }
};

/// The photograph as brows, eyes and lips have it, which all find; what cheekbones and nose are is less well known.
AffineFit fitOfFeatures(const FaceCurves& face, std::vector<PlacePair> pairs) {
  pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(), [](const PlacePair& pair) { return onNoseOrCheek(pair.first.name); }),
      pairs.end());
  const PointPairs points(face, pairs);
  return {points.from, points.to};
}

std::string describeStray(const FaceCurves& face, const AffineFit& fit, const std::vector<PlacePair>& pairs) {
  double farthest = largestStray;
  std::string fault;
  for (const auto& [place, point] : pairs) {
    const Eigen::Vector2d expected = fit(seen(face, place));
    const double pixels = (point - expected).norm(), distance = pixels / fit.scale();
    if (!(distance > farthest)) continue;
    farthest = distance;
    fault = "landmark " + place.name + " lies " + std::to_string(std::lround(pixels)) +
            " pixels from where the others put it, about " + describePlace(expected) +
            "; doc/warp_points.md shows where each of the 25 belongs";
  }
  return fault;
}

/// Nothing holds the sides where only features are marked: there the face is taken to be as wide as the features say,
/// and a little less, so that the background stays outside.
void addSides(const FaceCurves& face, const AffineFit& fit, std::vector<PlacePair>& pairs) {
  for (const char* curve : sideCurves)
    for (const double side : {-1.0, 1.0}) {
      const FacePlace place = {"", static_cast<double>(FaceLayout::curveIndex(curve)), M_PI + side * frontal};
      Eigen::Vector2d inside = seen(face, place);
      if (place.curve > 0.0) inside.x() *= sideShare;
      pairs.emplace_back(place, fit(inside));
    }
}

std::string pair(const FaceCurves& face, const ImageLandmarks& landmarks, std::vector<PlacePair>& pairs) {
  if (landmarks.count("0") != 0) return pairByNumber(face, landmarks, pairs);
  std::string fault = pairByName(face, {featurePlaces.begin(), featurePlaces.end()}, landmarks, pairs);
  if (!fault.empty()) return fault;
  const AffineFit fit = fitOfFeatures(face, pairs);
  if (!fit.sound()) return {};  // as the smooth map through them, which says so
  fault = describeStray(face, fit, pairs);
  if (fault.empty()) addSides(face, fit, pairs);
  return fault;
}

template <typename Position>
WarpMesh meshOf(const FaceWarpLayout& layout, double width, double height, const Position& position) {
  WarpMesh mesh(layout.rows, layout.columns, width, height);
  for (int i = 0; i < layout.rows; ++i)
    for (int j = 0; j < layout.columns; ++j) {
      const Place& place = layout.places[i * layout.columns + j];
      const Eigen::Vector2d point = position(place);
      mesh.x(i, j) = point.x();
      mesh.y(i, j) = point.y();
      mesh.names.push_back(place.name);
    }
  return mesh;
}

}  // namespace

std::string FaceWarpLayout::set(Kind kind, const FaceCurves& face) {
  if (kind == Kind::SevenBySeven) return setPaper(face, *this);
  setFine(*this);
  return {};
}

std::pair<int, int> FaceWarpLayout::sizeOf(Kind kind) {
  if (kind == Kind::SevenBySeven) return {paperSide, paperSide};
  return {static_cast<int>(fineCurves.size()), fineColumns};
}

bool FaceWarpLayout::kindOf(const WarpMesh& mesh, Kind& kind) {
  for (const Kind known : {Kind::SevenBySeven, Kind::Fine})
    if (sizeOf(known) == std::pair(mesh.rows(), mesh.columns())) {
      kind = known;
      return true;
    }
  return false;
}

WarpMesh textureMesh(const FaceWarpLayout& layout, double width, double height) {
  return meshOf(layout, width, height, [&](const Place& place) {
    return Eigen::Vector2d(width * place.v / (2.0 * M_PI), height * faceU(place.curve));
  });
}

WarpMesh frontMesh(const FaceWarpLayout& layout, const FaceCurves& face, double pixelsPerMillimetre,
                   const Eigen::Vector2d& corner, double width, double height) {
  const Eigen::Vector2d origin(corner.x(), -corner.y());
  return meshOf(layout, width, height, [&](const Place& place) -> Eigen::Vector2d {
    return pixelsPerMillimetre * (seen(face, place) - origin);
  });
}

WarpMesh startingMesh(const FaceWarpLayout& layout, const FaceCurves& face, double width, double height) {
  WarpMesh mesh = frontMesh(layout, face, 1.0, Eigen::Vector2d::Zero(), width, height);
  const double left = mesh.x.minCoeff(), top = mesh.y.minCoeff();
  const double across = mesh.x.maxCoeff() - left, down = mesh.y.maxCoeff() - top;
  const double scale = startingShare * std::min(width / across, height / down);
  mesh.x.array() = 0.5 * width + scale * (mesh.x.array() - left - 0.5 * across);
  mesh.y.array() = 0.5 * height + scale * (mesh.y.array() - top - 0.5 * down);
  return mesh;
}

std::string photographMesh(const FaceWarpLayout& layout, const FaceCurves& face, const ImageLandmarks& landmarks,
                           double width, double height, WarpMesh& mesh) {
  std::vector<PlacePair> pairs;
  std::string fault = describeOutside(landmarks, width, height);
  if (fault.empty()) fault = pair(face, landmarks, pairs);
  if (!fault.empty()) return fault;
  const PointPairs points(face, pairs);
  const SmoothWarp bend(points.from, points.to);
  if (!bend.sound()) return "the landmarks lie on a line; give those of a face";
  const WarpMesh made =
      meshOf(layout, width, height, [&](const Place& place) { return Eigen::Vector2d(bend(seen(face, place))); });
  const std::string fold = describeFault(made, "the mesh that these landmarks give");
  if (fold.empty()) mesh = made;
  return fold;
}

}  // namespace mien
