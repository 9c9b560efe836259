#include <gtest/gtest.h>

#include <tuple>

#include "CommaText.h"
#include "FaceFiles.h"
#include "FaceTexture.h"
#include "FaceWarpLayout.h"
#include "ImageFile.h"
#include "LineReader.h"
#include "ReferenceData.h"
#include "TemporaryFolder.h"
#include "TestImages.h"
#include "TextFile.h"
#include "WarpMeshData.h"
#include "WarpMeshText.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkFaceWarpMeshFilter.h"
#include "vtkJPEGWriter.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkTIFFWriter.h"

using namespace mien;

namespace {

using Kind = FaceWarpLayout::Kind;
constexpr Kind kinds[] = {Kind::SevenBySeven, Kind::Fine};

FaceWarpLayout layoutOf(Kind kind) {
  FaceWarpLayout layout;
  EXPECT_EQ(layout.set(kind, genericFace()), "");
  return layout;
}

/// A picture of the generic face of 4 pixels per mm, turned and scaled, on which the 25 places are marked.
struct Photograph {
  FaceCurves face = genericFace();
  WarpMesh places = frontMesh(layoutOf(Kind::SevenBySeven), face, 4.0, {-80.0, 120.0}, 640, 840);
  ImageLandmarks landmarks;
  explicit Photograph(double turn = 0.0, double scale = 1.0) {
    const double c = scale * std::cos(turn), s = scale * std::sin(turn);
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 7; ++j) {
        const double x = places.x(i, j), y = places.y(i, j);
        places.x(i, j) = 100.0 + c * x - s * y;
        places.y(i, j) = 50.0 + s * x + c * y;
        if (!places.names[7 * i + j].empty()) landmarks[places.names[7 * i + j]] = {places.x(i, j), places.y(i, j)};
      }
  }
};

constexpr double pixelsPerMillimetre = 4.0;

/// The 68 landmarks of a reference head as a picture from the front has them.
ImageLandmarks frontLandmarks(const std::string& head) {
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(referencePath("heads/" + head + "_neutral.ply").c_str());
  reader->Update();
  const std::string text = readTextFile(referencePath("heads/landmarks68.csv"));
  LineReader lines(text);
  ImageLandmarks landmarks;
  lines.next();
  while (lines.next()) {
    const std::vector<std::string> cells = splitAtCommas(lines.line());
    const double* p = reader->GetOutput()->GetPoint(std::stoi(cells[1]));
    landmarks[cells[0]] = {500.0 + pixelsPerMillimetre * p[0], 500.0 - pixelsPerMillimetre * p[1]};
  }
  return landmarks;
}

std::vector<std::string> headNames() {
  std::vector<std::string> names = {"generic", "mean"};
  for (int i = 1; i <= 12; ++i) names.push_back((i < 10 ? "subject0" : "subject") + std::to_string(i));
  return names;
}

template <typename Writer>
void write(vtkImageData* image, const std::string& file) {
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

double colour(vtkImageData* image, double share, double down, int c) {
  const int* size = image->GetDimensions();
  return image->GetScalarComponentAsDouble(static_cast<int>(share * size[0]),
                                           size[1] - 1 - static_cast<int>(down * size[1]), 0, c);
}

}  // namespace

TEST(FaceWarpLayout, ThePlacesLieWhereTheSurfaceHasThem) {
  for (const Kind kind : kinds) {
    const FaceWarpLayout layout = layoutOf(kind);
    const WarpMesh mesh = textureMesh(layout, 360, 270);
    EXPECT_EQ(describeFault(mesh, "mesh"), "");
    EXPECT_NEAR(mesh.x(0, 0), 90.0, 1e-9) << "the frontal half of v";
    EXPECT_NEAR(mesh.x(0, mesh.columns() - 1), 270.0, 1e-9);
    EXPECT_EQ(mesh.y(0, 0), 0.0);
    EXPECT_EQ(mesh.y(mesh.rows() - 1, 0), 270.0);
    Kind found{};
    EXPECT_TRUE(FaceWarpLayout::kindOf(mesh, found) && found == kind);
    EXPECT_EQ(FaceWarpLayout::sizeOf(kind), std::pair(mesh.rows(), mesh.columns()));
  }
  const WarpMesh mesh = textureMesh(layoutOf(Kind::SevenBySeven), 360, 270);
  EXPECT_EQ(mesh.names[4 * 7 + 3], "8.1");
  EXPECT_NEAR(mesh.x(4, 3), 180.0, 1e-9);
  EXPECT_NEAR(mesh.y(4, 3), 200.0, 1e-9) << "C21 is 20 of 27 intervals down";
  EXPECT_NEAR(mesh.y(4, 1), 210.0, 1e-9) << "the lip line";
  EXPECT_GT(mesh.x(4, 5), 180.0) << "8.3, the subject's left, is right in the picture";
  EXPECT_EQ(mesh.names[4 * 7 + 5], "8.3");
}

