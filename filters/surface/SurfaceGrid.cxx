#include "SurfaceGrid.h"

#include <algorithm>
#include <atomic>

#include "PDESurface.h"
#include "ReusedArrays.h"
#include "SurfaceCurvature.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace mien {

namespace {

/// Points that one thread computes at a time. In a wide grid every task makes B anew: 1/15 of its work at 1,000 rows.
constexpr vtkIdType pointsPerTask = 1 << 17;
/// The same where tangent vectors or second derivatives pass through buffers of the thread.
constexpr vtkIdType pointsPerBufferedTask = 1 << 15;
/// Points between two looks at the abort flag; about 0.05 s of work on one core.
constexpr vtkIdType pointsPerSlab = 1 << 23;

int columnsOf(const SurfaceGridLayout& layout) {
  return layout.extent[1] - layout.extent[0] + 1;
}

int rowsOf(const SurfaceGridLayout& layout) {
  return layout.extent[3] - layout.extent[2] + 1;
}

double columnV(const SurfaceGridLayout& layout, int column) {
  return 2.0 * M_PI * (column % layout.columns) / layout.columns;
}

/// The closing column is computed at v = 0, so that it repeats the first to the bit.
Eigen::VectorXd columnParameters(const SurfaceGridLayout& layout) {
  Eigen::VectorXd v(columnsOf(layout));
  for (int i = 0; i < v.size(); ++i) v[i] = columnV(layout, layout.extent[0] + i);
  return v;
}

vtkSmartPointer<vtkFloatArray> textureCoordinates(const SurfaceGridLayout& layout) {
  auto coordinates = vtkSmartPointer<vtkFloatArray>::New();
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(columnsOf(layout)) * rowsOf(layout));
  float* next = coordinates->GetPointer(0);
  for (int row = layout.extent[2]; row <= layout.extent[3]; ++row)
    for (int column = layout.extent[0]; column <= layout.extent[1]; ++column) {
      *next++ = static_cast<float>(column) / layout.columns;
      *next++ = static_cast<float>(1.0 - layout.faceU[row]);
    }
  return coordinates;
}

vtkSmartPointer<vtkIntArray> patchIds(const SurfaceGridLayout& layout) {
  auto ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName("PatchId");
  for (int row = layout.extent[2]; row < layout.extent[3]; ++row)
    for (int column = layout.extent[0]; column < layout.extent[1]; ++column)
      ids->InsertNextValue(layout.patchOfCells[row]);
  return ids;
}

/// A cell of the slit is hidden when its middle lies between the mouth corners.
bool liesInSlit(const SurfaceGridLayout& layout, int row, int column) {
  const double middle = 2.0 * M_PI * (column + 0.5) / layout.columns;
  return row == layout.slitRow && middle > layout.slitBegin && middle < layout.slitEnd;
}

vtkSmartPointer<vtkUnsignedCharArray> hiddenCells(const SurfaceGridLayout& layout) {
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  bool any = false;
  for (int row = layout.extent[2]; row < layout.extent[3]; ++row)
    for (int column = layout.extent[0]; column < layout.extent[1]; ++column) {
      const bool hidden = liesInSlit(layout, row, column);
      ghosts->InsertNextValue(hidden ? vtkDataSetAttributes::HIDDENCELL : 0);
      any = any || hidden;
    }
  return any ? ghosts : nullptr;
}

/// The pieces with their rows inside the extent alone: a part of a huge grid needs no operators for the rest.
std::vector<SurfacePiece> rowsInside(std::vector<SurfacePiece> pieces, const SurfaceGridLayout& layout) {
  for (SurfacePiece& piece : pieces) {
    const int rows = static_cast<int>(piece.u.size());
    const int begin = std::clamp(layout.extent[2] - piece.firstRow, 0, rows);
    const int end = std::clamp(layout.extent[3] + 1 - piece.firstRow, begin, rows);
    piece.u = std::vector<double>(piece.u.begin() + begin, piece.u.begin() + end);
    piece.firstRow += begin;
  }
  return pieces;
}

template <class Scalar>
class TypedSurfaceGrid : public SurfaceGrid {
 public:
  TypedSurfaceGrid(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split, int curveCount,
                   const SurfaceGridLayout& layout)
      : Layout(layout),
        Surface(rowsInside(pieces, layout), split, curveCount, columnParameters(layout), layout.curvatures ? 2 : 1),
        TextureCoordinates(textureCoordinates(layout)),
        PatchIds(patchIds(layout)),
        HiddenCells(hiddenCells(layout)) {}

