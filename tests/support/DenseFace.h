#pragma once

#include <random>

#include "BoundaryCurveData.h"
#include "FaceTemplate.h"
#include "ReferenceFace.h"
#include "TriangleMesh.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

/// The generic face as a scan: its spline surface with vertices at other places than those of the curves, and landmarks
/// that lie on it.
struct DenseFace {
  mien::TriangleMesh mesh;
  mien::FaceLandmarks landmarks;

  explicit DenseFace(int rows = 225, int columns = 221) : mesh(surface(rows, columns)), landmarks(onSurface()) {}

  static mien::TriangleMesh surface(int rows, int columns) {
    vtkNew<vtkPolyData> curves;
    mien::writeFaceCurves(mien::referenceFace(), curves);
    vtkNew<vtkPDEFaceFilter> face;
    face->SetInputData(curves);
    face->SetResolution(rows, columns);
    face->SetUniformRows(true);
    face->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    face->Update();
    vtkStructuredGrid* grid = face->GetOutput();
    int size[3];
    grid->GetDimensions(size);
    const int across = size[0] == columns + 1 ? size[0] : size[1], down = size[0] == columns + 1 ? size[1] : size[0];
    mien::TriangleMesh mesh;
    mesh.vertices.resize(across * down, 3);
    for (int i = 0; i < across * down; ++i) grid->GetPoint(i, mesh.vertices.row(i).data());
    mesh.triangles.resize(2 * (across - 1) * (down - 1), 3);
    const int stepAcross = size[0] == columns + 1 ? 1 : size[0], stepDown = size[0] == columns + 1 ? size[0] : 1;
    int t = 0;
    for (int r = 0; r + 1 < down; ++r)
      for (int c = 0; c + 1 < across; ++c) {
        const int a = r * stepDown + c * stepAcross;
        mesh.triangles.row(t++) << a, a + stepDown, a + stepAcross;
        mesh.triangles.row(t++) << a + stepAcross, a + stepDown, a + stepDown + stepAcross;
      }
    return mesh;
  }

  static mien::FaceLandmarks onSurface() {
    mien::FaceTemplate face = mien::referenceTemplate();
    for (auto& place : face.places) place.offset.setZero();
    return face.landmarksOn(face.mesh.vertices);
  }

  /// Triangles around random points are taken out.
  void makeHoles(int count, double radius) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> any(0, static_cast<int>(mesh.vertices.rows()) - 1);
    std::vector<Eigen::Vector3d> middles;
    for (int i = 0; i < count; ++i) middles.push_back(mesh.vertices.row(any(random)));
    int kept = 0;
    for (int t = 0; t < mesh.triangles.rows(); ++t) {
      const Eigen::Vector3d p = mesh.vertices.row(mesh.triangles(t, 0));
      bool inside = false;
      for (const auto& middle : middles) inside = inside || (p - middle).norm() < radius;
      if (!inside) mesh.triangles.row(kept++) = mesh.triangles.row(t);
    }
    mesh.triangles.conservativeResize(kept, 3);
  }

  void addNoise(double deviation) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, deviation);
    for (int i = 0; i < mesh.vertices.rows(); ++i)
      for (int k = 0; k < 3; ++k) mesh.vertices(i, k) += noise(random);
  }
};
