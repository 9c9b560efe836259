#pragma once

#include <cmath>
#include <string>

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkSmartPointer.h"

inline vtkSmartPointer<vtkImageData> readPicture(const std::string& name) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// The share of pixels that differ in some component from the one at the lower left corner, by more than 2 of 255.
inline double shareUnlikeCorner(vtkImageData* picture) {
  const int* size = picture->GetDimensions();
  const int components = picture->GetNumberOfScalarComponents();
  const auto* corner = static_cast<unsigned char*>(picture->GetScalarPointer(0, 0, 0));
  long different = 0;
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      bool unlike = false;
      for (int c = 0; c < components; ++c) unlike = unlike || std::abs(pixel[c] - corner[c]) > 2;
      different += unlike;
    }
  return static_cast<double>(different) / (static_cast<double>(size[0]) * size[1]);
}
