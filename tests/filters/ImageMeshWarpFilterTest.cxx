#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ErrorCounter.h"
#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "TestImages.h"
#include "TextFile.h"
#include "WarpMeshData.h"
#include "WarpMeshText.h"
#include "vtkCallbackCommand.h"
#include "vtkExtractVOI.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkWarpMeshReader.h"

using namespace mien;

namespace {

vtkSmartPointer<vtkStructuredGrid> grid(const WarpMesh& mesh) {
  auto data = vtkSmartPointer<vtkStructuredGrid>::New();
  writeWarpMesh(mesh, data);
  return data;
}

/// A filter from one mesh to another.
struct Warp {
  vtkNew<vtkImageMeshWarpFilter> filter;
  Warp(vtkImageData* image, const WarpMesh& source, const WarpMesh& target) {
    filter->SetInputData(image);
    filter->SetSourceMeshData(grid(source));
    filter->SetTargetMeshData(grid(target));
  }
  vtkImageData* update() {
    filter->Update();
    return filter->GetOutput();
  }
};

double at(vtkImageData* image, int x, int y, int c = 0) {
  return image->GetScalarComponentAsDouble(x, y, 0, c);
}

/// Largest difference, and root mean square, of the part that is `margin` pixels within.
std::pair<double, double> difference(vtkImageData* a, vtkImageData* b, int margin) {
  double largest = 0.0, squares = 0.0;
  long count = 0;
  const int* size = a->GetDimensions();
  for (int y = margin; y < size[1] - margin; ++y)
    for (int x = margin; x < size[0] - margin; ++x)
      for (int c = 0; c < a->GetNumberOfScalarComponents(); ++c, ++count) {
        const double d = at(a, x, y, c) - at(b, x, y, c);
        largest = std::max(largest, std::abs(d));
        squares += d * d;
      }
  return {largest, std::sqrt(squares / count)};
}

/// A dark image with a soft bright dot at (x, y), pixels from the upper left corner.
vtkSmartPointer<vtkImageData> dotAt(double x, double y, int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      image->SetScalarComponentFromDouble(i, height - 1 - j, 0, 0,
                                          std::exp(-0.5 * (std::pow(i + 0.5 - x, 2) + std::pow(j + 0.5 - y, 2))));
  return image;
}

/// Where the brightest part is, pixels from the upper left corner.
Eigen::Vector2d peak(vtkImageData* image) {
  const int* size = image->GetDimensions();
  const double brightest = image->GetScalarRange()[1];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int j = 0; j < size[1]; ++j)
    for (int i = 0; i < size[0]; ++i) {
      const double value = std::max(0.0, at(image, i, size[1] - 1 - j) - 0.6 * brightest);
      sum += value * Eigen::Vector3d(i + 0.5, j + 0.5, 1.0);
    }
  return sum.head<2>() / sum.z();
}

}  // namespace

TEST(ImageMeshWarpFilter, IdentityGivesTheImageBackInEveryType) {
  const WarpMesh mesh = bentMesh(7, 7, 150, 110, 0.3, 1.0);
  for (const auto& [type, range] :
       {std::pair(VTK_UNSIGNED_CHAR, 255.0), std::pair(VTK_UNSIGNED_SHORT, 65535.0), std::pair(VTK_SHORT, 30000.0),
        std::pair(VTK_FLOAT, 1.0), std::pair(VTK_DOUBLE, 1.0)})
    for (const int components : {1, 3, 4, 5}) {
      const auto image = wavyImage(150, 110, type, components, range);
      Warp warp(image, mesh, mesh);
      vtkImageData* output = warp.update();
      ASSERT_EQ(output->GetScalarType(), type);
      ASSERT_EQ(output->GetNumberOfScalarComponents(), components);
      EXPECT_LE(difference(image, output, 0).first, type == VTK_FLOAT || type == VTK_DOUBLE ? 1e-5 : 1.0) << type;
    }
}

