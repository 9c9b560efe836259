#pragma once

#include <Eigen/SparseCore>

/// The PDE (d2/du2 + a^2 d2/dv2)^2 S = 0 on one patch by central differences of second order: values and slopes in u
/// are prescribed at u = 0 and u = 1, v goes round. Unknowns are the inner rows, row by row.
class BiharmonicGrid {
 public:
  /// @param rows       of the grid, both edges counted; at least 5
  /// @param columns    without a closing one
  /// @param smoothing  a
  BiharmonicGrid(int rows, int columns, double smoothing);

  /// Of the unknowns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

  /// What the edges add to the right side: one row a column of S(0, v), S(1, v), S_u(0, v), S_u(1, v), in this order.
  const Eigen::SparseMatrix<double>& edges() const { return edges_; }

  double u(int row) const { return row * stepU_; }
  double v(int column) const { return column * stepV_; }

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  void addStencil(int row, int column, Entries& inner, Entries& edge) const;
  void add(int equation, int row, int column, double weight, Entries& inner, Entries& edge) const;

  int rows_, columns_;
  double stepU_, stepV_, smoothing_;
  Eigen::SparseMatrix<double> matrix_, edges_;
};
