#include "MeshText.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "MeshBuilder.h"
#include "NumberText.h"
#include "ObjText.h"
#include "PolygonFile.h"
#include "StlText.h"

namespace mien {

namespace {

std::string numbered(const char* what, std::int64_t index, std::int64_t count) {
  return std::string(what) + " " + std::to_string(index + 1) + " of " + std::to_string(count) + " ";
}

std::optional<MeshFault> readVertices(PolygonFile& file, MeshBuilder& mesh) {
  for (std::int64_t i = 0; i < file.vertexCount(); ++i) {
    const auto fault = [&](std::int64_t line, const std::string& what) {
      return MeshFault{line, numbered("vertex", i, file.vertexCount()) + what + exportMeshAgain};
    };
    double place[3];
    if (!file.readVertex(place)) return fault(file.lineHere(), file.fault());
    if (!std::all_of(place, place + 3, [](double x) { return std::isfinite(x); }))
      return fault(file.lineOfRow(), file.lineOfRow() == 0
                                         ? "is not made of finite numbers"
                                         : "has " + inQuotes(file.infinitePlace()) + " where a finite number belongs");
    mesh.addVertex(place);
  }
  return std::nullopt;
}

/// Every corner behind the first two makes a triangle with the two before it, wound like the first.
void addStrip(const std::vector<std::int64_t>& corners, std::int64_t line, MeshBuilder& mesh) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == -1) begin = i + 1;
    if (i < begin + 2) continue;
    const bool isOdd = (i - begin) % 2 == 1;
    mesh.addPolygon({corners[i - 2 + isOdd], corners[i - 1 - isOdd], corners[i]}, line);
  }
}

std::optional<MeshFault> readFaces(PolygonFile& file, MeshBuilder& mesh) {
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < file.faceCount(); ++i) {
    if (!file.readFace(corners))
      return MeshFault{file.lineHere(), numbered("face", i, file.faceCount()) + file.fault() + exportMeshAgain};
    if (file.hasStrips())
      addStrip(corners, file.lineOfRow(), mesh);
    else
      mesh.addPolygon(corners, file.lineOfRow());
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeshFault> readMeshText(std::string_view text, const std::string& ending, MeshText& read) {
  if (ending == ".obj") return readObjText(text, read);
  if (ending == ".stl") return readStlText(text, read);
  if (ending == ".ply" && !PolygonFile::isPly(text))
    return MeshFault{
        0,
        "this is no PLY file (it does not begin with \"ply\"); export the scan again, or give the file its "
        "right ending"};
  PolygonFile file;
  if (!(ending == ".ply" ? file.openPly(text) : file.openOff(text)))
    return MeshFault{file.lineHere(), "the header " + file.fault() + exportMeshAgain};
  MeshBuilder mesh;
  if (const auto fault = readVertices(file, mesh)) return fault;
  if (const auto fault = readFaces(file, mesh)) return fault;
  return mesh.finish(read);
}

}  // namespace mien