TEST(ImageMeshWarpFilter, AWarpAndItsInverseGiveTheInteriorBack) {
  const auto image = wavyImage(256, 256, VTK_UNSIGNED_CHAR, 3, 255.0);
  for (const double phase : {0.0, 1.0, 2.0, 3.0}) {
    const WarpMesh from = evenMesh(7, 7, 256, 256), to = bentMesh(7, 7, 256, 256, 0.25, phase);
    Warp there(image, from, to);
    const double moved = difference(image, there.update(), 26).second;
    Warp back(there.update(), to, from);
    EXPECT_GT(moved, 0.06 * 255.0);
    EXPECT_LT(difference(image, back.update(), 26).second, 0.03 * 255.0) << "phase " << phase;
  }
}

TEST(ImageMeshWarpFilter, ControlPointsLandOnTheirTargets) {
  const WarpMesh from = bentMesh(7, 7, 210, 140, 0.3, 0.5), to = bentMesh(7, 7, 210, 140, 0.3, 4.0);
  for (int i = 1; i < 6; ++i)
    for (int j = 1; j < 6; ++j) {
      Warp warp(dotAt(from.x(i, j), from.y(i, j), 210, 140), from, to);
      EXPECT_LT((peak(warp.update()) - Eigen::Vector2d(to.x(i, j), to.y(i, j))).norm(), 0.5) << i << ", " << j;
    }
}

TEST(ImageMeshWarpFilter, AnotherSizeScalesTheImage) {
  const auto image = wavyImage(240, 160, VTK_FLOAT, 1, 1.0);
  Warp warp(image, evenMesh(2, 2, 1, 1), evenMesh(2, 2, 1, 1));
  warp.filter->SetOutputSize(60, 40);
  vtkImageData* output = warp.update();
  ASSERT_EQ(output->GetDimensions()[0], 60);
  double mean = 0.0;
  for (int y = 80; y < 84; ++y)
    for (int x = 120; x < 124; ++x) mean += at(image, x, y) / 16.0;
  EXPECT_NEAR(at(output, 30, 20), mean, 1e-5);
}

