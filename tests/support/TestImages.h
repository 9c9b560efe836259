#pragma once

#include <cmath>

#include "WarpMesh.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

/// A smooth picture of any type: every component a sum of waves of 40 and more pixels, in 0.1 .. 0.9 of `range`.
inline vtkSmartPointer<vtkImageData> wavyImage(int width, int height, int type, int components, double range) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < components; ++c)
        image->SetScalarComponentFromDouble(
            x, y, 0, c, range * (0.5 + 0.25 * std::sin(0.15 * x + c) + 0.15 * std::cos(0.11 * y - 0.04 * x + 2.0 * c)));
  return image;
}

/// An even mesh whose inner points are moved by up to `share` of the distance between points, each in its own way.
inline mien::WarpMesh bentMesh(int rows, int columns, double width, double height, double share, double phase) {
  mien::WarpMesh mesh = mien::evenMesh(rows, columns, width, height);
  for (int i = 1; i + 1 < rows; ++i)
    for (int j = 1; j + 1 < columns; ++j) {
      mesh.x(i, j) += share * width / (columns - 1) * std::sin(phase + 1.9 * i + 0.7 * j);
      mesh.y(i, j) += share * height / (rows - 1) * std::cos(phase + 0.6 * i + 2.3 * j);
    }
  return mesh;
}
