#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <list>
#include <memory>

#include "Arguments.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CsvText.h"
#include "FacePipeline.h"
#include "FaceTexture.h"
#include "FaceWarpLayout.h"
#include "Failure.h"
#include "FigureApplication.h"
#include "FigureFile.h"
#include "ImageFile.h"
#include "LandmarkFigure.h"
#include "OutputFile.h"
#include "PictureFile.h"
#include "PipelineErrors.h"
#include "TextFileReader.h"
#include "WarpMeshData.h"
#include "WarpMeshText.h"
#include "WatchedUpdate.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkImageData.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

using Kind = FaceWarpLayout::Kind;

struct TextureCommandOptions {
  std::string image, source, landmarks, target, face, mesh, size, saveSource, saveTarget, showPoints, output;

  bool writesMeshes() const { return !output.empty() || !saveSource.empty() || !saveTarget.empty(); }
};

void check(const TextureCommandOptions& options) {
  if (!options.source.empty() && !options.landmarks.empty())
    throw ValueFailure("--source and --landmarks both say where features lie; give one");
  if (options.source.empty() && options.landmarks.empty() && !std::filesystem::exists(meshBeside(options.image)))
    throw ValueFailure("there is no " + meshBeside(options.image) +
                       " beside the image; give --source MESH.csv or --landmarks FILE.csv");
  if (!options.mesh.empty() && options.mesh != "7x7" && options.mesh != "fine")
    throw ValueFailure("--mesh '" + options.mesh + "' is unknown; it is 7x7 or fine");
  if (!options.mesh.empty() && options.landmarks.empty())
    throw ValueFailure("--mesh says what is made of --landmarks; give them, or leave it out");
  if (!options.writesMeshes() && options.showPoints.empty())
    throw ValueFailure("there is nothing to write; give -o, --save-source, --save-target or --show-points");
  if (!options.output.empty()) requireEnding(options.output, {"png", "jpg", "jpeg", "tif", "tiff"});
  for (const std::string& file : {options.saveSource, options.saveTarget})
    if (!file.empty()) requireEnding(file, {"csv"});
  if (!options.showPoints.empty()) requireEnding(options.showPoints, FigureFile::endings());
}

constexpr std::size_t largestText = 10'000'000;  // bytes of a warp mesh or of landmarks
constexpr double pointsDotsPerInch = 200.0;      // 1024 pixels across

std::string readText(const std::string& file, const std::string& what) {
  std::string text;
  const std::string fault = readTextFile(file, largestText, text, what);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  return text;
}

WarpMesh readMesh(const std::string& file) {
  WarpMesh mesh;
  const std::string fault = parseWarpMesh(readText(file, "warp mesh"), mesh);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  return mesh;
}

FaceCurves readFace(const std::string& file) {
  FacePipeline pipeline;
  FaceState state;
  state.curvesFile = file;
  pipeline.setState(state);
  std::string fault = pipeline.updateNeutralCurves();
  FaceCurves face;
  if (fault.empty()) fault = readFaceCurves(pipeline.neutralCurves()->GetOutput(), face);
  if (!fault.empty()) throw FileFailure(fault);
  return face;
}

FaceWarpLayout layoutOn(const FaceCurves& face, Kind kind) {
  FaceWarpLayout layout;
  const std::string fault = layout.set(kind, face);
  if (!fault.empty()) throw FileFailure(fault);
  return layout;
}

ImageLandmarks readLandmarks(const TextureCommandOptions& options) {
  ImageLandmarks landmarks;
  const std::string fault = parseImageLandmarks(readText(options.landmarks, "list of landmarks"), landmarks);
  if (!fault.empty()) throw FileFailure(options.landmarks + ":" + fault);
  return landmarks;
}

WarpMesh meshOfLandmarks(const TextureCommandOptions& options, const FaceCurves& face, vtkImageData* image) {
  WarpMesh mesh;
  const int* size = image->GetDimensions();
  const std::string fault = photographMesh(layoutOn(face, options.mesh == "7x7" ? Kind::SevenBySeven : Kind::Fine),
                                           face, readLandmarks(options), size[0], size[1], mesh);
  if (!fault.empty()) throw FileFailure(options.landmarks + ": " + fault);
  return mesh;
}

WarpMesh readSource(const TextureCommandOptions& options) {
  return readMesh(options.source.empty() ? meshBeside(options.image) : options.source);
}

/// Landmarks are drawn as they are given, wherever they lie, so that one sees what is wrong with them.
void showPoints(const TextureCommandOptions& options, vtkImageData* image) {
  ImageLandmarks points;
  if (!options.landmarks.empty()) {
    points = readLandmarks(options);
  } else {
    const int* size = image->GetDimensions();
    points = namedPoints(scaledMesh(readSource(options), size[0], size[1]));
    if (points.empty()) throw FileFailure("the source mesh names no points; --show-points needs --landmarks, or 7 x 7");
  }
  const FigureApplication application;
  const FigureDrawing drawing = drawLandmarks(image, points);
  FigureFile file(options.showPoints);
  file.setDotsPerInch(pointsDotsPerInch);
  file.setTitle("Landmarks");
  const std::string fault = file.write(drawing.size, drawing.paint);
  if (!fault.empty()) throw FileFailure(fault);
}

/// Without a target mesh that of the face, which must have the places of the source mesh.
WarpMesh targetOf(const TextureCommandOptions& options, const FaceCurves& face, const WarpMesh& source) {
  if (!options.target.empty()) return readMesh(options.target);
  Kind kind{};
  if (!FaceWarpLayout::kindOf(source, kind))
    throw ValueFailure("a source mesh of " + std::to_string(source.rows()) + " x " + std::to_string(source.columns()) +
                       " points has no places on the face; give --target, or a mesh of 7 x 7");
  return textureMesh(layoutOn(face, kind), faceTextureWidth, faceTextureHeight);
}

