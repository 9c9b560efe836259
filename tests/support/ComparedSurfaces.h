#pragma once

#include "ErrorCounter.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceDistanceFilter.h"

/// Around the origin, of this many points around it both ways.
inline vtkSmartPointer<vtkPolyData> sphere(double radius, int resolution = 32) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// A square from -size to size at a height, of resolution x resolution cells.
inline vtkSmartPointer<vtkPolyData> plane(double size, double height, int resolution) {
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-size, -size, height);
  source->SetPoint1(size, -size, height);
  source->SetPoint2(-size, size, height);
  source->SetResolution(resolution, resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// Two surfaces in the filter that measures their distance.
struct Comparison {
  vtkNew<vtkSurfaceDistanceFilter> filter;
  ErrorCounter errors{filter};

  Comparison(vtkDataObject* surface, vtkDataObject* reference) {
    filter->SetInputData(surface);
    filter->SetReferenceData(reference);
  }
  vtkDataArray* distances(int port = 0) {
    return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port))->GetPointData()->GetArray("Distance");
  }
};