TEST(FaceWarpLayout, TwentyFivePointsGiveTheirMesh) {
  for (const double turn : {0.0, 0.1}) {
    const Photograph photograph(turn, 0.6);
    WarpMesh mesh;
    ASSERT_EQ(photographMesh(layoutOf(Kind::SevenBySeven), photograph.face, photograph.landmarks, 640, 840, mesh), "");
    for (int i = 0; i < 49; ++i) {
      const double off = std::hypot(mesh.x(i / 7, i % 7) - photograph.places.x(i / 7, i % 7),
                                    mesh.y(i / 7, i % 7) - photograph.places.y(i / 7, i % 7));
      EXPECT_LT(off, mesh.names[i].empty() ? 0.075 * 65.0 * 4.0 * 0.6 : 1e-6)
          << "the 25 are met, the border lies 7 % of the half width within";
    }
    ASSERT_EQ(photographMesh(layoutOf(Kind::Fine), photograph.face, photograph.landmarks, 640, 840, mesh), "");
  }
}

/// With points on 13 heads the mesh ends inside the face as with 68 landmarks, which mark the jaw line.
TEST(FaceWarpLayout, TheSidesOfTwentyFivePointsLieInsideTheFace) {
  MIEN_REQUIRE_REFERENCE("heads/landmarks68.csv");
  const FaceCurves face = genericFace();
  const FaceWarpLayout paper = layoutOf(Kind::SevenBySeven), fine = layoutOf(Kind::Fine);
  for (const std::string& head : headNames()) {
    const ImageLandmarks marks = frontLandmarks(head);
    WarpMesh places, jaw, mesh;
    ASSERT_EQ(photographMesh(paper, face, marks, 1000, 1000, places), "");
    ASSERT_EQ(photographMesh(fine, face, marks, 1000, 1000, jaw), "");
    ImageLandmarks points;
    for (int i = 0; i < 49; ++i)
      if (!places.names[i].empty()) points[places.names[i]] = {places.x(i / 7, i % 7), places.y(i / 7, i % 7)};
    ASSERT_EQ(photographMesh(fine, face, points, 1000, 1000, mesh), "") << head;
    const Eigen::Index last = mesh.columns() - 1;
    EXPECT_LT((jaw.x.col(0) - mesh.x.col(0)).maxCoeff(), 4.0 * pixelsPerMillimetre) << head;
    EXPECT_LT((mesh.x.col(last) - jaw.x.col(last)).maxCoeff(), 4.0 * pixelsPerMillimetre) << head;
    EXPECT_LT((mesh.x.col(0) - jaw.x.col(0)).maxCoeff(), 10.0 * pixelsPerMillimetre) << "and not far inside";
  }
}