/// Writes a mesh under the temporary name.
void fill(const OutputFile& file, const WarpMesh& mesh) {
  if (!(std::ofstream(file.temporaryName(), std::ios::binary) << writeWarpMesh(mesh) << std::flush))
    throw FileFailure(file.name() + ": cannot be written; is there space left on the disk?");
}

/// Of the picture that is written: from --size, else from the target mesh.
std::pair<int, int> sizeOf(const TextureCommandOptions& options, const WarpMesh& target) {
  const double largest = vtkImageMeshWarpFilter::LargestSide;
  const std::string allowed = "at most " + std::to_string(vtkImageMeshWarpFilter::LargestSide) + " pixels along a side";
  if (options.size.empty() && std::max(target.width, target.height) > largest)
    throw FileFailure(options.target + ": the mesh is for a picture of " + shortestText(target.width) + " x " +
                      shortestText(target.height) + " pixels, and " + allowed + " can be written; give a --size");
  if (options.size.empty()) return {static_cast<int>(target.width), static_cast<int>(target.height)};
  const auto [width, height] = parseSize("--size", options.size);
  if (std::max(width, height) > largest)
    throw ValueFailure("--size " + std::to_string(width) + "x" + std::to_string(height) + " is too large; " + allowed +
                       " are allowed");
  return {width, height};
}

void warp(const TextureCommandOptions& options, vtkImageData* image, const WarpMesh& source, const WarpMesh& target,
          const OutputFile& output) {
  vtkNew<vtkStructuredGrid> from, to;
  writeWarpMesh(source, from);
  writeWarpMesh(target, to);
  vtkNew<vtkImageMeshWarpFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(image);
  filter->SetSourceMeshData(from);
  filter->SetTargetMeshData(to);
  const auto [width, height] = sizeOf(options, target);
  filter->SetOutputSize(width, height);
  filter->SetClosed(options.target.empty());
  updateWatched(filter, "picture");
  if (!errors.first().empty()) throw FileFailure(options.image + ": " + errors.first());
  writePicture(filter->GetOutput(), output);
}

void run(const TextureCommandOptions& options) {
  check(options);
  vtkNew<vtkImageData> image;
  const std::string fault = readImageFile(options.image, image);
  if (!fault.empty()) throw FileFailure(fault);
  if (!options.showPoints.empty()) showPoints(options, image);
  if (!options.writesMeshes()) return;
  const FaceCurves face = readFace(options.face);
  const WarpMesh source = options.landmarks.empty() ? readSource(options) : meshOfLandmarks(options, face, image);
  const WarpMesh target = targetOf(options, face, source);
  std::list<OutputFile> files;  // all appear, or none
  if (!options.saveSource.empty()) fill(files.emplace_back(options.saveSource), source);
  if (!options.saveTarget.empty()) fill(files.emplace_back(options.saveTarget), target);
  if (!options.output.empty()) warp(options, image, source, target, files.emplace_back(options.output));
  for (OutputFile& file : files) file.commit();
}

}  // namespace

void addTextureCommand(CLI::App& program) {
  const auto options = std::make_shared<TextureCommandOptions>();
  CLI::App* command = program.add_subcommand("texture", "Warp a photograph into the texture of a face");
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command->add_option(name, value, help);
  };
  add("image", options->image, "Photograph of a face from the front: .png .jpg .tif")->required();
  add("--source", options->source, "Warp mesh over the photograph, MESH.csv [the .csv beside it]");
  add("--landmarks", options->landmarks,
      "In place of --source: landmark,x,y in pixels, y down; 68 by number or 25 by name, FILE.csv");
  add("--mesh", options->mesh, "What --landmarks make: 7x7, or fine, which follows lids and lips [fine]");
  add("--target", options->target, "Warp mesh to take it to, MESH.csv [the features of the face in (u, v)]");
  add("--face", options->face, "Boundary curves, FILE.vtp [the generic face]");
  add("--size", options->size, "Width x height of the texture in pixels [2048x1024; that of --target]");
  add("-o,--output", options->output, "Texture to write: .png .jpg .tif");
  add("--save-source", options->saveSource, "Write the source mesh, FILE.csv, for --texture of render and animate");
  add("--save-target", options->saveTarget, "Write the target mesh, FILE.csv");
  add("--show-points", options->showPoints,
      "Draw the landmarks with their names on the photograph, as they are given: .png .svg .pdf");
  command->footer(
      "Example: mien texture anna.jpg --landmarks anna68.csv --save-source anna.csv -o anna_texture.png\n"
      "         mien render --texture anna.jpg --expression joy -o joy.png\n"
      "         mien texture anna.jpg --landmarks anna25.csv --show-points check.png\n"
      "A surface shows the texture through its TextureCoordinates. The 25 points, row by row from the subject's "
      "right:\n"
      "  4.6 4.4 brow_middle 4.3 4.5            outer end and top of the brow, between the brows, top, outer end\n"
      "  3.12 3.2 nose_bridge 3.1 3.7           outer corner and upper lid of the eye, nose bridge, upper lid, corner\n"
      "  5.4 3.4 9.12 3.3 5.3                   cheekbone, lower lid, nose ridge, lower lid, cheekbone\n"
      "  8.4 8.6 8.1 8.5 8.3                    corner of the mouth, upper edge of the lips, corner\n"
      "  lower_lip_right 8.8 8.2 8.7 lower_lip_left   lower edge of the lips\n"
      "Each with a drawing: doc/warp_points.md.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
