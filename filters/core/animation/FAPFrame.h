#pragma once

#include <array>

namespace mien {

/// FAP 1 of one frame: two of the visemes 1 .. 14 (0 = none) mixed by blend / 63.
struct Viseme {
  double select1 = 0.0, select2 = 0.0, blend = 0.0, definition = 0.0;
};

/// FAP 2 of one frame: two of the expressions 1 .. 6 (0 = none), each with an intensity 0 .. 63.
struct Expression {
  double select1 = 0.0, intensity1 = 0.0, select2 = 0.0, intensity2 = 0.0, initialFace = 0.0, definition = 0.0;
};

/// The facial animation parameters of one moment (ISO/IEC 14496-2): a missing FAP is 0.
class FAPFrame {
 public:
  static constexpr int count = 68;  ///< FAP numbers run from 1 to 68
  static constexpr int firstLowLevel = 3;
  static constexpr double fullWeight = 63.0;  ///< of a viseme's blend and an expression's intensity

  double value(int fap) const { return values_[fap - 1]; }  ///< in FAP units; fap in 1 .. 68
  void setValue(int fap, double v) { values_[fap - 1] = v; }

  Viseme viseme;          ///< FAP 1; value(1) is not used
  Expression expression;  ///< FAP 2; value(2) is not used
  double number = 0.0;    ///< the frame number as written in the file

  bool isNeutral() const;  ///< every low-level FAP is 0 and no viseme or expression is selected

 private:
  std::array<double, count> values_{};
};

}  // namespace mien
