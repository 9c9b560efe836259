#include "WholeMesh.h"

#include <sstream>

#include "Failure.h"
#include "MeshFile.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "SurfaceFile.h"
#include "TextFileReader.h"
#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr std::size_t largestText = 4'000'000'000;

template <class Reader>
vtkSmartPointer<vtkPolyData> readBy(const std::string& name) {
  vtkNew<Reader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(name.c_str());
  reader->Update();
  return errors.first().empty() ? reader->GetOutput() : nullptr;
}

/// Whether two readers found the same points, but for single precision.
bool haveSamePoints(vtkPolyData* a, vtkPolyData* b) {
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints()) return false;
  const double tolerance = 1e-5 * a->GetLength();
  double p[3], q[3];
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i) {
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    if (!(vtkMath::Distance2BetweenPoints(p, q) <= tolerance * tolerance)) return false;
  }
  return true;
}

bool isVertex(const std::string& line) {
  return line.size() > 2 && line[0] == 'v' && (line[1] == ' ' || line[1] == '\t');
}

/// What stands behind the three coordinates of a vertex: a weight or a colour.
std::string restOf(const std::string& line) {
  std::istringstream words(line.substr(1));
  std::string word, rest;
  for (int i = 0; i < 3; ++i) words >> word;
  std::getline(words, rest);
  return rest;
}

/// The text with other vertices; nothing when it has another number of them.
std::string withVertices(const std::string& text, vtkPointSet* moved) {
  std::istringstream lines(text);
  std::string result;
  vtkIdType next = 0;
  for (std::string line; std::getline(lines, line); result += line + "\n") {
    if (!isVertex(line)) continue;
    if (next == moved->GetNumberOfPoints()) return {};
    const std::string rest = restOf(line);
    line = "v";
    for (int axis = 0; axis < 3; ++axis) appendNumber(line += " ", moved->GetPoint(next)[axis]);
    line += rest;
    ++next;
  }
  return next == moved->GetNumberOfPoints() ? result : std::string();
}

}  // namespace

vtkSmartPointer<vtkDataObject> readWholeMesh(const std::string& name) {
  const vtkSmartPointer<vtkDataObject> mesh = readMesh(name);
  const std::string ending = fileEnding(name);
  auto* triangles = vtkPolyData::SafeDownCast(mesh);
  if (!triangles || (ending != "ply" && ending != "obj")) return mesh;
  const auto whole = ending == "ply" ? readBy<vtkPLYReader>(name) : readBy<vtkOBJReader>(name);
  if (!whole || !haveSamePoints(triangles, whole) || whole->GetNumberOfPolys() == 0) return mesh;
  triangles->SetPolys(whole->GetPolys());
  triangles->GetPointData()->ShallowCopy(whole->GetPointData());
  triangles->GetCellData()->Initialize();
  return mesh;
}

void writeMovedMesh(vtkPointSet* moved, const std::string& source, const std::string& name) {
  std::string text;
  if (fileEnding(source) == "obj" && fileEnding(name) == "obj" && readTextFile(source, largestText, text).empty())
    text = withVertices(text, moved);
  else
    text.clear();
  text.empty() ? writeMesh(moved, name) : OutputFile::write(name, text);
}

}  // namespace mien
