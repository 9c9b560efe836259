#pragma once

#include <array>
#include <functional>
#include <string>

#include "FaceCurves.h"
#include "FaceSurface.h"
#include "MouthCorners.h"
#include "PDESurface.h"
#include "SurfaceJet.h"

namespace mien {

/// A PDE face on the rows and columns of its grid, with the one-sided derivatives that measures need.
///
/// The rows are those of RowLayout, but that every patch has both of its seams: a seam is two rows at one place, with
/// the derivatives of the patch above and of the one below.
class FaceSample {
 public:
  /// @param rows,columns  of the grid, as RowLayout and vtkPDEFaceFilter count them
  FaceSample(const FaceCurves& face, const FaceSurfaceOptions& options, int rows, int columns);

  /// Nine patches given by their jets at (patch, u, v): surfaces that are known in closed form.
  FaceSample(const std::function<SurfaceJet(int patch, double u, double v)>& surface, int rows, int columns,
             const MouthCorners& mouth = {});

  /// One sentence when the scheme's conditions determine no surface, or nothing.
  const std::string& fault() const { return fault_; }

  int columnCount() const { return columns_; }
  int rowCount() const { return static_cast<int>(u_.size()); }

  /// Patch p has the rows firstRow(p) .. firstRow(p + 1) - 1.
  int firstRow(int patch) const { return firstRow_[patch]; }
  double u(int row) const { return u_[row]; }  ///< in the patch
  double v(int column) const { return 2.0 * M_PI * column / columns_; }

  SurfaceJet jet(int row, int column) const;
  Eigen::Vector3d point(int row, int column) const { return vectorOf(grids_[0], row, column % columns_); }

  /// S_u x S_v, along the normal; its length in mm2 per unit of u and radian.
  Eigen::Vector3d areaVector(int row, int column) const;
  /// |S_u x S_v|.
  double areaElement(int row, int column) const;

  const MouthCorners& mouth() const { return mouth_; }

 private:
  static Eigen::Vector3d vectorOf(const RowMajor<double>& grid, int row, int column) {
    return Eigen::Map<const Eigen::Vector3d>(grid.row(row).data() + 3 * column);
  }
  void dealRows(int rows);
  void dealRowsTo(std::vector<SurfacePiece>& pieces) const;

  int columns_;
  MouthCorners mouth_;
  std::vector<double> u_;
  std::array<int, FaceLayout::patchCount + 1> firstRow_{};
  std::array<RowMajor<double>, 6> grids_;  ///< S, S_u, S_v, S_uu, S_uv, S_vv
  std::string fault_;
};

/// The integral over all patches of f(row, column) du dv by the trapezoid rule; samples where f is not finite are left
/// out.
template <class Function>
double integrate(const FaceSample& sample, const Function& f) {
  double sum = 0.0;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    const int begin = sample.firstRow(patch), last = sample.firstRow(patch + 1) - 1;
    for (int row = begin; row <= last; ++row) {
      const double weight = 0.5 * (sample.u(std::min(row + 1, last)) - sample.u(std::max(row - 1, begin)));
      for (int column = 0; column < sample.columnCount(); ++column) {
        const double value = f(row, column);
        if (std::isfinite(value)) sum += weight * value;
      }
    }
  }
  return sum * 2.0 * M_PI / sample.columnCount();
}

}  // namespace mien