  std::string fault() const override { return this->Surface.fault(); }

  void execute(const ClosedCurves& curves, bool derivatives, vtkAlgorithm* self, vtkStructuredGrid* output) override {
    this->Surface.setCurves(curves);
    const vtkIdType size = static_cast<vtkIdType>(columnsOf(this->Layout)) * rowsOf(this->Layout);
    Arrays arrays;
    arrays.points = this->Reused.take("Points", 3, size);
    arrays.normals = this->Reused.take("Normals", 3, size);
    if (derivatives) arrays.derivatives = {this->Reused.take("Su", 3, size), this->Reused.take("Sv", 3, size)};
    if (this->Layout.curvatures)
      for (const char* name : {"MeanCurvature", "GaussianCurvature", "MaximumCurvature", "MinimumCurvature"})
        arrays.curvatures.push_back(this->Reused.take(name, 1, size));
    if (!this->computeParts(arrays, self)) return;
    for (const Taken& taken : arrays.all()) this->Reused.setVersion(taken, this->Surface.version());
    this->assemble(arrays, output);
  }

 private:
  using Taken = typename ReusedArrays<Scalar>::Taken;
  using Rows = OutputRows<Scalar>;

  struct Arrays {
    Taken points, normals;
    std::vector<Taken> derivatives;  ///< S_u, S_v, where wanted
    std::vector<Taken> curvatures;   ///< mean, Gaussian, largest and smallest, where wanted

    std::vector<Taken> all() const {
      std::vector<Taken> all = {points, normals};
      for (const auto* group : {&derivatives, &curvatures}) all.insert(all.end(), group->begin(), group->end());
      return all;
    }

    /// The version that all of them hold.
    long version() const {
      const std::vector<Taken> taken = this->all();
      const bool areOne =
          std::all_of(taken.begin(), taken.end(), [&](const Taken& other) { return other.version == points.version; });
      return areOne && curvatures.empty() ? points.version : noVersion;
    }
  };

  /// All strips, some rows of each at a time; false when the algorithm was aborted.
  bool computeParts(const Arrays& arrays, vtkAlgorithm* self) const {
    const vtkIdType points = arrays.curvatures.empty() ? pointsPerTask : pointsPerBufferedTask;
    const int rows = rowsOf(this->Layout), strips = this->Surface.stripCount();
    const int rowsAtOnce = std::min<int>(rows, points / this->Surface.columnsOf(0));
    const vtkIdType count = static_cast<vtkIdType>(strips) * ((rows - 1) / rowsAtOnce + 1);
    const vtkIdType slab = std::max<vtkIdType>(1, pointsPerSlab / points);
    const long since = arrays.version();
    std::atomic<bool> isComplete{true};
    for (vtkIdType begin = 0; begin < count; begin += slab) {
      if (self->GetAbortExecute()) return false;
      const vtkIdType end = std::min(count, begin + slab);
      vtkSMPTools::For(begin, end, 1, [&](vtkIdType first, vtkIdType last) {
        for (vtkIdType task = first; task < last; ++task) {
          const int row = static_cast<int>(task / strips) * rowsAtOnce;
          const SurfacePart part{static_cast<int>(task % strips), row, std::min(rowsAtOnce, rows - row)};
          if (!this->computePart(arrays, part, since)) isComplete = false;
        }
      });
      self->UpdateProgress(static_cast<double>(end) / count);
    }
    if (!isComplete) repeatNormals<Scalar>(rows, columnsOf(this->Layout), this->rowsFrom(arrays.normals, {0, 0, rows}));
    return !self->GetAbortExecute();
  }

  /// An array of three components from the first point of a part on.
  Rows rowsFrom(const Taken& taken, const SurfacePart& part) const {
    const vtkIdType columns = columnsOf(this->Layout);
    return {taken.at(3 * (part.firstRow * columns + part.strip * columnsOfStrip)), 3 * columns};
  }

