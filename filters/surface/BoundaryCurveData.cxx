#include "BoundaryCurveData.h"

#include <cmath>
#include <vector>

#include "FaceLayout.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace mien {

namespace {

/// Number of different points of a closed line, or 0 when it does not end where it begins.
vtkIdType closedLineLength(vtkPolyData* data, vtkIdList* ids) {
  const vtkIdType n = ids->GetNumberOfIds();
  if (n < 3) return 0;
  if (ids->GetId(0) == ids->GetId(n - 1))
    return n - 1;  // also where the point is not finite, which is told apart later
  double first[3], last[3];
  data->GetPoint(ids->GetId(0), first);
  data->GetPoint(ids->GetId(n - 1), last);
  const bool closed = std::equal(first, first + 3, last);
  return closed ? n - 1 : 0;
}

/// Curves count from 1, as the face's do.
std::string lineName(vtkIdType line) {
  return "curve " + std::to_string(line + 1);
}

std::string checkLines(vtkPolyData* data) {
  if (!data || data->GetNumberOfLines() == 0) return "there are no lines; boundary curves are closed polylines";
  if (!data->GetLines()->IsValid())
    return "the lines have offsets that do not fit their point ids; write the file again";
  vtkNew<vtkIdList> ids;
  vtkIdType expected = 0;
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line) {
    data->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      if (ids->GetId(i) < 0 || ids->GetId(i) >= data->GetNumberOfPoints())
        return lineName(line) + " uses point " + std::to_string(ids->GetId(i)) + " of " +
               std::to_string(data->GetNumberOfPoints());
    const vtkIdType length = closedLineLength(data, ids);
    if (length == 0) return lineName(line) + " is not closed; its last point must repeat its first";
    expected = line == 0 ? length : expected;
    if (length != expected)
      return lineName(line) + " has " + std::to_string(length) + " points where the others have " +
             std::to_string(expected);
  }
  return {};
}

/// For every curve of the layout the line that holds it, from `CurveId` where there is one.
std::string orderOfLines(vtkPolyData* data, std::vector<vtkIdType>& lineOfCurve) {
  lineOfCurve.assign(FaceLayout::curveCount, -1);
  vtkDataArray* ids = data->GetCellData()->GetArray("CurveId");
  if (ids && ids->GetNumberOfTuples() < data->GetNumberOfCells())
    return "array CurveId is shorter than the number of curves";
  const vtkIdType firstLine = data->GetNumberOfVerts();
  for (int index = 0; index < FaceLayout::curveCount; ++index)
    for (vtkIdType line = 0; line < data->GetNumberOfLines() && lineOfCurve[index] < 0; ++line)
      if (ids ? ids->GetTuple1(firstLine + line) == FaceLayout::curveId(index) : line == index)
        lineOfCurve[index] = line;
  for (int index = 0; index < FaceLayout::curveCount; ++index)
    if (lineOfCurve[index] < 0) return "curve " + FaceLayout::curveName(index) + " is missing";
  return {};
}

std::string readFeatures(vtkFieldData* fields, FaceCurves& face) {
  auto* ids = vtkStringArray::SafeDownCast(fields->GetAbstractArray("FeatureId"));
  vtkDataArray* curve = fields->GetArray("FeatureCurve");
  vtkDataArray* v = fields->GetArray("FeatureV");
  if (!ids || !curve || !v) return {};
  const vtkIdType n = ids->GetNumberOfValues();
  for (vtkDataArray* array : {curve, v})
    if (array->GetNumberOfTuples() != n || array->GetNumberOfComponents() != 1)
      return "field array " + std::string(array->GetName()) + " has " + std::to_string(array->GetNumberOfValues()) +
             " values for the " + std::to_string(n) + " of FeatureId; give one for each";
  for (vtkIdType i = 0; i < n; ++i) {
    const double asked = curve->GetTuple1(i);
    if (!(asked >= 1.0 && asked <= FaceLayout::curveCount && std::floor(asked) == asked))
      return "field array FeatureCurve, value " + std::to_string(i) + " (feature point " + ids->GetValue(i) +
             ") is no curve; give a CurveId from 1 to " + std::to_string(FaceLayout::curveCount);
    const int id = static_cast<int>(asked);
    const int index = id == FaceLayout::curveCount ? FaceLayout::lowerLip : (id <= FaceLayout::lowerLip ? id - 1 : id);
    face.features.push_back({ids->GetValue(i), index, v->GetTuple1(i)});
  }
  return {};
}

