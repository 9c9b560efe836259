#include "LandmarkPlaces.h"

#include <array>
#include <cmath>

#include "FaceLayout.h"

namespace mien {

namespace {

/// Landmarks whose mean (of some twice) marks a named place on the subject's right, and their partners on the left.
struct NamedMark {
  const char* place;
  std::array<int, 3> landmarks;  ///< -1: none
};

// clang-format off
constexpr std::array<NamedMark, 31> namedMarks = {{
    {"4.6", {17, -1, -1}}, {"4.4", {19, 19, 20}}, {"4.2", {21, -1, -1}},
    {"4.5", {26, -1, -1}}, {"4.3", {24, 24, 23}}, {"4.1", {22, -1, -1}},
    {"3.12", {36, -1, -1}}, {"3.8", {39, -1, -1}}, {"3.2", {37, 38, 38}}, {"3.4", {41, 40, 40}},
    {"3.7", {45, -1, -1}}, {"3.11", {42, -1, -1}}, {"3.1", {44, 43, 43}}, {"3.3", {46, 47, 47}},
    {"nose_bridge", {27, -1, -1}}, {"9.3", {30, -1, -1}}, {"9.4", {31, -1, -1}}, {"9.15", {33, -1, -1}}, {"9.5", {35, -1, -1}},
    {"8.4", {48, -1, -1}}, {"8.6", {49, 50, -1}}, {"8.1", {51, -1, -1}}, {"8.5", {53, 52, -1}}, {"8.3", {54, -1, -1}},
    {"lower_lip_left", {55, -1, -1}}, {"8.7", {55, 56, 56}}, {"8.2", {57, -1, -1}}, {"8.8", {59, 58, 58}}, {"lower_lip_right", {59, -1, -1}},
    {"2.2", {62, 66, -1}}, {"2.1", {8, -1, -1}}}};
// clang-format on

/// The jaw line has no feature points: where it runs on the generic face, as degrees of v from the midline.
struct JawMark {
  int right, left;  // landmarks
  const char* curve;
  double degrees;
};

constexpr std::array<JawMark, 8> jawMarks = {{{0, 16, "C10", 108.0},
                                              {1, 15, "C14", 108.0},
                                              {2, 14, "C17", 108.0},
                                              {3, 13, "C21", 108.0},
                                              {4, 12, "C25", 108.0},
                                              {5, 11, "C28", 76.0},
                                              {6, 10, "C28", 54.0},
                                              {7, 9, "C28", 27.0}}};

std::string missing(const std::string& name) {
  return "landmark " + name + " is missing";
}

std::string addMean(const FacePlace& place, const NamedMark& mark, const ImageLandmarks& landmarks,
                    std::vector<PlacePair>& pairs) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (const int landmark : mark.landmarks) {
    if (landmark < 0) continue;
    const auto found = landmarks.find(std::to_string(landmark));
    if (found == landmarks.end()) return missing(std::to_string(landmark)) + "; all 68 are needed, 0 to 67";
    sum += found->second;
    ++count;
  }
  pairs.emplace_back(place, sum / count);
  return {};
}

std::string lacks(const char* place) {
  return std::string("the face lacks the feature point at ") + place;
}

bool between(const FaceCurves& face, const char* first, const char* second, FacePlace& place) {
  const FeaturePoint *a = face.feature(first), *b = face.feature(second);
  if (a && b) place.v = 0.5 * (a->v + b->v);
  return a && b;
}

}  // namespace

bool placeNamed(const FaceCurves& face, const std::string& name, FacePlace& place) {
  const auto curve = [](const char* curveName) { return static_cast<double>(FaceLayout::curveIndex(curveName)); };
  place = {name, 0.0, M_PI};
  if (name == "brow_middle" || name == "nose_bridge") {
    place.curve = curve(name == "brow_middle" ? "C6" : "C9");
    return true;
  }
  if (name == "lower_lip_right" || name == "lower_lip_left") {
    place.curve = curve("C23");
    return name == "lower_lip_left" ? between(face, "8.7", "8.3", place) : between(face, "8.8", "8.4", place);
  }
  const FeaturePoint* feature = face.feature(name);
  if (!feature) return false;
  const bool corner = name == "3.7" || name == "3.8" || name == "3.11" || name == "3.12";
  place.curve = feature->curve + (corner ? 0.5 : 0.0);
  place.v = feature->v;
  return true;
}

std::string pairByNumber(const FaceCurves& face, const ImageLandmarks& landmarks, std::vector<PlacePair>& pairs) {
  for (const NamedMark& mark : namedMarks) {
    FacePlace place;
    if (!placeNamed(face, mark.place, place)) return lacks(mark.place);
    const std::string fault = addMean(place, mark, landmarks, pairs);
    if (!fault.empty()) return fault;
  }
  for (const JawMark& mark : jawMarks)
    for (const int landmark : {mark.right, mark.left}) {
      const double side = landmark == mark.right ? -1.0 : 1.0;
      const FacePlace place = {"", static_cast<double>(FaceLayout::curveIndex(mark.curve)),
                               M_PI * (1.0 + side * mark.degrees / 180.0)};
      const std::string fault = addMean(place, {"", {landmark, -1, -1}}, landmarks, pairs);
      if (!fault.empty()) return fault;
    }
  return {};
}

std::string pairByName(const FaceCurves& face, const std::vector<std::string>& names, const ImageLandmarks& landmarks,
                       std::vector<PlacePair>& pairs) {
  for (const std::string& name : names) {
    FacePlace place;
    if (!placeNamed(face, name, place)) return lacks(name.c_str());
    const auto found = landmarks.find(name);
    if (found == landmarks.end())
      return missing(name) + "; give the 68 by number, 0 to 67, or the 25 points of the warp mesh by name";
    pairs.emplace_back(place, found->second);
  }
  return {};
}

}  // namespace mien
