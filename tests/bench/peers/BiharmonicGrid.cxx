#include "BiharmonicGrid.h"

#include <cmath>
#include <vector>

BiharmonicGrid::BiharmonicGrid(int rows, int columns, double smoothing)
    : rows_(rows),
      columns_(columns),
      stepU_(1.0 / (rows - 1)),
      stepV_(2.0 * M_PI / columns),
      smoothing_(smoothing),
      matrix_((rows - 2) * columns, (rows - 2) * columns),
      edges_((rows - 2) * columns, 4 * columns) {
  Entries inner, edge;
  for (int row = 1; row + 1 < rows_; ++row)
    for (int column = 0; column < columns_; ++column) addStencil(row, column, inner, edge);
  matrix_.setFromTriplets(inner.begin(), inner.end());
  edges_.setFromTriplets(edge.begin(), edge.end());
}

/// The five-point operator applied to itself: thirteen points.
void BiharmonicGrid::addStencil(int row, int column, Entries& inner, Entries& edge) const {
  const double u = 1.0 / (stepU_ * stepU_), v = smoothing_ * smoothing_ / (stepV_ * stepV_);
  const struct {
    int row, column;
    double weight;
  } points[5] = {{0, 0, -2.0 * (u + v)}, {-1, 0, u}, {1, 0, u}, {0, -1, v}, {0, 1, v}};
  const int equation = (row - 1) * columns_ + column;
  for (const auto& a : points)
    for (const auto& b : points)
      add(equation, row + a.row + b.row, column + a.column + b.column, a.weight * b.weight, inner, edge);
}

/// Rows beyond an edge are their mirror images and the slope there.
void BiharmonicGrid::add(int equation, int row, int column, double weight, Entries& inner, Entries& edge) const {
  const int around = (column + columns_) % columns_;
  if (row < 0) {
    edge.emplace_back(equation, 2 * columns_ + around, 2.0 * stepU_ * weight);
    row = -row;
  } else if (row >= rows_) {
    edge.emplace_back(equation, 3 * columns_ + around, -2.0 * stepU_ * weight);
    row = 2 * (rows_ - 1) - row;
  }
  if (row == 0 || row == rows_ - 1)
    edge.emplace_back(equation, (row == 0 ? 0 : columns_) + around, -weight);
  else
    inner.emplace_back(equation, (row - 1) * columns_ + around, weight);
}