  /// @param part  its rows are counted from the first of the extent
  /// @return whether there is a normal everywhere
  bool computePart(const Arrays& arrays, SurfacePart part, long since) const {
    SurfaceRowsOutput<Scalar> out{this->rowsFrom(arrays.points, part), this->rowsFrom(arrays.normals, part), {}, {}};
    if (!arrays.derivatives.empty()) {
      out.su = this->rowsFrom(arrays.derivatives[0], part);
      out.sv = this->rowsFrom(arrays.derivatives[1], part);
    }
    if (arrays.curvatures.empty()) return this->Surface.evaluateWithNormals(this->inSurface(part), out, since);
    thread_local RowMajor<Scalar> tangents[2];
    if (arrays.derivatives.empty()) {
      out.su = this->buffer(tangents[0], part);
      out.sv = this->buffer(tangents[1], part);
    }
    const bool isComplete = this->Surface.evaluateWithNormals(this->inSurface(part), out, since);
    this->computeCurvatures(arrays.curvatures, part, out);
    return isComplete;
  }

  SurfacePart inSurface(const SurfacePart& part) const {
    return {part.strip, this->Layout.extent[2] + part.firstRow, part.rows};
  }

  Rows buffer(RowMajor<Scalar>& numbers, const SurfacePart& part) const {
    numbers.resize(part.rows, 3 * this->Surface.columnsOf(part.strip));
    return {numbers.data(), numbers.cols()};
  }

  void computeCurvatures(const std::vector<Taken>& arrays, const SurfacePart& part,
                         const SurfaceRowsOutput<Scalar>& tangents) const {
    thread_local RowMajor<Scalar> numbers[3];
    Rows second[3];  // S_uu, S_uv, S_vv
    for (int orderV = 0; orderV < 3; ++orderV) {
      second[orderV] = this->buffer(numbers[orderV], part);
      this->Surface.evaluate(2 - orderV, orderV, this->inSurface(part), second[orderV]);
    }
    for (int row = 0; row < part.rows; ++row)
      for (int column = 0; column < this->Surface.columnsOf(part.strip); ++column) {
        const auto at = [&](const Rows& rows) {
          return Eigen::Vector3d(
              Eigen::Map<const Eigen::Matrix<Scalar, 3, 1>>(rows.at(row, column)).template cast<double>());
        };
        const SurfaceCurvature curvature(
            {Eigen::Vector3d::Zero(), at(tangents.su), at(tangents.sv), at(second[0]), at(second[1]), at(second[2])});
        const double values[] = {curvature.mean, curvature.gaussian, curvature.maximum, curvature.minimum};
        const vtkIdType point = static_cast<vtkIdType>(part.firstRow + row) * columnsOf(this->Layout) +
                                part.strip * columnsOfStrip + column;
        for (size_t k = 0; k < arrays.size(); ++k) *arrays[k].at(point) = static_cast<Scalar>(values[k]);
      }
  }

  void assemble(const Arrays& arrays, vtkStructuredGrid* output) const {
    vtkNew<vtkPoints> points;
    points->SetData(arrays.points.array);
    output->SetExtent(const_cast<int*>(this->Layout.extent));
    output->SetPoints(points);
    output->GetPointData()->SetNormals(arrays.normals.array);
    output->GetPointData()->SetTCoords(this->TextureCoordinates);
    for (const auto* group : {&arrays.derivatives, &arrays.curvatures})
      for (const Taken& taken : *group) output->GetPointData()->AddArray(taken.array);
    output->GetCellData()->AddArray(this->PatchIds);
    if (this->HiddenCells) output->GetCellData()->AddArray(this->HiddenCells);
  }

  SurfaceGridLayout Layout;
  PDESurface<Scalar> Surface;
  ReusedArrays<Scalar> Reused;
  vtkSmartPointer<vtkFloatArray> TextureCoordinates;
  vtkSmartPointer<vtkIntArray> PatchIds;
  vtkSmartPointer<vtkUnsignedCharArray> HiddenCells;
};

}  // namespace

bool SurfaceGridLayout::operator==(const SurfaceGridLayout& other) const {
  return this->faceU == other.faceU && this->patchOfCells == other.patchOfCells && this->columns == other.columns &&
         this->slitRow == other.slitRow && this->slitBegin == other.slitBegin && this->slitEnd == other.slitEnd &&
         this->curvatures == other.curvatures && std::equal(this->extent, this->extent + 6, other.extent);
}

std::unique_ptr<SurfaceGrid> SurfaceGrid::make(const std::vector<SurfacePiece>& pieces, const HarmonicSplit& split,
                                               int curveCount, const SurfaceGridLayout& layout, bool doublePrecision) {
  if (doublePrecision) return std::make_unique<TypedSurfaceGrid<double>>(pieces, split, curveCount, layout);
  return std::make_unique<TypedSurfaceGrid<float>>(pieces, split, curveCount, layout);
}

}  // namespace mien
