#include "FaceProfiles.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "Degree.h"
#include "FaceLayout.h"
#include "SmoothStep.h"

namespace mien {

namespace {

using Knots = std::vector<std::pair<double, double>>;

enum Key { Forehead, Brow, UpperLid, LowerLid, NoseTip, NoseBase, UpperLip, LipLine, LowerLip, Jaw };

/// A curve at a fraction of the way from one key down to the next.
struct Place {
  Key key;
  double fraction;
};

/// Tuned in doc/decisions.md: before a key that nears its neighbour at a corner (lids, lips) the spacing shrinks
/// gradually, else the four-curve scheme swings past it.
constexpr std::array<Place, FaceLayout::curveCount> places = {{
    {Forehead, 0.0}, {Forehead, 0.22}, {Forehead, 0.43}, {Forehead, 0.63}, {Forehead, 0.83},  // C1 .. C5
    {Brow, 0.0},     {Brow, 0.50},     {Brow, 0.80},                                          // C6 .. C8
    {UpperLid, 0.0},                                                                          // C9
    {LowerLid, 0.0}, {LowerLid, 0.20}, {LowerLid, 0.40}, {LowerLid, 0.60}, {LowerLid, 0.80},  // C10 .. C14
    {NoseTip, 0.0},  {NoseTip, 0.42},  {NoseTip, 0.72},                                       // C15 .. C17
    {NoseBase, 0.0}, {NoseBase, 0.42}, {NoseBase, 0.75},                                      // C18 .. C20
    {UpperLip, 0.0}, {LipLine, 0.0},   {LipLine, 0.0},                                        // C21, C22, C22'
    {LowerLip, 0.0}, {LowerLip, 0.15}, {LowerLip, 0.37}, {LowerLip, 0.66}, {LowerLip, 0.84},  // C23 .. C27
    {Jaw, 0.0},                                                                               // C28
}};

constexpr double foreheadShare = 0.36;             // C1 above the brows, of the height from brows to chin
constexpr double browLift = 3.0;                   // mm that the brows' outer ends are raised, else the seam C7 folds
constexpr double lidGap = 2.0, lidGapAside = 7.0;  // mm between C9 and C10 at the eye corners, and beside the eyes
constexpr double lipGap = 2.2, lipGapAside = 6.0;  // mm between C21, C22 and C23 at the mouth corners, and beside
constexpr double asideWidth = 13.0 * degree;       // over which a gap opens
constexpr double cornerWidth = 3.0 * degree;       // beyond a mouth corner, over which the skin takes over
constexpr double blendBegin = 45.0 * degree, blendEnd = 130.0 * degree;
constexpr double jawInset = 1.0;  // mm above the jaw landmarks, where a horizontal ray still leaves the face

/// Collects knots (azimuth, height) of a key curve from landmarks.
struct KnotMaker {
  const FaceLandmarks& landmarks;
  const HeadAxis& axis;