/// Lengths in another unit would pass for a face of another size; without the array they are taken as mm.
std::string describeUnitsFault(vtkFieldData* fields) {
  auto* units = vtkStringArray::SafeDownCast(fields->GetAbstractArray("Units"));
  if (!units || units->GetNumberOfValues() == 0 || units->GetValue(0) == "mm") return {};
  return "field array Units says '" + units->GetValue(0) + "', but lengths are in mm here; convert the curves to mm";
}

void readPupils(vtkFieldData* fields, FaceCurves& face) {
  vtkDataArray* pupils = fields->GetArray("Pupils");
  face.hasPupils = pupils && pupils->GetNumberOfTuples() == 2 && pupils->GetNumberOfComponents() == 3;
  if (!face.hasPupils) return;
  pupils->GetTuple(0, face.leftPupil.data());
  pupils->GetTuple(1, face.rightPupil.data());
}

void copyLine(vtkPolyData* data, vtkIdType line, ClosedCurves& curves, int index) {
  vtkNew<vtkIdList> ids;
  data->GetLines()->GetCellAtId(line, ids);
  auto curve = curves.curve(index);
  for (int j = 0; j < curves.pointsPerCurve; ++j) data->GetPoint(ids->GetId(j), curve.row(j).data());
}

int pointsPerLine(vtkPolyData* data) {
  vtkNew<vtkIdList> ids;
  data->GetLines()->GetCellAtId(0, ids);
  return static_cast<int>(ids->GetNumberOfIds()) - 1;
}

void addFeatureArrays(const FaceCurves& face, vtkFieldData* fields) {
  vtkNew<vtkStringArray> ids;
  ids->SetName("FeatureId");
  vtkNew<vtkIntArray> curve;
  curve->SetName("FeatureCurve");
  vtkNew<vtkDoubleArray> v;
  v->SetName("FeatureV");
  for (const FeaturePoint& feature : face.features) {
    ids->InsertNextValue(feature.id);
    curve->InsertNextValue(FaceLayout::curveId(feature.curve));
    v->InsertNextValue(feature.v);
  }
  fields->AddArray(ids);
  fields->AddArray(curve);
  fields->AddArray(v);
}

void addPupils(const FaceCurves& face, vtkFieldData* fields) {
  vtkNew<vtkDoubleArray> pupils;
  pupils->SetName("Pupils");
  pupils->SetNumberOfComponents(3);
  pupils->InsertNextTuple(face.leftPupil.data());
  pupils->InsertNextTuple(face.rightPupil.data());
  fields->AddArray(pupils);
}

void addUnits(vtkFieldData* fields) {
  vtkNew<vtkStringArray> units;
  units->SetName("Units");
  units->InsertNextValue("mm");
  fields->AddArray(units);
}

void addCurveArrays(vtkCellData* cells) {
  vtkNew<vtkIntArray> ids;
  ids->SetName("CurveId");
  vtkNew<vtkStringArray> names;
  names->SetName("CurveName");
  for (int index = 0; index < FaceLayout::curveCount; ++index) {
    ids->InsertNextValue(FaceLayout::curveId(index));
    names->InsertNextValue(FaceLayout::curveName(index));
  }
  cells->AddArray(ids);
  cells->AddArray(names);
}

/// Curves run down the face in the head's own frame, however the head is turned.
FaceCurves inOwnFrame(const FaceCurves& face, const HeadRotation& turned) {
  FaceCurves own = face;
  turned.undo(own.curves.points);
  return own;
}

}  // namespace