TEST(ImageMeshWarpFilter, PartsAreTheWholeBitForBit) {
  const WarpMesh from = bentMesh(5, 6, 90, 70, 0.3, 0.5), to = bentMesh(5, 6, 90, 70, 0.3, 2.0);
  Warp whole(wavyImage(90, 70, VTK_FLOAT, 3, 1.0), from, to), part(wavyImage(90, 70, VTK_FLOAT, 3, 1.0), from, to);
  whole.update();
  const int extent[6] = {13, 57, 22, 60, 0, 0};
  part.filter->UpdateExtent(extent);
  vtkImageData* output = part.filter->GetOutput();
  EXPECT_TRUE(std::equal(extent, extent + 6, output->GetExtent()));
  for (int y = extent[2]; y <= extent[3]; ++y)
    for (int x = extent[0]; x <= extent[1]; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(at(output, x, y, c), at(whole.filter->GetOutput(), x, y, c));
}

TEST(ImageMeshWarpFilter, ClosedImagesMeetAroundTheBack) {
  WarpMesh from = evenMesh(3, 3, 100, 80), to = from;
  to.x = 25.0 + 0.5 * from.x.array();
  const auto image = wavyImage(100, 80, VTK_FLOAT, 1, 1.0);
  Warp warp(image, from, to);
  warp.filter->ClosedOn();
  vtkImageData* output = warp.update();
  double seam = 0.0, edge = 0.0;
  for (int y = 0; y < 80; ++y) {
    seam = std::max(seam, std::abs(at(output, 0, y) - at(output, 99, y)));
    edge = std::max(edge, std::abs(at(output, 75, y) - at(image, 99, y)));
  }
  EXPECT_LT(seam, 0.03);
  EXPECT_LT(edge, 0.03);
  warp.filter->ClosedOff();
  output = warp.update();
  EXPECT_EQ(at(output, 99, 40), at(output, 76, 40)) << "repeated without";
}

TEST(ImageMeshWarpFilter, WorksAgainOnlyWhenSomethingChanged) {
  Warp warp(wavyImage(20, 20, VTK_UNSIGNED_CHAR, 1, 255.0), evenMesh(3, 3, 20, 20), evenMesh(3, 3, 20, 20));
  const auto time = [&] { return warp.update()->GetPointData()->GetScalars()->GetMTime(); };
  const vtkMTimeType first = time();
  EXPECT_EQ(time(), first);
  warp.filter->SetClosed(false);
  EXPECT_EQ(time(), first);
  warp.filter->SetTargetMeshData(grid(bentMesh(3, 3, 20, 20, 0.2, 0.0)));
  const vtkMTimeType second = time();
  EXPECT_GT(second, first);
  warp.filter->SetOutputSize(30, 10);
  EXPECT_GT(time(), second);
}

TEST(ImageMeshWarpFilter, SaysWhatIsWrong) {
  const WarpMesh even = evenMesh(4, 4, 20, 20);
  WarpMesh folded = even;
  std::swap(folded.x(1, 1), folded.x(1, 2));
  vtkNew<vtkImageData> bare, several;
  bare->SetDimensions(20, 20, 1);
  several->SetDimensions(20, 20, 2);
  several->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const auto image = wavyImage(20, 20, VTK_UNSIGNED_CHAR, 1, 255.0);
  const auto expect = [&](vtkImageData* input, const WarpMesh& from, const WarpMesh& to, const char* part) {
    Warp warp(input, from, to);
    const ErrorCounter errors(warp.filter);
    EXPECT_EQ(warp.update()->GetNumberOfPoints(), 0) << part;
    EXPECT_NE(errors.first().find(part), std::string::npos) << errors.first();
  };
  expect(image, folded, even, "the source mesh is folded: columns 2 and 3 cross in row 2");
  expect(image, even, folded, "the target mesh is folded");
  expect(image, even, evenMesh(4, 5, 20, 20), "two of the same size");
  expect(bare, even, even, "no scalars");
  expect(several, even, even, "slices");
  Warp warp(image, even, even);
  warp.filter->SetOutputSize(-1, 5);
  const ErrorCounter errors(warp.filter);
  warp.update();
  EXPECT_NE(errors.first().find("not possible"), std::string::npos) << errors.first();
}

TEST(ImageMeshWarpFilter, AnAbortLeavesNothing) {
  Warp warp(wavyImage(600, 3000, VTK_UNSIGNED_CHAR, 3, 255.0), evenMesh(2, 2, 1, 1), evenMesh(2, 2, 1, 1));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void* done) {
    if (*static_cast<double*>(done) > 0.2) vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  warp.filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(warp.update()->GetNumberOfPoints(), 0);
  warp.filter->RemoveAllObservers();
  warp.filter->SetAbortExecute(0);
  warp.filter->Modified();
  EXPECT_EQ(warp.update()->GetNumberOfPoints(), 600 * 3000);
}

TEST(WarpMeshReader, TheMeshLiesOnItsImageAndComesBack) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mesh.csv");
  WarpMesh mesh = bentMesh(4, 5, 64, 48, 0.3, 1.0);
  mesh.names.assign(20, "");
  mesh.names[7] = "8.1";
  writeTextFile(file, writeWarpMesh(mesh));
  vtkNew<vtkWarpMeshReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  WarpMesh read;
  ASSERT_EQ(readWarpMesh(reader->GetOutput(), read), "");
  EXPECT_TRUE(read.x.isApprox(mesh.x, 1e-14) && read.y.isApprox(mesh.y, 1e-14));
  EXPECT_EQ(read.names, mesh.names);
  EXPECT_DOUBLE_EQ(reader->GetOutput()->GetPoint(0)[1], 47.5) << "the upper border, y up";
}

TEST(WarpMeshReader, NamesFileAndLine) {
  const TemporaryFolder folder;
  vtkNew<vtkWarpMeshReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(MIEN_TEST_DIR "/data/malformed/warp_mesh/line3_x_nan.csv");
  reader->Update();
  EXPECT_NE(errors.first().find("line3_x_nan.csv:3: 'nan' is no finite number"), std::string::npos) << errors.first();
  errors.clear();
  reader->SetFileName(folder.file("none.csv").c_str());
  reader->Update();
  EXPECT_NE(errors.first().find("none.csv: it cannot be opened"), std::string::npos) << errors.first();
}