  double azimuth(int i) const { return axis.azimuth(landmarks[i]); }
  double y(int i) const { return landmarks[i].y(); }
  Knots at(std::initializer_list<int> ids, double shift = 0.0) const {
    Knots knots;
    for (const int i : ids) knots.emplace_back(azimuth(i), y(i) + shift);
    return knots;
  }
  double meanHeight(std::initializer_list<int> ids) const {
    double sum = 0.0;
    for (const int i : ids) sum += y(i);
    return sum / static_cast<double>(ids.size());
  }
};

void append(Knots& knots, const Knots& more) {
  knots.insert(knots.end(), more.begin(), more.end());
}

/// One lid margin over both eyes; `sign` is +1 for the upper lid, `inner` the landmarks between the corners.
Knots lidKnots(const KnotMaker& make, std::initializer_list<int> inner, double sign) {
  Knots knots = make.at(inner);
  append(knots, make.at({36, 39, 42, 45}, 0.5 * sign * lidGap));
  knots.emplace_back(0.5 * (make.azimuth(39) + make.azimuth(42)), make.meanHeight({39, 42}) + 0.5 * sign * lidGapAside);
  knots.emplace_back(make.azimuth(36) - asideWidth, make.y(36) + 0.5 * sign * lidGapAside);
  knots.emplace_back(make.azimuth(45) + asideWidth, make.y(45) + 0.5 * sign * lidGapAside);
  return knots;
}

/// An outer lip contour; `sign` is +1 for the upper lip, -1 for the lower, 0 for the contact line.
Knots lipKnots(const KnotMaker& make, Knots inner, double sign) {
  append(inner, make.at({48, 54}, sign * lipGap));
  inner.emplace_back(make.azimuth(48) - asideWidth, make.y(48) + sign * lipGapAside);
  inner.emplace_back(make.azimuth(54) + asideWidth, make.y(54) + sign * lipGapAside);
  return inner;
}

/// The contact line of the lips: pairs of inner landmarks, averaged while the mouth is closed.
template <class Value>
Knots contactKnots(const KnotMaker& make, Value value) {
  Knots knots;
  for (const auto& [upper, lower] : {std::pair{60, 60}, {61, 67}, {62, 66}, {63, 65}, {64, 64}})
    knots.emplace_back(0.5 * (make.azimuth(upper) + make.azimuth(lower)), 0.5 * (value(upper) + value(lower)));
  return knots;
}

}  // namespace

FaceProfiles::FaceProfiles(const FaceLandmarks& landmarks) : axis_(headAxis(landmarks)) {
  const KnotMaker make{landmarks, axis_};
  const double brow = make.meanHeight({19, 24}), midBrow = make.meanHeight({21, 22}), noseBase = make.y(33);
  const auto y = [&](int i) { return make.y(i); };
  const auto radius = [&](int i) { return axis_.radius(landmarks[i]); };
  top_ = brow + foreheadShare * (brow - make.y(8));
  bottom_ = make.meanHeight({5, 11});
  keys_[Forehead] = MonotoneInterpolant({{0.0, top_}});
  Knots browKnots = make.at({18, 19, 20, 21, 22, 23, 24, 25});
  append(browKnots, make.at({17, 26}, browLift));
  browKnots.emplace_back(0.0, midBrow);
  keys_[Brow] = MonotoneInterpolant(browKnots);
  keys_[UpperLid] = MonotoneInterpolant(lidKnots(make, {37, 38, 43, 44}, 1.0));
  keys_[LowerLid] = MonotoneInterpolant(lidKnots(make, {41, 40, 47, 46}, -1.0));
  keys_[NoseTip] = MonotoneInterpolant(make.at({30}));
  keys_[NoseBase] = MonotoneInterpolant({{0.0, noseBase}});
  keys_[UpperLip] = MonotoneInterpolant(lipKnots(make, make.at({49, 50, 51, 52, 53}), 1.0));
  keys_[LipLine] = MonotoneInterpolant(lipKnots(make, contactKnots(make, y), 0.0));
  keys_[LowerLip] = MonotoneInterpolant(lipKnots(make, make.at({55, 56, 57, 58, 59}), -1.0));
  keys_[Jaw] = MonotoneInterpolant(make.at({5, 6, 7, 8, 9, 10, 11}, jawInset));
  Knots lipRadii = contactKnots(make, radius);
  lipRadii.emplace_back(make.azimuth(48), radius(48));
  lipRadii.emplace_back(make.azimuth(54), radius(54));
  lipRadius_ = MonotoneInterpolant(lipRadii);
  rightCorner_ = make.azimuth(48);
  leftCorner_ = make.azimuth(54);
}

double FaceProfiles::frontHeight(int curve, double azimuth) const {
  const Place& place = places[curve];
  const double upper = keys_[place.key](azimuth);
  if (place.fraction == 0.0) return upper;
  return upper + place.fraction * (keys_[place.key + 1](azimuth) - upper);
}

double FaceProfiles::height(int curve, double azimuth) const {
  const double a = std::remainder(azimuth, 2.0 * M_PI);
  const int step = curve < FaceLayout::lowerLip ? curve : curve - 1;
  const double back = top_ + (bottom_ - top_) * step / (FaceLayout::curveCount - 2);
  const double w = smoothStep((std::abs(a) - blendBegin) / (blendEnd - blendBegin));
  return (1.0 - w) * frontHeight(curve, a) + w * back;
}

double FaceProfiles::lipWeight(double azimuth) const {
  const double a = std::remainder(azimuth, 2.0 * M_PI);
  const double outside = std::max(rightCorner_ - a, a - leftCorner_);
  return 1.0 - smoothStep(outside / cornerWidth);
}

}  // namespace mien