TEST(FaceWarpLayout, LandmarksThatAreMissingOrSwappedAreNamed) {
  Photograph photograph(0.0, 0.6);
  WarpMesh mesh;
  const auto fault = [&] {
    return photographMesh(layoutOf(Kind::SevenBySeven), photograph.face, photograph.landmarks, 640, 840, mesh);
  };
  const Eigen::Vector2d cheek = photograph.landmarks["5.4"];
  photograph.landmarks["5.4"].x() -= 48.0;  // 20 mm
  EXPECT_NE(fault().find("landmark 5.4 lies 48 pixels from where the others put it, about x = " +
                         std::to_string(std::lround(cheek.x()))),
            std::string::npos)
      << fault();
  photograph.landmarks["5.4"] = cheek;
  std::swap(photograph.landmarks["8.1"], photograph.landmarks["8.2"]);
  EXPECT_EQ(fault().rfind("landmark 8.", 0), 0u) << fault();
  std::swap(photograph.landmarks["8.1"], photograph.landmarks["8.2"]);
  std::swap(photograph.landmarks["3.2"], photograph.landmarks["3.4"]);  // lids, 9 mm apart
  EXPECT_NE(fault().find("folded: rows"), std::string::npos) << fault();
  photograph.landmarks.erase("8.1");
  EXPECT_NE(fault().find("landmark 8.1 is missing"), std::string::npos) << fault();
  photograph.landmarks = {{"0", {1, 2}}};
  EXPECT_NE(fault().find("all 68 are needed"), std::string::npos) << fault();
  FaceCurves bare = photograph.face;
  bare.features.clear();
  FaceWarpLayout layout;
  EXPECT_NE(layout.set(Kind::SevenBySeven, bare).find("4.6"), std::string::npos);
}

TEST(FaceWarpLayout, LandmarksBeyondThePictureAreRefused) {
  Photograph photograph(0.0, 0.6);
  WarpMesh mesh;
  for (auto& [name, point] : photograph.landmarks) point *= 2.0;
  const FaceWarpLayout layout = layoutOf(Kind::Fine);
  const std::string fault = photographMesh(layout, photograph.face, photograph.landmarks, 640, 840, mesh);
  const Eigen::Vector2d brow = photograph.landmarks["4.3"];
  EXPECT_EQ(fault.rfind("landmark 4.3 lies at x = " + std::to_string(std::lround(brow.x())) + ", y = ", 0), 0u)
      << fault;
  EXPECT_NE(fault.find("beyond the picture of 640 x 840 pixels"), std::string::npos) << fault;
  photograph.landmarks = {{"0", {1, 2}}, {"10", {5, 5}}, {"9", {700, 2}}, {"11", {-1, 2}}};
  EXPECT_EQ(photographMesh(layout, photograph.face, photograph.landmarks, 640, 840, mesh).rfind("landmark 9 lies", 0),
            0u)
      << "the first by number";
}

TEST(FaceWarpMeshFilter, GivesTheMeshOfTheCurves) {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkFaceWarpMeshFilter> filter;
  filter->SetInputConnection(curves->GetOutputPort());
  filter->SetTextureSize(400, 200);
  for (const Kind kind : kinds) {
    filter->SetFine(kind == Kind::Fine);
    filter->Update();
    WarpMesh mesh;
    ASSERT_EQ(readWarpMesh(filter->GetOutput(), mesh), "");
    EXPECT_TRUE(mesh.x.isApprox(textureMesh(layoutOf(kind), 400, 200).x, 1e-12));
  }
}

/// Red on the subject's right, which is left in the picture; green on the left; blue above the eyes.
TEST(FaceTexture, SidesAreNotMirroredAndTheTopIsUp) {
  const TemporaryFolder folder;
  const Photograph photograph;
  auto image = wavyImage(640, 840, VTK_UNSIGNED_CHAR, 3, 0.0);
  for (int y = 0; y < 840; ++y)
    for (int x = 0; x < 640; ++x) {
      image->SetScalarComponentFromDouble(x, y, 0, x < 320 ? 0 : 1, 200.0);
      image->SetScalarComponentFromDouble(x, y, 0, 2, y > 540 ? 250.0 : 0.0);
    }
  write<vtkPNGWriter>(image, folder.file("face.png"));
  vtkNew<vtkBoundaryCurveReader> curves;
  curves->Update();
  for (const Kind kind : kinds) {
    const WarpMesh mesh = frontMesh(layoutOf(kind), photograph.face, 4.0, {-80.0, 120.0}, 640, 840);
    writeTextFile(folder.file("face.csv"), writeWarpMesh(mesh));
    FaceState state;
    state.texture = folder.file("face.png");
    vtkNew<vtkImageData> texture;
    ASSERT_EQ(makeFaceTexture(state, curves->GetOutput(), texture), "");
    EXPECT_EQ(texture->GetScalarType(), VTK_UNSIGNED_CHAR);
    EXPECT_NEAR(colour(texture, 0.4, 0.5, 0), 200.0, 1.0) << "v < pi, the subject's right";
    EXPECT_NEAR(colour(texture, 0.6, 0.5, 1), 200.0, 1.0) << "v > pi, the subject's left";
    EXPECT_NEAR(colour(texture, 0.5, 3.0 / 27.0, 2), 250.0, 1.0) << "C4 is above the eyes";
    EXPECT_NEAR(colour(texture, 0.5, 12.0 / 27.0, 2), 0.0, 1.0) << "C13 is below";
    EXPECT_NEAR(colour(texture, 0.0, 0.5, 0), colour(texture, 0.9999, 0.5, 0), 1.0) << "no seam at the back";
  }
}

