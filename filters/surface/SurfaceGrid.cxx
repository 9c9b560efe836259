#include "SurfaceGrid.h"

#include <algorithm>

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

/// Points that one thread computes at a time: the rows of S, S_u, S_v and the normals stay in its cache.
constexpr vtkIdType pointsPerTask = 32768;
/// Points between two looks at the abort flag; about 0.05 s of work on one core.
constexpr vtkIdType pointsPerSlab = 1 << 20;

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
    if (this->computeRows(arrays, self)) this->assemble(arrays, output);
  }

 private:
  using Array = typename ReusedArrays<Scalar>::Array;
  using Grid = typename PDESurface<Scalar>::Grid;
  struct Arrays {
    Array points, normals;
    std::vector<Array> derivatives;  ///< S_u, S_v, where wanted
    std::vector<Array> curvatures;   ///< mean, Gaussian, largest and smallest, where wanted
  };

  /// All rows in slabs; false when the algorithm was aborted.
  bool computeRows(const Arrays& arrays, vtkAlgorithm* self) const {
    const int rows = rowsOf(this->Layout);
    const int slab = static_cast<int>(std::max<vtkIdType>(1, pointsPerSlab / columnsOf(this->Layout)));
    const vtkIdType grain = std::max<vtkIdType>(1, pointsPerTask / columnsOf(this->Layout));
    for (int begin = 0; begin < rows; begin += slab) {
      if (self->GetAbortExecute()) return false;
      const int end = std::min(rows, begin + slab);
      vtkSMPTools::For(begin, end, grain, [&](vtkIdType first, vtkIdType last) {
        for (vtkIdType row = first; row < last; row += grain)
          this->computeTask(arrays, row, std::min(last, row + grain));
      });
      self->UpdateProgress(static_cast<double>(end) / rows);
    }
    return !self->GetAbortExecute();
  }

  void computeTask(const Arrays& arrays, vtkIdType first, vtkIdType last) const {
    const vtkIdType columns = columnsOf(this->Layout), rows = last - first;
    const auto grid = [&](const Array& array) {
      return Grid(array->GetPointer(3 * first * columns), rows, 3 * columns);
    };
    const int row = this->Layout.extent[2] + static_cast<int>(first);
    if (arrays.derivatives.empty() && arrays.curvatures.empty()) {
      this->Surface.evaluateWithNormals(row, grid(arrays.points), grid(arrays.normals));
      return;
    }
    thread_local RowMajor<Scalar> scratch;
    scratch.resize(2 * rows, 3 * columns);
    const bool kept = !arrays.derivatives.empty();
    Grid su = kept ? grid(arrays.derivatives[0]) : Grid(scratch.data(), rows, 3 * columns);
    Grid sv = kept ? grid(arrays.derivatives[1]) : Grid(scratch.data() + rows * 3 * columns, rows, 3 * columns);
    this->Surface.evaluateWithNormals(row, grid(arrays.points), grid(arrays.normals), &su, &sv);
    if (!arrays.curvatures.empty()) this->computeCurvatures(arrays.curvatures, first, su, sv);
  }

  /// Of the rows that su and sv hold; `first` counts the rows of the extent.
  void computeCurvatures(const std::vector<Array>& arrays, vtkIdType first, const Grid& su, const Grid& sv) const {
    const vtkIdType columns = columnsOf(this->Layout), rows = su.rows();
    thread_local RowMajor<Scalar> scratch;
    scratch.resize(3 * rows, 3 * columns);
    const auto second = [&](int orderU, int orderV) {
      const Grid grid(scratch.data() + orderV * rows * 3 * columns, rows, 3 * columns);
      this->Surface.evaluate(orderU, orderV, this->Layout.extent[2] + static_cast<int>(first), grid);
      return grid;
    };
    const Grid suu = second(2, 0), suv = second(1, 1), svv = second(0, 2);
    for (vtkIdType i = 0; i < rows * columns; ++i) {
      const auto at = [i](const Grid& grid) {
        return Eigen::Vector3d(
            Eigen::Map<const Eigen::Matrix<Scalar, 3, 1>>(grid.data() + 3 * i).template cast<double>());
      };
      const SurfaceCurvature curvature({Eigen::Vector3d::Zero(), at(su), at(sv), at(suu), at(suv), at(svv)});
      const double values[] = {curvature.mean, curvature.gaussian, curvature.maximum, curvature.minimum};
      for (size_t k = 0; k < arrays.size(); ++k)
        arrays[k]->SetValue(first * columns + i, static_cast<Scalar>(values[k]));
    }
  }

  void assemble(const Arrays& arrays, vtkStructuredGrid* output) const {
    vtkNew<vtkPoints> points;
    points->SetData(arrays.points);
    output->SetExtent(const_cast<int*>(this->Layout.extent));
    output->SetPoints(points);
    output->GetPointData()->SetNormals(arrays.normals);
    output->GetPointData()->SetTCoords(this->TextureCoordinates);
    for (const auto* group : {&arrays.derivatives, &arrays.curvatures})
      for (const Array& array : *group) output->GetPointData()->AddArray(array);
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
