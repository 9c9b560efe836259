#pragma once

#include <string>
#include <vector>

namespace mien {

/// Where a row of the face's grid lies.
struct FaceRow {
  int patch;     ///< 0 .. 8
  double u;      ///< in the patch, 0 .. 1
  double faceU;  ///< over the whole face, 0 .. 1, every patch one ninth
};

/// The rows of a face's uv mesh, both lip rows counted [S 4.1].
///
/// Dealt evenly to the intervals between curves, every seam is a row, and every curve too when there are
/// 27 k + 2 rows. Uniform rows follow the paper: equal steps of u over the face; only the row nearest
/// to the lips is moved onto them and doubled.
class RowLayout {
 public:
  static constexpr int minimumRows = 11;

  RowLayout(int rowCount, bool uniform);

  const std::vector<FaceRow>& rows() const { return rows_; }

  /// Row that lies on C22; the next lies on C22'.
  int upperLipRow() const { return upperLipRow_; }

  /// Names of the curves that are no rows.
  std::vector<std::string> missedCurves() const;

 private:
  void dealEvenly(int rowCount);
  void spreadUniformly(int rowCount);
  void add(int patch, double u);

  std::vector<FaceRow> rows_;
  int upperLipRow_ = 0;
};

}  // namespace mien