std::string readHeadRotation(vtkFieldData* fields, HeadRotation& turned) {
  vtkDataArray* array = fields->GetArray("HeadRotation");
  if (!array) return {};
  const std::string advice = "; it holds a rotation (9 numbers, row by row) and its centre (3, mm)";
  if (array->GetNumberOfComponents() != 12 || array->GetNumberOfTuples() != 1)
    return "the field array HeadRotation does not hold 12 numbers" + advice;
  HeadRotation read;
  for (int i = 0; i < 9; ++i) read.rotation(i / 3, i % 3) = array->GetComponent(0, i);
  for (int i = 0; i < 3; ++i) read.centre[i] = array->GetComponent(0, 9 + i);
  const double error = (read.rotation * read.rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(error < 1e-6) || !read.centre.allFinite()) return "the field array HeadRotation is no rotation" + advice;
  turned = read;
  return {};
}

void writeHeadRotation(const HeadRotation& turned, vtkFieldData* fields) {
  vtkNew<vtkDoubleArray> array;
  array->SetName("HeadRotation");
  array->SetNumberOfComponents(12);
  array->SetNumberOfTuples(1);
  for (int i = 0; i < 9; ++i) array->SetComponent(0, i, turned.rotation(i / 3, i % 3));
  for (int i = 0; i < 3; ++i) array->SetComponent(0, 9 + i, turned.centre[i]);
  fields->AddArray(array);
}

std::string readClosedCurves(vtkPolyData* data, ClosedCurves& curves) {
  const std::string fault = checkLines(data);
  if (!fault.empty()) return fault;
  ClosedCurves read(static_cast<int>(data->GetNumberOfLines()), pointsPerLine(data));
  for (int index = 0; index < read.count; ++index) copyLine(data, index, read, index);
  curves = std::move(read);
  return describeFault(curves);
}

std::string readFaceCurves(vtkPolyData* data, FaceCurves& face) {
  std::vector<vtkIdType> lineOfCurve;
  std::string fault = checkLines(data);
  if (fault.empty()) fault = orderOfLines(data, lineOfCurve);
  if (!fault.empty()) return fault;
  FaceCurves read;
  read.curves = ClosedCurves(FaceLayout::curveCount, pointsPerLine(data));
  for (int index = 0; index < FaceLayout::curveCount; ++index) copyLine(data, lineOfCurve[index], read.curves, index);
  fault = describeUnitsFault(data->GetFieldData());
  if (fault.empty()) fault = readFeatures(data->GetFieldData(), read);
  readPupils(data->GetFieldData(), read);
  HeadRotation turned;
  if (fault.empty()) fault = readHeadRotation(data->GetFieldData(), turned);
  if (fault.empty()) fault = describeFault(inOwnFrame(read, turned));
  if (fault.empty()) face = std::move(read);
  return fault;
}

void writeClosedCurves(const ClosedCurves& curves, vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(curves.points.rows());
  vtkNew<vtkCellArray> lines;
  for (int index = 0; index < curves.count; ++index) {
    const vtkIdType first = static_cast<vtkIdType>(index) * curves.pointsPerCurve;
    lines->InsertNextCell(curves.pointsPerCurve + 1);
    for (int j = 0; j <= curves.pointsPerCurve; ++j) lines->InsertCellPoint(first + j % curves.pointsPerCurve);
  }
  for (vtkIdType i = 0; i < curves.points.rows(); ++i) points->SetPoint(i, curves.points.row(i).data());
  data->Initialize();
  data->SetPoints(points);
  data->SetLines(lines);
}

void writeFaceCurves(const FaceCurves& face, vtkPolyData* data) {
  writeClosedCurves(face.curves, data);
  addCurveArrays(data->GetCellData());
  addUnits(data->GetFieldData());
  addFeatureArrays(face, data->GetFieldData());
  if (face.hasPupils) addPupils(face, data->GetFieldData());
}

}  // namespace mien
