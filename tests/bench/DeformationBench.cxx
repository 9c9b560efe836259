/// Deforming points by tables and fitting recordings, beside memcpy and a plain loop of the same arithmetic in the same
/// run.
#include <benchmark/benchmark.h>

#include <Eigen/QR>
#include <cmath>
#include <cstring>

#include "DefaultRegions.h"
#include "FDTData.h"
#include "NamedTables.h"
#include "TableDeformation.h"
#include "TableFit.h"
#include "vtkCellArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

using namespace mien;

namespace {

constexpr int pointCount = 100000;

/// Points all over a face of pupil unit 31 mm.
std::vector<DeformationPoint> facePoints() {
  std::vector<DeformationPoint> points(pointCount);
  for (int i = 0; i < pointCount; ++i) {
    const double x = -1.0 + 2.0 * (i % 316) / 316.0, y = -1.0 + 2.0 * (i / 316) / 317.0;
    points[i].position = Eigen::Vector3d(70.0 * x, 85.0 * y - 30.0, 80.0);
  }
  return points;
}

PupilNormalisation pupils() {
  PupilNormalisation result;
  result.set({31.0, 0.0, 80.0}, {-31.0, 0.0, 80.0});
  return result;
}

void smoothTable(benchmark::State& state) {
  const TableDeformation weights(facePoints(), pupils(), defaultRegions(), true);
  std::vector<Eigen::Vector2d> moves(pointCount);
  const DeformationTable& table = *namedTable("joy");
  for (auto _ : state) {
    weights.displacements(table, table.largestDisplacement, 1.0, 0, pointCount, moves.data());
    benchmark::ClobberMemory();
  }
}

/// One quadratic map for all points: what no table can be quicker than.
void oneQuadraticForAll(benchmark::State& state) {
  const std::vector<DeformationPoint> points = facePoints();
  std::vector<Eigen::Vector2d> moves(pointCount);
  const QuadraticMap& map = namedTable("joy")->maps[0];
  for (auto _ : state) {
    for (int i = 0; i < pointCount; ++i) moves[i] = map.apply(points[i].position.head<2>());
    benchmark::ClobberMemory();
  }
}

void weightsOfRegions(benchmark::State& state) {
  const std::vector<DeformationPoint> points = facePoints();
  for (auto _ : state) benchmark::DoNotOptimize(TableDeformation(points, pupils(), defaultRegions(), true).size());
}

vtkSmartPointer<vtkPolyData> faceData() {
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const DeformationPoint& point : facePoints()) places->InsertNextPoint(point.position.data());
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  return data;
}

/// The same points as a mesh of 198,000 triangles with normals.
vtkSmartPointer<vtkPolyData> faceMesh() {
  constexpr int columns = 316, rows = pointCount / columns;
  auto data = faceData();
  vtkNew<vtkCellArray> triangles;
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const vtkIdType a = row * columns + column;
      triangles->InsertNextCell({a, a + 1, a + columns});
      triangles->InsertNextCell({a + 1, a + columns + 1, a + columns});
    }
  data->SetPolys(triangles);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < pointCount; ++i) normals->InsertNextTuple3(0.0, 0.0, 1.0);
  data->GetPointData()->SetNormals(normals);
  return data;
}

void changeStrength(benchmark::State& state, vtkPolyData* data) {
  vtkSMPTools::Initialize(1);
  vtkNew<vtkTable> table;
  writeFDT(*namedTable("joy"), table);
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputData(data);
  filter->SetTableData(table);
  filter->SetLeftPupil(31.0, 0.0, 80.0);
  filter->SetRightPupil(-31.0, 0.0, 80.0);
  double strength = 0.0;
  filter->Update();
  for (auto _ : state) {
    filter->SetStrength(strength += 1e-4);
    filter->Update();
  }
}

void filterWithKeptWeights(benchmark::State& state) {
  changeStrength(state, faceData());
}

/// Points, and normals turned by those of the polygons.
void filterOfAMeshWithNormals(benchmark::State& state) {
  changeStrength(state, faceMesh());
}

/// What VTK takes for the normals of that mesh alone.
void normalsOfThatMeshByVTK(benchmark::State& state) {
  const auto data = faceMesh();
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(data);
  filter->SplittingOff();
  filter->ConsistencyOff();
  for (auto _ : state) {
    data->Modified();
    filter->Update();
  }
}

void memcpyOfDisplacements(benchmark::State& state) {
  std::vector<char> from(pointCount * sizeof(Eigen::Vector2d), 1), to(from.size(), 2);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
}

/// 240 markers on 16 rows over the face, moved by the mean joy and a little more.
TableSamples recording() {
  TableSamples samples;
  samples.before.resize(240, 2);
  samples.after.resize(240, 2);
  for (int i = 0; i < 240; ++i) {
    samples.before.row(i) << -1.8 + 3.6 * (i % 15) / 14.0, -3.8 + 5.4 * (i / 15) / 15.0;
    const int region = defaultRegions().nearest(samples.before.row(i));
    samples.regions.push_back(region);
    samples.after.row(i) = namedTable("joy")->maps[region - 1].apply(samples.before.row(i)).transpose();
    samples.after(i, 1) += 0.01 * std::sin(7.0 * i);
  }
  return samples;
}

void fitOfARecording(benchmark::State& state) {
  const TableSamples samples = recording();
  for (auto _ : state) {
    TableFit fit;
    benchmark::DoNotOptimize(fit.fit(samples));
  }
}

/// 16 decompositions of the same sizes with nothing around them.
void sixteenDecompositions(benchmark::State& state) {
  const Eigen::MatrixXd design = Eigen::MatrixXd::Random(15, 6), target = Eigen::MatrixXd::Random(15, 2);
  for (auto _ : state)
    for (int i = 0; i < 16; ++i) benchmark::DoNotOptimize(design.colPivHouseholderQr().solve(target).eval().data());
}

}  // namespace

BENCHMARK(smoothTable)->Unit(benchmark::kMicrosecond);
BENCHMARK(filterWithKeptWeights)->Unit(benchmark::kMicrosecond);
BENCHMARK(filterOfAMeshWithNormals)->Unit(benchmark::kMicrosecond);
BENCHMARK(normalsOfThatMeshByVTK)->Unit(benchmark::kMicrosecond);
BENCHMARK(weightsOfRegions)->Unit(benchmark::kMicrosecond);
BENCHMARK(oneQuadraticForAll)->Unit(benchmark::kMicrosecond);
BENCHMARK(memcpyOfDisplacements)->Unit(benchmark::kMicrosecond);
BENCHMARK(fitOfARecording)->Unit(benchmark::kMicrosecond);
BENCHMARK(sixteenDecompositions)->Unit(benchmark::kMicrosecond);
