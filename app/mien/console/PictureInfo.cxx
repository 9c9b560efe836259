#include "PictureInfo.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "CommaText.h"
#include "FaceTexture.h"
#include "Failure.h"
#include "ImageFile.h"
#include "ImageLandmarks.h"
#include "InfoText.h"
#include "LandmarkTable.h"
#include "LineReader.h"
#include "OutputFile.h"
#include "TextFileReader.h"
#include "WarpMeshText.h"
#include "vtkImageData.h"
#include "vtkNew.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t largestText = 10'000'000;  // bytes of a warp mesh or of landmarks

void addMesh(const WarpMesh& mesh, json& about) {
  about["mesh_rows"] = mesh.rows();
  about["mesh_columns"] = mesh.columns();
  about["mesh_pixels"] = {mesh.width, mesh.height};
}

json describePhotograph(const std::string& file) {
  vtkNew<vtkImageData> image;
  const std::string fault = readImageFile(file, image);
  if (!fault.empty()) throw FileFailure(fault);
  const int* size = image->GetDimensions();
  json about = {{"kind", "photograph"},
                {"file", file},
                {"pixels", {size[0], size[1]}},
                {"components", image->GetNumberOfScalarComponents()},
                {"type", image->GetScalarTypeAsString()}};
  const std::string beside = meshBeside(file);
  about["mesh"] = std::filesystem::exists(beside) ? json(beside) : json(nullptr);
  if (about["mesh"].is_null()) return about;
  WarpMesh mesh;
  const std::string meshFault = readSourceMesh(beside, mesh);
  meshFault.empty() ? addMesh(mesh, about) : void(about["mesh_fault"] = meshFault);
  return about;
}

json describeWarpMesh(const std::string& file, const std::string& text) {
  WarpMesh mesh;
  const std::string fault = parseWarpMesh(text, mesh);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  json about = {{"kind", "warp mesh of a photograph"}, {"file", file}};
  addMesh(mesh, about);
  return about;
}

json describePictureLandmarks(const std::string& file, const std::string& text) {
  ImageLandmarks landmarks;
  const std::string fault = parseImageLandmarks(text, landmarks);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  return {{"kind", "landmarks of a photograph"}, {"file", file}, {"landmarks", landmarks.size()}};
}

json describeScanLandmarks(const std::string& file, const std::string& text) {
  LandmarkTable table;
  const std::string fault = parseLandmarks(text, table);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  return {{"kind", "landmarks of a scan"},
          {"file", file},
          {"landmarks", std::count(table.given.begin(), table.given.end(), true)},
          {"by", table.hasVertices ? "vertex" : "place"}};
}

json describeTable(const std::string& file) {
  std::string text;
  if (!readTextFile(file, largestText, text).empty()) return nullptr;  // another reader says why
  LineReader lines(text);
  if (!lines.next()) return nullptr;
  const std::vector<std::string> header = splitAtCommas(lines.line());
  const auto has = [&](const char* column) { return columnNamed(header, column) >= 0; };
  if (!header.empty() && header[0] == "mien_warp_mesh") return describeWarpMesh(file, text);
  if (!has("landmark") && !has("vertex")) return nullptr;
  return has("vertex") || has("z") ? describeScanLandmarks(file, text) : describePictureLandmarks(file, text);
}

}  // namespace

json describePictureFile(const std::string& file) {
  static const std::string pictures[] = {"png", "jpg", "jpeg", "tif", "tiff"};
  const std::string ending = fileEnding(file);
  if (std::find(std::begin(pictures), std::end(pictures), ending) != std::end(pictures))
    return describePhotograph(file);
  return ending == "csv" ? describeTable(file) : json(nullptr);
}

void printPictureFile(const json& picture) {
  const auto sizeText = [](const json& size) { return size[0].dump() + " x " + size[1].dump() + " pixels"; };
  printLine(picture["kind"] == "photograph" ? "photograph" : "file", picture["file"]);
  if (picture["kind"] != "photograph") printLine("kind", picture["kind"]);
  if (picture.contains("pixels"))
    printLine("size", sizeText(picture["pixels"]) + ", " + picture["components"].dump() + " components of type " +
                          picture["type"].get<std::string>());
  if (picture.contains("mesh"))
    printLine("mesh beside it", picture["mesh"].is_null() ? "none; mien texture --landmarks makes one"
                                                          : picture["mesh"].get<std::string>());
  if (picture.contains("mesh_fault")) printLine("mesh's fault", picture["mesh_fault"]);
  if (picture.contains("mesh_rows"))
    printLine("mesh", picture["mesh_rows"].dump() + " x " + picture["mesh_columns"].dump() + " points over " +
                          sizeText(picture["mesh_pixels"]));
  if (picture.contains("landmarks"))
    printLine("landmarks",
              picture["landmarks"].dump() + (picture.contains("by") ? ", by " + picture["by"].get<std::string>() : ""));
}

}  // namespace mien