TEST(FaceTexture, SaysWhichFileIsWrong) {
  const TemporaryFolder folder;
  vtkNew<vtkBoundaryCurveReader> curves;
  curves->Update();
  vtkNew<vtkImageData> texture;
  FaceState state;
  state.texture = folder.file("face.png");
  const auto fault = [&] { return makeFaceTexture(state, curves->GetOutput(), texture); };
  EXPECT_EQ(fault().rfind(state.texture + ": it cannot be opened", 0), 0u) << fault();
  write<vtkPNGWriter>(wavyImage(64, 48, VTK_UNSIGNED_CHAR, 1, 255.0), state.texture);
  EXPECT_EQ(fault().rfind(folder.file("face.csv") + ": it cannot be opened", 0), 0u) << fault();
  writeTextFile(folder.file("face.csv"), writeWarpMesh(evenMesh(3, 5, 64, 48)));
  EXPECT_NE(fault().find("3 x 5"), std::string::npos) << fault();
  writeTextFile(folder.file("other.csv"), writeWarpMesh(evenMesh(7, 7, 64, 48)));
  state.textureMesh = folder.file("other.csv");
  EXPECT_EQ(fault(), "");
  EXPECT_EQ(texture->GetNumberOfScalarComponents(), 3) << "grey becomes red, green and blue";
  state.textureMesh = writeWarpMesh(evenMesh(7, 7, 64, 48));
  EXPECT_EQ(fault(), "") << "the text of a mesh";
  state.textureMesh = writeWarpMesh(evenMesh(3, 5, 64, 48));
  EXPECT_EQ(fault().rfind("mesh: a mesh of 3 x 5", 0), 0u) << fault();
  state.textureMesh = "mien_warp_mesh,1,64,48\nrow,column,x\n";
  EXPECT_EQ(fault().rfind("mesh:2: ", 0), 0u) << fault();
  state.textureMesh = folder.file("other.csv");
  vtkNew<vtkPolyData> noCurves;
  EXPECT_EQ(makeFaceTexture(state, noCurves, texture).rfind("the generic face: ", 0), 0u);
  state.curvesFile = "anna.vtp";
  EXPECT_EQ(makeFaceTexture(state, noCurves, texture).rfind("anna.vtp: ", 0), 0u) << "not the mesh's name";
}

TEST(ImageFile, ReadsTheKindsOfPicturesUpright) {
  const TemporaryFolder folder;
  const auto image = wavyImage(40, 30, VTK_UNSIGNED_CHAR, 3, 255.0);
  write<vtkPNGWriter>(image, folder.file("a.png"));
  write<vtkJPEGWriter>(image, folder.file("a.JPG"));
  write<vtkTIFFWriter>(image, folder.file("a.tif"));
  write<vtkPNGWriter>(wavyImage(40, 30, VTK_UNSIGNED_SHORT, 3, 65535.0), folder.file("b.png"));
  write<vtkTIFFWriter>(wavyImage(40, 30, VTK_FLOAT, 1, 1.0), folder.file("b.tiff"));
  for (const char* name : {"a.png", "a.JPG", "a.tif", "b.png", "b.tiff"}) {
    vtkNew<vtkImageData> read;
    ASSERT_EQ(readImageFile(folder.file(name), read), "") << name;
    ASSERT_EQ(read->GetDimensions()[1], 30) << name;
    const double scale = read->GetScalarType() == VTK_FLOAT            ? 255.0
                         : read->GetScalarType() == VTK_UNSIGNED_SHORT ? 1.0 / 257.0
                                                                       : 1.0;
    for (const int y : {3, 25})
      EXPECT_NEAR(scale * read->GetScalarComponentAsDouble(10, y, 0, 0), image->GetScalarComponentAsDouble(10, y, 0, 0),
                  8.0)
          << name << ", row " << y;
  }
}

