#include "AnimationData.h"

#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "AnimationTableFile.h"
#include "ExpressionsFile.h"
#include "FaceLayout.h"
#include "FacialActionsFile.h"
#include "VisemesFile.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace mien {

namespace {

constexpr size_t largestFile = 4 << 20;  // bytes

/// Reads the text of `what` ("animation table"). @return nothing, or what is wrong with the file
std::string readText(const std::string& fileName, const std::string& what, std::string& text) {
  std::ifstream file(fileName, std::ios::binary);
  text.assign(largestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || (file.gcount() == 0 && !file.eof()))
    return fileName + ": the " + what + " cannot be read; give a JSON file";
  text.resize(file.gcount());
  return text.size() > largestFile ? fileName + ": the file is larger than 4 MiB, and no " + what : "";
}

/// A fault with the file and, if it is known, the line.
std::string placed(const std::string& fileName, int line, const std::string& fault) {
  return fault.empty() ? "" : fileName + (line > 0 ? ":" + std::to_string(line) : "") + ": " + fault;
}

/// The curve that a line holds: by `CurveId`, else by the order of the lines; -1 for none.
int curveOfLine(vtkPolyData* data, vtkIdType line) {
  vtkDataArray* ids = data->GetCellData()->GetArray("CurveId");
  for (int index = 0; index < FaceLayout::curveCount; ++index)
    if (ids ? ids->GetTuple1(data->GetNumberOfVerts() + line) == FaceLayout::curveId(index) : line == index)
      return index;
  return -1;
}

void setPoint(vtkPoints* points, vtkDoubleArray* displacement, vtkIdType id, const Eigen::RowVector3d& neutral,
              const Eigen::RowVector3d& moved) {
  const Eigen::RowVector3d shift = moved - neutral;
  points->SetPoint(id, moved.data());
  displacement->SetTypedTuple(id, shift.data());
}

vtkSmartPointer<vtkPoints> doublePoints(vtkPoints* source) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->DeepCopy(source);
  return points;
}

/// The data with an own point for every line: where two lines share one (the closed lips, from a file that merged equal
/// points) the later line gets a copy with the point's arrays, or the mouth could not open.
vtkSmartPointer<vtkPolyData> withOwnPoints(vtkPolyData* data) {
  std::vector<vtkIdType> lineOfPoint(data->GetNumberOfPoints(), -1), source(data->GetNumberOfPoints());
  std::iota(source.begin(), source.end(), 0);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line) {
    data->GetLines()->GetCellAtId(line, ids);
    std::map<vtkIdType, vtkIdType> copies;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      const vtkIdType id = ids->GetId(i);
      if (lineOfPoint[id] < 0) lineOfPoint[id] = line;
      if (lineOfPoint[id] == line) continue;
      const auto [copy, isNew] = copies.try_emplace(id, static_cast<vtkIdType>(source.size()));
      if (isNew) source.push_back(id);
      ids->SetId(i, copy->second);
    }
    lines->InsertNextCell(ids);
  }
  const auto count = static_cast<vtkIdType>(source.size());
  if (count == data->GetNumberOfPoints()) return data;
  const auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  own->GetPointData()->CopyAllocate(data->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i) {
    points->SetPoint(i, data->GetPoint(source[i]));
    own->GetPointData()->CopyData(data->GetPointData(), source[i], i);
  }
  own->SetPoints(points);
  own->SetLines(lines);
  return own;
}

}  // namespace

std::string readAnimationTable(const std::string& fileName, AnimationTable& table) {
  if (fileName.empty()) return table.parse(AnimationTableFile());
  std::string text, fault = readText(fileName, "animation table", text);
  if (!fault.empty()) return fault;
  fault = table.parse(text);
  return placed(fileName, table.faultLine(), fault);
}

std::string readFacialActions(const std::string& fileName, FacialActionMap& map) {
  if (fileName.empty()) return map.parse(FacialActionsFile());
  std::string text, fault = readText(fileName, "facial action map", text);
  if (!fault.empty()) return fault;
  fault = map.parse(text);
  return placed(fileName, map.faultLine, fault);
}

const ExpressionLibrary& defaultExpressions() {
  static const ExpressionLibrary library = [] {
    ExpressionLibrary parsed;
    parsed.parse(ExpressionsFile());
    return parsed;
  }();
  return library;
}

const FacialActionMap& defaultFacialActions() {
  static const FacialActionMap map = [] {
    FacialActionMap parsed;
    parsed.parse(FacialActionsFile());
    return parsed;
  }();
  return map;
}

const ExpressionLibrary& defaultVisemes() {
  static const ExpressionLibrary library = [] {
    ExpressionLibrary parsed;
    parsed.parse(VisemesFile());
    return parsed;
  }();
  return library;
}

void writeMovedCurves(const ClosedCurves& neutral, const ClosedCurves& moved, vtkPolyData* curves,
                      vtkPolyData* output) {
  const vtkSmartPointer<vtkPolyData> input = withOwnPoints(curves);
  output->ShallowCopy(input);
  vtkSmartPointer<vtkPoints> points = doublePoints(input->GetPoints());
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName("Displacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(points->GetNumberOfPoints());
  displacement->Fill(0.0);
  vtkNew<vtkIdList> ids;
  const int k = neutral.pointsPerCurve;
  for (vtkIdType line = 0; line < input->GetNumberOfLines(); ++line) {
    const int curve = curveOfLine(input, line);
    if (curve < 0) continue;
    input->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      setPoint(points, displacement, ids->GetId(i), neutral.points.row(curve * k + i % k),
               moved.points.row(curve * k + i % k));
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(displacement);
}

}  // namespace mien
