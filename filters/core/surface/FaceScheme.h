#pragma once

#include <string>
#include <vector>

#include "Condition.h"
#include "SharedDerivatives.h"

namespace mien {

/// A way to close the patches of a face: a list of conditions and a rule for shared derivatives.
///
/// In a scheme, Condition::curve is the position of a curve in its patch, 0 .. 3. A condition with
/// derivative 0 is that curve; one with a derivative takes the shared derivative at that curve.
struct FaceScheme {
  /// One solution of the PDE: it holds between begin and end of the patch's u.
  struct Piece {
    double begin, end;
    std::vector<Condition> conditions;
  };

  std::string name;
  std::string description;
  std::vector<Piece> pieces;
  ChainDerivatives derivatives;  ///< the rule for shared derivatives
  double largestRate;            ///< a (N + 1) past which the surface would be lost to its Lebesgue constant

  int order() const { return static_cast<int>(pieces.front().conditions.size()); }
};

/// All schemes, the paper's first. A new scheme is one entry here.
const std::vector<FaceScheme>& faceSchemes();

/// The scheme of that name, or nullptr.
const FaceScheme* findFaceScheme(const std::string& name);

}  // namespace mien
