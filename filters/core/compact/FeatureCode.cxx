#include "FeatureCode.h"

#include <cmath>

#include "CompactFace.h"
#include "FaceLayout.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr int turn = 1 << 16;
constexpr std::uint8_t anyName = 0;

/// "8.10" as 8 * 16 + 10; 0 for names that are not "group.index", each from 1 to 15.
std::uint8_t codeOf(const std::string& id) {
  const size_t dot = id.find('.');
  if (dot == std::string::npos) return anyName;
  const auto group = parseWholeNumber(id.substr(0, dot)), index = parseWholeNumber(id.substr(dot + 1));
  if (!group || !index || *group < 1 || *group > 15 || *index < 1 || *index > 15) return anyName;
  const bool plain = id == std::to_string(*group) + "." + std::to_string(*index);  // not "+8.1"
  return plain ? static_cast<std::uint8_t>(16 * *group + *index) : anyName;
}

std::string nameOf(std::uint8_t code) {
  return std::to_string(code / 16) + "." + std::to_string(code % 16);
}

int stepsOf(double v) {
  return static_cast<int>(std::lround(v * turn / (2.0 * M_PI))) % turn;
}

/// From 0 up to pi and from 2 pi down to it, so that v and 2 pi - v come back as exactly that.
double angleOf(int steps) {
  const int nearest = std::min(steps, turn - steps);
  const double v = 2.0 * M_PI * nearest / turn;
  return nearest == steps ? v : 2.0 * M_PI - v;
}

/// What a point differs from: on the same curve, at the mirrored place.
struct Expected {
  int curve = 0, steps = 0;

  void move(int newCurve, int newSteps) {
    curve = newCurve;
    steps = (turn - newSteps) % turn;
  }
};

std::string readName(ByteReader& bytes) {
  const std::uint8_t code = bytes.byte();
  if (code == anyName) return std::string(bytes.text());
  return code / 16 == 0 || code % 16 == 0 ? std::string() : nameOf(code);
}

}  // namespace

void writeFeatures(const std::vector<FeaturePoint>& features, ByteWriter& bytes) {
  for (const FeaturePoint& feature : features) {
    const std::uint8_t code = codeOf(feature.id);
    bytes.byte(code);
    if (code == anyName) bytes.text(feature.id);
  }
  Expected expected;
  for (const FeaturePoint& feature : features) {
    bytes.signedWhole(feature.curve - expected.curve);
    expected.curve = feature.curve;
  }
  for (const FeaturePoint& feature : features) {
    bytes.signedWhole(stepsOf(feature.v) - expected.steps);
    expected.move(feature.curve, stepsOf(feature.v));
  }
}

bool readFeatures(ByteReader& bytes, std::size_t count, std::vector<FeaturePoint>& features) {
  for (std::size_t i = 0; i < count && bytes.good(); ++i) {
    features.push_back({readName(bytes), 0, 0.0});
    const std::size_t length = features.back().id.size();
    if (length == 0 || length > CompactFaceLimits::longestId) return false;
  }
  Expected expected;
  for (FeaturePoint& feature : features) {
    const std::int64_t difference = bytes.signedWhole();
    if (std::abs(difference) >= FaceLayout::curveCount) return false;
    feature.curve = expected.curve += static_cast<int>(difference);
    if (feature.curve < 0 || feature.curve >= FaceLayout::curveCount) return false;
  }
  for (FeaturePoint& feature : features) {
    const std::int64_t difference = bytes.signedWhole();
    if (std::abs(difference) >= turn) return false;
    const int steps = expected.steps + static_cast<int>(difference);
    if (steps < 0 || steps >= turn) return false;
    feature.v = angleOf(steps);
    expected.move(feature.curve, steps);
  }
  return bytes.good();
}

}  // namespace mien
