#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "AnimationTable.h"
#include "FAPTable.h"
#include "FaceAnimator.h"

/// What the entry of a FAP may move, read from the knots of the table alone, not from the weights made of them.
class EntryReach {
 public:
  EntryReach(const mien::FaceCurves& face, const mien::AnimationTable& table) : face_(face), table_(table) {}

  bool mayMove(const mien::AnimationEntry& entry, int curve, double v) const {
    if (namesPlace(entry, curve, v)) return true;
    return std::any_of(entry.lends.begin(), entry.lends.end(), [&](const mien::FAPLoan& loan) {
      const mien::AnimationEntry* other = table_.entry(loan.fap);
      return other && namesPlace(*other, curve, v);
    });
  }

 private:
  /// Lids close a little beyond the corners of the eye.
  static constexpr double beyondGap = 0.35;
  static constexpr double halfEye = 0.9;

  bool namesPlace(const mien::AnimationEntry& entry, int curve, double v) const {
    return std::any_of(entry.parts.begin(), entry.parts.end(), [&](const mien::AnimationPart& part) {
      const auto [from, to] = stretchOf(part.profile, entry.fap);
      return names(part, curve) && v >= from - 1e-9 && v <= to + 1e-9;
    });
  }

  static bool names(const mien::AnimationPart& part, int curve) {
    if (std::count(part.curves.begin(), part.curves.end(), curve) > 0) return true;
    if (part.above >= 0 && curve > part.above && curve < part.curves.front()) return true;
    return part.below >= 0 && curve < part.below && curve > part.curves.back();
  }

  double place(std::string names) const {
    for (std::size_t end; !names.empty(); names.erase(0, end == names.npos ? end : end + 1)) {
      end = names.find('|');
      if (const mien::FeaturePoint* feature = face_.feature(names.substr(0, end))) return feature->v;
    }
    ADD_FAILURE() << "no such feature point";
    return 0.0;
  }

  std::pair<double, double> stretchOf(const mien::WeightProfile& profile, int fap) const {
    if (profile.followsGap() && !face_.feature(profile.gapFrom)) {  // as far as the gap narrows: about the eye
      const double middle = place(std::string(mien::fapDefinition(fap).featurePoint));
      return {middle - halfEye, middle + halfEye};
    }
    if (profile.followsGap()) return {place(profile.gapFrom) - beyondGap, place(profile.gapTo) + beyondGap};
    std::vector<double> places;
    for (const mien::ProfileKnot& knot : profile.knots) places.push_back(place(knot.feature) + knot.offset);
    return {*std::min_element(places.begin(), places.end()), *std::max_element(places.begin(), places.end())};
  }

  const mien::FaceCurves& face_;
  const mien::AnimationTable& table_;
};

/// Moves every FAP of the table alone, by +-50, and expects that only places which its entry names move. Curves of a
/// contact that another curve touches may give way.
inline void expectNothingMovesOutsideItsEntry(const mien::FaceCurves& face, const mien::AnimationTable& table) {
  mien::FaceAnimator animator;
  ASSERT_EQ(animator.bind(face, table), "");
  const EntryReach reach(face, table);
  const int k = face.curves.pointsPerCurve;
  int frames = 0;
  Eigen::Index resting = 0;
  for (const mien::AnimationEntry& entry : table.entries())
    for (const double value : {50.0, -50.0}) {
      mien::FAPFrame frame;
      frame.setValue(entry.fap, value);
      const mien::ClosedCurves& moved = animator.animate(frame);
      ++frames;
      double furthest = 0.0;
      for (int curve = 0; curve < moved.count; ++curve) {
        const bool yields = animator.contactSamples() > 0 &&
                            std::any_of(table.contacts().begin(), table.contacts().end(), [&](const auto& contact) {
                              return contact.upper == curve || contact.lower == curve;
                            });
        for (int j = 0; j < k; ++j) {
          const double shift = (moved.curve(curve).row(j) - face.curves.curve(curve).row(j)).norm();
          furthest = std::max(furthest, shift);
          if (yields || reach.mayMove(entry, curve, 2.0 * M_PI * j / k)) continue;
          ++resting;
          ASSERT_EQ(shift, 0.0) << "FAP " << entry.fap << " = " << value << ", curve " << curve << ", sample " << j;
        }
      }
      EXPECT_GT(furthest, 0.1) << "FAP " << entry.fap << " = " << value;
    }
  EXPECT_EQ(frames, 2 * static_cast<int>(table.entries().size()));
  EXPECT_GE(frames, 92);
  EXPECT_GT(resting, frames * face.curves.points.rows() / 2) << "most of the face rests";
}
