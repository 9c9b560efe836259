#include "PDESurface.h"

#include <algorithm>
#include <sstream>

namespace mien {

namespace {

/// Past this no digit of a surface is true: e^(a (N + 1) / 3) of the four-curve scheme where faces are refused.
constexpr double largestFactor = 1e37;

/// One sentence when conditions make no surface, or one that exceeds its curves beyond all sense, or nothing.
std::string describeFault(const Eigen::MatrixXd& u, const SurfacePiece& piece, const HarmonicSplit& split) {
  if (u.size() == 0)
    return "the conditions of a patch do not determine a surface; give as many independent ones as its order";
  if (u.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= largestFactor) return {};
  std::ostringstream fault;
  fault << "with a = " << piece.smoothing << " and N = " << split.modes()
        << " the surface exceeds its curves more than " << largestFactor
        << " times and loses all precision; choose a smaller a or N";
  return fault.str();
}

/// A grid from the first column of a strip on.
template <class Scalar>
OutputRows<Scalar> rowsFrom(Eigen::Map<RowMajor<Scalar>>* grid, int strip) {
  if (!grid) return {};
  return {grid->data() + 3 * strip * columnsOfStrip, grid->cols()};
}

}  // namespace

template <class Scalar>
PDESurface<Scalar>::PDESurface(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
                               const Eigen::VectorXd& v, int derivatives)
    : split_(split), data_(split, curveCount), columnCount_(static_cast<int>(v.size())) {
  for (const SurfacePiece& piece : pieces)
    if (!piece.u.empty()) addBlock(piece, data_.add(piece), derivatives);
  placeData();
  coefficients_ = std::make_unique<BoundaryCoefficients>(split, curveCount, data_.count());
  changes_.assign(data_.count(), 0);
  for (int order = 0; order <= derivatives; ++order) {
    fields_.emplace_back(split, v, order);
    b_.emplace_back();
    if (stripCount() == 1) fields_[order].makeRoom(data_.count(), b_[order]);
  }
}

template <class Scalar>
void PDESurface<Scalar>::addBlock(const SurfacePiece& piece, std::vector<int> data, int derivatives) {
  rowCount_ = std::max(rowCount_, piece.firstRow + static_cast<int>(piece.u.size()));
  Block block{piece.firstRow, std::move(data), {}, {}};
  const auto conditions = static_cast<Eigen::Index>(block.data.size());
  for (int order = 0; order <= derivatives; ++order) {
    RowMajor<Scalar>& matrix = block.matrices.emplace_back(piece.u.size(), conditions * split_.count());
    for (int part = 0; part < split_.count(); ++part) {
      const Eigen::MatrixXd u = pieceOperator(piece, split_, part, order);
      fault_ = describeFault(u, piece, split_);
      if (!fault_.empty()) return;
      matrix.middleCols(part * conditions, conditions) = u.template cast<Scalar>();
    }
  }
  u_.push_back(std::move(block));
}

/// Row j D + d of B is part j of datum d, and D is known only when all pieces have told their data.
template <class Scalar>
void PDESurface<Scalar>::placeData() {
  for (Block& block : u_)
    for (int part = 0; part < split_.count(); ++part)
      for (const int datum : block.data) block.places.push_back(static_cast<long>(part) * data_.count() + datum);
}

template <class Scalar>
void PDESurface<Scalar>::setCurves(const ClosedCurves& curves) {
  ++version_;
  const std::vector<DataRange>& changed = coefficients_->setCurves(curves);
  if (changed.empty()) return;
  data_.derive(*coefficients_);
  rounded_ = coefficients_->values().template cast<Scalar>();
  for (const DataRange& range : changed) {
    std::fill_n(changes_.begin() + range.first, range.count(), version_);
    update(range);
  }
  for (int datum = data_.curveCount(); datum < data_.count(); ++datum)
    changes_[datum] = latestOf(data_.sources(datum - data_.curveCount()));
  update({data_.curveCount(), data_.count()});
}

template <class Scalar>
void PDESurface<Scalar>::update(const DataRange& changed) {
  if (stripCount() > 1) return;
  for (size_t order = 0; order < b_.size(); ++order)
    fields_[order].sample(rounded_.data(), data_.count(), changed, 0, b_[order]);
}

/// The version that changed the last of some data.
template <class Scalar>
long PDESurface<Scalar>::latestOf(const std::vector<int>& data) const {
  long latest = 0;
  for (const int datum : data) latest = std::max(latest, changes_[datum]);
  return latest;
}

/// B at the columns of a strip: it stays until the thread asks for another.
template <class Scalar>
BoundaryPlanes<Scalar> PDESurface<Scalar>::boundary(int order, int strip) const {
  constexpr int mostOrders = 3;
  thread_local AlignedRows<Scalar> ofThread[mostOrders];
  const AlignedRows<Scalar>* b = &b_[order];
  if (stripCount() > 1) {
    fields_[order].makeRoom(data_.count(), ofThread[order]);
    fields_[order].sample(rounded_.data(), data_.count(), {0, data_.count()}, strip, ofThread[order]);
    b = &ofThread[order];
  }
  return {b->row(0), b->stride(), columnsOf(strip)};
}

/// Those of a block's rows that lie in the part; maybe none.
template <class Scalar>
OperatorRows<Scalar> PDESurface<Scalar>::rowsOf(const Block& block, int order, const SurfacePart& part) const {
  const RowMajor<Scalar>& u = block.matrices[order];
  const int begin = std::max(part.firstRow - block.firstRow, 0);
  const int end = std::min(part.firstRow + part.rows - block.firstRow, static_cast<int>(u.rows()));
  return {u.data() + begin * u.cols(), std::max(0, end - begin), static_cast<int>(u.cols()), block.places.data()};
}

// S = U B, piece by piece.
template <class Scalar>
void PDESurface<Scalar>::evaluate(int orderU, int orderV, const SurfacePart& part,
                                  const OutputRows<Scalar>& out) const {
  const BoundaryPlanes<Scalar> b = boundary(orderV, part.strip);
  for (const Block& block : u_) {
    const OperatorRows<Scalar> u = rowsOf(block, orderU, part);
    if (u.rows > 0) vectorRows<Scalar>(u, b, out.below(std::max(0, block.firstRow - part.firstRow)));
  }
}

template <class Scalar>
bool PDESurface<Scalar>::evaluateWithNormals(const SurfacePart& part, const SurfaceRowsOutput<Scalar>& out,
                                             long since) const {
  bool isComplete = true;
  const BoundaryPlanes<Scalar> b = boundary(0, part.strip), slopes = boundary(1, part.strip);
  for (const Block& block : u_) {
    const OperatorRows<Scalar> u = rowsOf(block, 0, part);
    if (u.rows == 0 || latestOf(block.data) <= since) continue;
    isComplete &= surfaceRows<Scalar>(u, rowsOf(block, 1, part).first, b, slopes.first,
                                      out.below(std::max(0, block.firstRow - part.firstRow)));
  }
  return isComplete;
}

template <class Scalar>
void PDESurface<Scalar>::evaluate(int orderU, int orderV, int firstRow, Grid grid) const {
  for (int strip = 0; strip < stripCount(); ++strip)
    evaluate(orderU, orderV, SurfacePart{strip, firstRow, static_cast<int>(grid.rows())},
             rowsFrom<Scalar>(&grid, strip));
}

template <class Scalar>
void PDESurface<Scalar>::evaluateWithNormals(int firstRow, Grid s, Grid normals, Grid* su, Grid* sv, long since) const {
  const int rows = static_cast<int>(s.rows());
  bool isComplete = true;
  for (int strip = 0; strip < stripCount(); ++strip)
    isComplete &= evaluateWithNormals(SurfacePart{strip, firstRow, rows},
                                      {rowsFrom<Scalar>(&s, strip), rowsFrom<Scalar>(&normals, strip),
                                       rowsFrom<Scalar>(su, strip), rowsFrom<Scalar>(sv, strip)},
                                      since);
  if (!isComplete) repeatNormals<Scalar>(rows, columnCount_, {normals.data(), normals.cols()});
}

template class PDESurface<float>;
template class PDESurface<double>;

}  // namespace mien
