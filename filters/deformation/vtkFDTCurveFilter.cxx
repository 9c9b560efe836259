#include "vtkFDTCurveFilter.h"

#include <cmath>

#include "BoundaryCurveData.h"
#include "DefaultRegions.h"
#include "FDTData.h"
#include "FaceLayout.h"
#include "GridSides.h"
#include "MouthCorners.h"
#include "MovedCurveOrder.h"
#include "SurfaceMesh.h"
#include "TableDeformation.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTCurveFilter);

namespace {

using namespace mien;

constexpr double upperLid = 8.0, lowerLid = 9.0;  // indices of C9 and C10
constexpr double fullTurn = 2.0 * 3.14159265358979323846;

/// The curves as rows of a grid around the head, in its own frame.
struct CurveRows {
  FaceCurves face;
  HeadRotation turned;
  PupilNormalisation pupils;

  std::string read(vtkPolyData* data) {
    std::string fault = readFaceCurves(data, face);
    if (fault.empty()) fault = readHeadRotation(data->GetFieldData(), turned);
    if (!fault.empty()) return fault;
    const MouthCorners corners(face);
    mouthBegin = corners.begin;
    mouthEnd = corners.end;
    turned.undo(face.curves.points);
    const auto unturned = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return turned.rotation.transpose() * (p - turned.centre) + turned.centre;
    };
    return pupils.set(unturned(face.leftPupil), unturned(face.rightPupil));
  }

  Eigen::Vector3d point(int row, int column) const { return face.curves.curve(row).row(column).transpose(); }

  std::vector<FaceSide> sides(const FacialRegions& regions) const {
    GridSlits slits;
    slits.rows = face.curves.count;
    slits.columns = face.curves.pointsPerCurve;
    if (mouthEnd > mouthBegin) slits.upperLip = FaceLayout::upperLip;
    slits.openBegin = static_cast<int>(std::floor(mouthBegin / fullTurn * slits.columns));
    slits.openEnd = static_cast<int>(std::ceil(mouthEnd / fullTurn * slits.columns));
    slits.upperLid = upperLid;
    slits.lowerLid = lowerLid;
    return gridSides(
        slits, [this](int row, int column) { return point(row, column); }, regions, pupils);
  }

  std::vector<DeformationPoint> points(const FacialRegions& regions) const {
    const std::vector<FaceSide> all = sides(regions);
    std::vector<DeformationPoint> result(all.size());
    for (int row = 0; row < face.curves.count; ++row)
      for (int column = 0; column < face.curves.pointsPerCurve; ++column) {
        DeformationPoint& p = result[row * face.curves.pointsPerCurve + column];
        p.position = point(row, column);
        p.side = all[row * face.curves.pointsPerCurve + column];
      }
    return result;
  }

 private:
  double mouthBegin = 0.0, mouthEnd = 0.0;
};

/// Displacements in the head's own frame that leave the curves in order down the face.
std::vector<Eigen::Vector3d> orderedMoves(const CurveRows& rows, const std::vector<Eigen::Vector2d>& moves,
                                          MovedCurveOrder* order) {
  const ClosedCurves& before = rows.face.curves;
  ClosedCurves moved = before;
  for (std::size_t i = 0; i < moves.size(); ++i) moved.points.row(i).head<2>() += moves[i].transpose();
  const ClosedCurves given = moved;
  *order = MovedCurveOrder(before, moved);
  std::vector<Eigen::Vector3d> result;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    result.emplace_back(moves[i].x(), moves[i].y(), 0.0);
    if (moved.points.row(i) != given.points.row(i))
      result.back() = (moved.points.row(i) - before.points.row(i)).transpose();
  }
  return result;
}

/// Moves the points of the output, which are stored curve after curve as readFaceCurves() has them.
void movePoints(vtkPolyData* output, const CurveRows& rows, const std::vector<Eigen::Vector3d>& moves) {
  vtkDataArray* before = output->GetPointData()->GetArray("Displacement");
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName("Displacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(output->GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->DeepCopy(output->GetPoints());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    const Eigen::Vector3d move = rows.turned.rotation * moves[i];
    Eigen::Vector3d place, sum = Eigen::Vector3d::Zero();
    points->GetPoint(id, place.data());
    points->SetPoint(id, (place + move).eval().data());
    if (before && before->GetNumberOfComponents() == 3) before->GetTuple(id, sum.data());
    displacement->SetTuple(id, (sum + move).eval().data());
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(displacement);
}

}  // namespace

vtkFDTCurveFilter::vtkFDTCurveFilter() {
  this->SetNumberOfInputPorts(2);
}

int vtkFDTCurveFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkFDTCurveFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  for (int port = 0; port < 2; ++port) mien::requestWhole(inputs[port]->GetInformationObject(0));
  return 1;
}

int vtkFDTCurveFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  vtkPolyData *input = vtkPolyData::GetData(inputs[0]), *output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfPoints() == 0) return 1;
  mien::DeformationTable table;
  CurveRows rows;
  std::string fault = mien::readFDT(vtkTable::GetData(inputs[1]), table);
  if (fault.empty() && !std::isfinite(this->Strength)) fault = "the strength is not finite; give 0 to 1.5";
  if (fault.empty()) fault = rows.read(input);
  if (fault.empty() && rows.face.curves.points.rows() != input->GetNumberOfPoints())
    fault = "there are points beside the 29 curves; give the curves alone";
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  const mien::FacialRegions& regions = mien::defaultRegions();
  const mien::TableDeformation deformation(rows.points(regions), rows.pupils, regions, this->Smooth);
  std::vector<Eigen::Vector2d> moves(deformation.size());
  deformation.displacements(table, mien::fittedDisplacement(table, regions), this->Strength, 0, moves.size(),
                            moves.data());
  output->ShallowCopy(input);
  mien::MovedCurveOrder order;
  movePoints(output, rows, orderedMoves(rows, moves, &order));
  this->Pushed = order.pushed;
  this->KeptShare = order.keptShare;
  this->Crossings = order.crossings;
  if (order.keptShare < 1.0)
    vtkWarningMacro("the curves would cross: " << std::lround(100.0 * order.keptShare)
                                               << " % of the table's movement were kept");
  return 1;
}

void vtkFDTCurveFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Pushed: " << this->Pushed << "\n";
  os << indent << "Crossings: " << this->Crossings << "\n";
  os << indent << "KeptShare: " << this->KeptShare << "\n";
  os << indent << "Smooth: " << (this->Smooth ? "on" : "off") << "\n";
}