/// Alpha, and colours of 16 bits: what Mien writes itself, and cameras and editors do.
TEST(ImageFile, ReadsWholeColoursOfTIFFs) {
  const TemporaryFolder folder;
  for (const auto& [type, most, components] :
       {std::tuple{VTK_UNSIGNED_CHAR, 255.0, 4}, {VTK_UNSIGNED_SHORT, 65535.0, 3}, {VTK_UNSIGNED_SHORT, 65535.0, 4}}) {
    const auto image = wavyImage(40, 30, type, components, most);
    for (vtkIdType i = 0; components == 4 && i < 40 * 30; ++i)
      image->GetPointData()->GetScalars()->SetComponent(i, 3, most);
    write<vtkTIFFWriter>(image, folder.file("a.tif"));
    vtkNew<vtkImageData> read;
    ASSERT_EQ(mien::readImageFile(folder.file("a.tif"), read), "");
    ASSERT_EQ(read->GetNumberOfScalarComponents(), components);
    vtkDataArray *was = image->GetPointData()->GetScalars(), *is = read->GetPointData()->GetScalars();
    ASSERT_EQ(is->GetNumberOfTuples(), was->GetNumberOfTuples());
    for (vtkIdType i = 0; i < is->GetNumberOfTuples(); ++i)
      for (int c = 0; c < components; ++c)
        ASSERT_NEAR(is->GetComponent(i, c) / 255.0, was->GetComponent(i, c) / most, 1.0 / 255.0) << i << " " << c;
  }
}

TEST(ImageFile, BlankPagesPackTightlyAndAreRead) {
  for (const char* const name : {"blank_bilevel.png", "blank_fax.tif"}) {
    vtkNew<vtkImageData> read;
    ASSERT_EQ(readImageFile(std::string(MIEN_TEST_DIR "/data/pictures/") + name, read), "") << name;
    EXPECT_EQ(read->GetDimensions()[0], 1200) << name;
    EXPECT_EQ(read->GetDimensions()[1], 1200) << name;
  }
}

TEST(ImageFile, DamagedPicturesAreRefusedInOneSentence) {
  const TemporaryFolder folder;
  const auto image = wavyImage(300, 200, VTK_UNSIGNED_CHAR, 3, 255.0);
  write<vtkPNGWriter>(image, folder.file("a.png"));
  write<vtkJPEGWriter>(image, folder.file("a.jpg"));
  write<vtkTIFFWriter>(image, folder.file("a.tif"));
  vtkNew<vtkImageData> read;
  const auto expectRefusal = [&](const std::string& file) {
    const std::string fault = readImageFile(file, read);
    EXPECT_EQ(fault.rfind(file + ": it", 0), 0u) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    EXPECT_EQ(read->GetNumberOfPoints(), 0) << file;
  };
  for (const char* ending : {"png", "jpg", "tif"}) {
    const std::string whole = readTextFile(folder.file(std::string("a.") + ending)),
                      file = folder.file(std::string("b.") + ending);
    for (const double share : {0.0, 0.02, 0.5, 0.9}) {
      writeTextFile(file, whole.substr(0, static_cast<std::size_t>(share * whole.size())));
      expectRefusal(file);
    }
    writeTextFile(file, "mien_warp_mesh,1,10,10\n");
    expectRefusal(file);
  }
  std::string vast = readTextFile(folder.file("a.png"));
  vast.replace(16, 8, std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8));
  writeTextFile(folder.file("vast.png"), vast);
  expectRefusal(folder.file("vast.png"));
  writeTextFile(folder.file("a.gif"), "GIF89a");
  expectRefusal(folder.file("a.gif"));
  expectRefusal(folder.file("none.png"));
}
