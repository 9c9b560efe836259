#include <gtest/gtest.h>

#include <vector>

#include "AlignedRows.h"
#include "BoundaryCoefficients.h"
#include "RowProduct.h"

using namespace mien;

namespace {

template <class Scalar>
void expectProduct(int rows, int depth, int columns, double tolerance) {
  const RowMajor<Scalar> u = RowMajor<Scalar>::Random(rows, depth), b = RowMajor<Scalar>::Random(depth, columns);
  AlignedRows<Scalar> padded(depth, columns);
  for (int k = 0; k < depth; ++k) std::copy_n(b.row(k).data(), columns, padded.row(k));
  RowMajor<Scalar> out = RowMajor<Scalar>::Constant(rows, columns + 3, 7);
  rowProduct(u.data(), rows, depth, padded.row(0), padded.stride(), columns, out.data(), out.cols());
  const Eigen::MatrixXd expected = u.template cast<double>() * b.template cast<double>();
  EXPECT_LE((out.leftCols(columns).template cast<double>() - expected).cwiseAbs().maxCoeff(), tolerance * depth)
      << rows << " x " << depth << " x " << columns;
  EXPECT_TRUE((out.rightCols(3).array() == 7).all()) << "nothing is written behind the columns";
}

}  // namespace

TEST(RowProduct, IsTheProductForEverySizeAndWritesNothingElse) {
  for (const int rows : {1, 2, 7, 8, 9, 23})
    for (const int depth : {1, 2, 13})
      for (const int columns : {1, 3, 8, 15, 16, 17, 64, 65, 130}) {
        expectProduct<float>(rows, depth, columns, 2e-7);
        expectProduct<double>(rows, depth, columns, 1e-15);
      }
}

TEST(AlignedRows, BeginAtCacheLinesAndKeepTheirNumbers) {
  AlignedRows<float> rows(3, 17);
  EXPECT_EQ(rows.stride(), 32);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(reinterpret_cast<std::uintptr_t>(rows.row(i)) % 64, 0u);
  rows.row(2)[16] = 5;
  rows.resize(3, 20);  // as many lines
  EXPECT_EQ(rows.row(2)[16], 5);
  rows.resize(3, 40);
  EXPECT_EQ(rows.row(2)[16], 0);
}
