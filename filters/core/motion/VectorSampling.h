#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mien {

/// Which of many vectors are drawn.
struct VectorSampling {
  enum class Kind {
    Automatic,  ///< in a picture evenly, at a distance that suits its printed size; in a table all vertices
    Every,      ///< every `step`-th vertex; in a grid of each row, rows staggered
    Even        ///< evenly in the picture, `spacing` apart
  };
  static constexpr int largestStep = 1000000;
  static constexpr double leastSpacing = 0.1, largestSpacing = 1000.0;  ///< mm

  Kind kind = Kind::Every;
  int step = 1;
  double spacing = 5.0;  ///< mm on the face as it is seen

  /// "auto", "every:N" or "even:SPACING", the spacing in mm.
  /// @return nothing, or one sentence that says what is wrong; the sampling is then as it was
  std::string parse(const std::string& text);
  std::string text() const;         ///< as parse() reads it
  std::string description() const;  ///< in words, for notes

  /// The candidates that are drawn, ascending. Even: peaks go first, which are longer than all within the spacing and
  /// at least half as long as the longest, so that thinning loses no motion; then those nearest to a hexagonal lattice
  /// of that spacing, so that the pattern is regular where the mesh is fine enough. Every two are at least 3/4 of the
  /// spacing apart, and every candidate has a chosen one within that.
  /// @param candidates  vertex numbers, ascending
  /// @param places      of all vertices in the picture, mm, a row each
  /// @param columns     of a grid, or 0
  /// @param lengths     of all vectors, mm; empty: none is a peak
  std::vector<int> choose(const std::vector<int>& candidates, const Eigen::Matrix<double, Eigen::Dynamic, 2>& places,
                          int columns, const Eigen::VectorXd& lengths = {}) const;
};

}  // namespace mien
