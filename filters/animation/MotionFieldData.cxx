#include "MotionFieldData.h"

#include <algorithm>
#include <cmath>

#include "BoundaryCurveData.h"
#include "SurfaceContour.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

using Points = MotionField::Points;

constexpr double lastDigit = 1e15;  // u is stored as 1 - u, which leaves noise beyond

/// How the points of a mesh are numbered once a grid's closing column, which repeats the first, is left out.
struct Numbering {
  int width = 0;    ///< stored columns of a grid; 0: no grid
  int columns = 0;  ///< without the closing one

  explicit Numbering(vtkPointSet* mesh) {
    auto* grid = vtkStructuredGrid::SafeDownCast(mesh);
    int size[3] = {0, 0, 0};
    if (grid) grid->GetDimensions(size);
    if (!grid || size[2] != 1 || size[0] < 2) return;
    width = columns = size[0];
    if (isClosed(grid, size[1])) --columns;
  }

  bool isLeftOut(vtkIdType point) const { return width > columns && point % width == columns; }
  int operator()(vtkIdType point) const {
    if (width == columns) return static_cast<int>(point);
    return static_cast<int>(point / width * columns + point % width % columns);
  }

 private:
  bool isClosed(vtkStructuredGrid* grid, int rows) const {
    for (vtkIdType row = 0; row < rows; ++row) {
      double first[3], last[3];
      grid->GetPoint(row * width, first);
      grid->GetPoint(row * width + width - 1, last);
      if (!std::equal(first, first + 3, last)) return false;
    }
    return rows > 0;
  }
};

std::vector<long long> keptPoints(vtkPointSet* mesh, const Numbering& numbering) {
  std::vector<long long> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    if (!numbering.isLeftOut(i)) ids.push_back(i);
  return ids;
}

Points tuples(vtkDataArray* array, const std::vector<long long>& ids) {
  Points points(array && array->GetNumberOfComponents() == 3 ? ids.size() : 0, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) array->GetTuple(ids[i], points.row(i).data());
  return points;
}

Points pointsOf(vtkPointSet* data, const std::vector<long long>& ids) {
  Points points(ids.size(), 3);
  for (size_t i = 0; i < ids.size(); ++i) data->GetPoint(ids[i], points.row(i).data());
  return points;
}

void readParameters(vtkPointSet* mesh, MotionField& field) {
  vtkDataArray* coordinates = mesh->GetPointData()->GetArray("TextureCoordinates");
  if (!coordinates || coordinates->GetNumberOfComponents() != 2 || field.columns == 0) return;
  for (const long long id : field.ids) {
    field.u.push_back(std::round((1.0 - coordinates->GetComponent(id, 1)) * lastDigit) / lastDigit);
    field.v.push_back(2.0 * M_PI * static_cast<double>(field.v.size() % field.columns) / field.columns);
  }
}

/// Calls use(cell, ids) for each polygon that is seen.
template <class Use>
void forPolygons(vtkPointSet* mesh, const Use& use) {
  auto* grid = vtkStructuredGrid::SafeDownCast(mesh);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
    const int type = mesh->GetCellType(cell);
    const bool isFace = type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON || type == VTK_TRIANGLE_STRIP;
    if (!isFace || (grid && !grid->IsCellVisible(cell))) continue;
    mesh->GetCellPoints(cell, ids);
    use(cell, ids.Get(), type == VTK_TRIANGLE_STRIP);
  }
}

void readPatches(vtkPointSet* mesh, const Numbering& numbering, MotionField& field) {
  vtkDataArray* patchOf = mesh->GetCellData()->GetArray("PatchId");
  if (!patchOf) return;
  field.patches.assign(field.ids.size(), {1 << 30, -1});
  forPolygons(mesh, [&](vtkIdType cell, vtkIdList* ids, bool) {
    const int patch = static_cast<int>(patchOf->GetComponent(cell, 0));
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      std::array<int, 2>& around = field.patches[numbering(ids->GetId(i))];
      around = {std::min(around[0], patch), std::max(around[1], patch)};
    }
  });
}

