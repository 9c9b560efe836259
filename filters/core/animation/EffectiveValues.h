#pragma once

#include <vector>

#include "AnimationTable.h"
#include "FAPFrame.h"
#include "FAPUnits.h"
#include "FaceCurves.h"
#include "MotionBasis.h"

namespace mien {

/// The values with which the motions of a frame add up, where several FAPs move one feature point.
///
/// A file may set the inner lip, the outer lip or both; the middle of a lip, its quarters or both. Each FAP moves its
/// neighbourhood along, so that one alone gives a smooth mouth; set together they must not move a place twice. Two
/// relations of the table see to that:
/// - lends: the taker's value v becomes v + soft(share x lender, 2 |v|), soft(c, t) = sign(c) max(0, |c| - t);
/// - replaces: with c what the FAPs named do at the feature point, in units of this one, it acts with e = v - clamp(c,
/// +-2 |v|). The point
///   then moves by e + c = v + soft(c, 2 |v|): by its own value once that is half of c, by c where it is silent, and
///   never by more than the larger of both. `beyond` is the same with |v| in place of 2 |v|, for FAPs that move one
///   place: it moves by the larger of both.
/// All are continuous and homogeneous in the values. FAPs without relations act with the values they have.
class EffectiveValues {
 public:
  EffectiveValues(const FaceCurves& face, const AnimationTable& table, const MotionBasis& basis, const FAPUnits& units);

  /// Finite values of the table's FAPs, valid until the next call. Allocates nothing.
  const FAPFrame& resolve(const FAPFrame& frame);

 private:
  /// What one FAP does at the feature point of another.
  struct Carried {
    const FAPMotion* motion;
    std::vector<double> perValue;  ///< per interval, in units of the other FAP
  };
  /// A FAP that takes account of others.
  struct Claim {
    int fap;
    double yield;  ///< how many times its own value others give way to
    std::vector<Carried> others;
  };
  struct Loan {
    int from, to;
    double share;
  };

  void lend(const FAPFrame& frame);
  void claim(const Claim& claim);

  std::vector<int> faps_;
  std::vector<Loan> loans_;
  std::vector<Claim> claims_;
  FAPFrame values_;
};

}  // namespace mien
