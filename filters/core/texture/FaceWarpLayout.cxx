#include "FaceWarpLayout.h"

#include <algorithm>
#include <array>
#include <cmath>

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

std::string fit(const FaceCurves& face, const ImageLandmarks& landmarks, SmoothWarp::Points& from,
                SmoothWarp::Points& to) {
  std::vector<PlacePair> pairs;
  const std::string fault = landmarks.count("0") != 0
                                ? pairByNumber(face, landmarks, pairs)
                                : pairByName(face, {featurePlaces.begin(), featurePlaces.end()}, landmarks, pairs);
  if (!fault.empty()) return fault;
  from.resize(pairs.size(), 2);
  to.resize(pairs.size(), 2);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    from.row(i) = seen(face, pairs[i].first).transpose();
    to.row(i) = pairs[i].second.transpose();
  }
  return {};
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
  SmoothWarp::Points from, to;
  const std::string fault = fit(face, landmarks, from, to);
  if (!fault.empty()) return fault;
  const SmoothWarp bend(from, to);
  if (!bend.sound()) return "the landmarks lie on a line; give those of a face";
  const WarpMesh made =
      meshOf(layout, width, height, [&](const Place& place) { return Eigen::Vector2d(bend(seen(face, place))); });
  const std::string fold = describeFault(made, "the mesh that these landmarks give");
  if (fold.empty()) mesh = made;
  return fold;
}

}  // namespace mien
