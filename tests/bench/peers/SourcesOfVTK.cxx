/// What VTK's own filters take at the same number of points: a parametric surface, and the normals of the face's.
#include <benchmark/benchmark.h>
#include <vtkNew.h>
#include <vtkParametricEllipsoid.h>
#include <vtkParametricFunctionSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include "FrameSurface.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkOrderedGeometryFilter.h"
#include "vtkPDEFaceFilter.h"

namespace {

/// An ellipsoid, one of the cheapest functions there are, with normals from its derivatives.
void parametricSource(benchmark::State& state) {
  vtkNew<vtkParametricEllipsoid> ellipsoid;
  ellipsoid->SetXRadius(0.7);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(ellipsoid);
  source->SetUResolution(FrameSurface::usualColumns + 1);
  source->SetVResolution(FrameSurface::usualRows);
  source->SetScalarModeToNone();
  for (auto _ : state) {
    source->Modified();
    source->Update();
  }
  state.counters["points"] = source->GetOutput()->GetNumberOfPoints();
}

void polyDataNormals(benchmark::State& state) {
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkPDEFaceFilter> face;
  vtkNew<vtkOrderedGeometryFilter> polygons;
  face->SetInputConnection(reader->GetOutputPort());
  polygons->SetInputConnection(face->GetOutputPort());
  polygons->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(polygons->GetOutput());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SplittingOff();
  normals->ConsistencyOff();
  for (auto _ : state) {
    data->Modified();
    normals->Update();
  }
  state.counters["points"] = normals->GetOutput()->GetNumberOfPoints();
}

}  // namespace

BENCHMARK(parametricSource)->Name("peer/VTK/parametricSource");
BENCHMARK(polyDataNormals)->Name("peer/VTK/polyDataNormals");
