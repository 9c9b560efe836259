#include "AnimationData.h"

#include <fstream>
#include <sstream>

#include "AnimationTableFile.h"
#include "ExpressionsFile.h"
#include "FaceLayout.h"
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

}  // namespace

std::string readAnimationTable(const std::string& fileName, AnimationTable& table) {
  if (fileName.empty()) return table.parse(AnimationTableFile());
  std::ifstream file(fileName, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return fileName + ": the animation table cannot be read; give a JSON file";
  const std::string fault = table.parse(text.str());
  return fault.empty() ? fault : fileName + ": " + fault;
}

const ExpressionLibrary& defaultExpressions() {
  static const ExpressionLibrary library = [] {
    ExpressionLibrary parsed;
    parsed.parse(ExpressionsFile());
    return parsed;
  }();
  return library;
}

const ExpressionLibrary& defaultVisemes() {
  static const ExpressionLibrary library = [] {
    ExpressionLibrary parsed;
    parsed.parse(VisemesFile());
    return parsed;
  }();
  return library;
}

void writeMovedCurves(const ClosedCurves& neutral, const ClosedCurves& moved, vtkPolyData* input, vtkPolyData* output) {
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