void readTriangles(vtkPointSet* drawn, const Numbering& numbering, TriangleMesh& surface) {
  std::vector<Eigen::RowVector3i> triangles;
  forPolygons(drawn, [&](vtkIdType, vtkIdList* ids, bool strip) {
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i) {
      const int a = numbering(ids->GetId(strip ? i - 2 : 0)), b = numbering(ids->GetId(i - 1)),
                c = numbering(ids->GetId(i));
      const bool turned = strip && i % 2 == 1;
      if (a != b && b != c && c != a) triangles.emplace_back(a, turned ? c : b, turned ? b : c);
    }
  });
  surface.triangles.resize(triangles.size(), 3);
  for (size_t i = 0; i < triangles.size(); ++i) surface.triangles.row(i) = triangles[i];
}

/// Grids of a PDE face are wound inwards; the normals tell.
void windOutwards(const Points& normals, TriangleMesh& surface) {
  if ((vertexNormals(surface).array() * normals.array()).sum() < 0.0)
    surface.triangles.col(1).swap(surface.triangles.col(2));
}

/// Rows of a grid between cells of different patches.
void readSeams(vtkPointSet* drawn, const Numbering& numbering, MotionField& field) {
  vtkDataArray* patchOf = drawn->GetCellData()->GetArray("PatchId");
  if (!patchOf || numbering.width < 2) return;
  const int cells = numbering.width - 1;
  for (vtkIdType row = 1; row * cells < drawn->GetNumberOfCells(); ++row) {
    if (patchOf->GetComponent((row - 1) * cells, 0) == patchOf->GetComponent(row * cells, 0)) continue;
    Points seam(numbering.width, 3);
    for (int column = 0; column < numbering.width; ++column)
      drawn->GetPoint(row * numbering.width + column, seam.row(column).data());
    field.seams.push_back(seam);
  }
}

void readDrawn(vtkPointSet* drawn, MotionField& field) {
  const Numbering numbering(drawn);
  const std::vector<long long> ids = keptPoints(drawn, numbering);
  field.surface.vertices = pointsOf(drawn, ids);
  readTriangles(drawn, numbering, field.surface);
  field.surfaceNormals = tuples(drawn->GetPointData()->GetArray("Normals"), ids);
  if (field.surfaceNormals.rows() > 0)
    windOutwards(field.surfaceNormals, field.surface);
  else
    field.surfaceNormals = vertexNormals(field.surface);
  readSeams(drawn, numbering, field);
}

/// Turns what is drawn as the vectors were turned.
std::string turnBack(vtkPointSet* drawn, MotionField& field) {
  HeadRotation rotation;
  const std::string fault = readHeadRotation(drawn->GetFieldData(), rotation);
  if (!fault.empty() || !rotation.turns()) return fault;
  Points vertices = field.surface.vertices;
  rotation.undo(vertices);
  field.surface.vertices = vertices;
  for (Points& seam : field.seams) rotation.undo(seam);
  field.surfaceNormals = (field.surfaceNormals * rotation.rotation).eval();
  return {};
}

}  // namespace

std::string readMotionField(vtkPolyData* vectors, vtkPointSet* mesh, vtkPointSet* drawn, bool turnedBack,
                            MotionField& field) {
  vtkDataArray* moves = vectors->GetPointData()->GetArray("MotionVector");
  if (!moves || moves->GetNumberOfComponents() != 3) return "there are no motion vectors; update the filter first";
  if (vectors->GetNumberOfPoints() != mesh->GetNumberOfPoints())
    return "the motion vectors do not start from the points of this surface";
  const Numbering numbering(mesh);
  MotionField read;
  read.ids = keptPoints(mesh, numbering);
  read.columns = numbering.columns;
  read.origins = pointsOf(vectors, read.ids);
  read.vectors = tuples(moves, read.ids);
  read.normals = tuples(vectors->GetPointData()->GetArray("Normals"), read.ids);
  readParameters(mesh, read);
  readPatches(mesh, numbering, read);
  readDrawn(drawn, read);
  const std::string fault = turnedBack ? turnBack(drawn, read) : std::string();
  if (!fault.empty()) return fault;
  if (read.normals.rows() == 0 && drawn == mesh) read.normals = read.surfaceNormals;
  field = std::move(read);
  return {};
}

}  // namespace mien
