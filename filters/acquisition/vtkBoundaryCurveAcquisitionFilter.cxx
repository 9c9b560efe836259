#include "vtkBoundaryCurveAcquisitionFilter.h"

#include <cmath>
#include <sstream>

#include "BoundaryCurveData.h"
#include "LandmarkTable.h"
#include "MeshData.h"
#include "MeshSeries.h"
#include "ReferenceFace.h"
#include "ScanAcquisition.h"
#include "SurfaceMesh.h"
#include "TextFileReader.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBoundaryCurveAcquisitionFilter);

namespace {

constexpr int maximumPointsPerCurve = 4096;
constexpr int fewestTriangles = 1000;
constexpr std::size_t largestLandmarkFile = 1 << 20;  // bytes

std::string readLandmarkFile(const std::string& name, mien::LandmarkTable& table) {
  std::string text;
  std::string fault = mien::readTextFile(name, largestLandmarkFile, text, "CSV file with landmarks");
  if (fault.empty()) fault = mien::parseLandmarks(text, table);
  return fault.empty() ? fault : name + ":" + fault;
}

void writeMotion(const mien::Similarity& motion, vtkFieldData* fields) {
  vtkNew<vtkDoubleArray> array;
  array->SetName("ScanToFace");
  array->SetNumberOfComponents(16);
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = motion.scale * motion.rotation;
  matrix.topRightCorner<3, 1>() = motion.translation;
  array->InsertNextTuple(matrix.data());
  fields->AddArray(array);
}

}  // namespace

vtkBoundaryCurveAcquisitionFilter::vtkBoundaryCurveAcquisitionFilter() : Acquired(new mien::AcquiredScan) {
  this->SetNumberOfOutputPorts(2);
}

vtkBoundaryCurveAcquisitionFilter::~vtkBoundaryCurveAcquisitionFilter() {
  this->SetLandmarkFileName(nullptr);
}

const mien::AcquiredScan& vtkBoundaryCurveAcquisitionFilter::GetAcquired() const {
  return *this->Acquired;
}

std::string vtkBoundaryCurveAcquisitionFilter::DescribeSettings() const {
  if (this->PointsPerCurve % 2 != 0 || this->PointsPerCurve < 8 || this->PointsPerCurve > maximumPointsPerCurve)
    return "points per curve must be an even number from 8 to " + std::to_string(maximumPointsPerCurve) + ", not " +
           std::to_string(this->PointsPerCurve);
  if (!(this->Scale >= 0.0) || !std::isfinite(this->Scale))
    return "the scale must be a number of mm above 0, or 0 to have it recognised";
  if (this->Triangles != 0 && this->Triangles < fewestTriangles)
    return "a scan can be decimated to " + std::to_string(fewestTriangles) + " triangles or more, not to " +
           std::to_string(this->Triangles);
  return {};
}

std::string vtkBoundaryCurveAcquisitionFilter::Measure(vtkPolyData* scan) {
  mien::LandmarkTable table;
  mien::FaceLandmarks landmarks;
  mien::TriangleMesh mesh;
  std::string fault = this->DescribeSettings();
  if (fault.empty() && this->LandmarkFileName && *this->LandmarkFileName)
    fault = readLandmarkFile(this->LandmarkFileName, table);
  if (fault.empty()) fault = mien::readTriangleMesh(scan, mesh);
  if (fault.empty()) fault = mien::placeLandmarks(table, mesh, landmarks);
  if (!fault.empty()) return fault;
  mien::CleanMesh clean = mien::cleaned(mesh);
  const mien::Progress progress = [this](double done) {
    this->UpdateProgress(done);
    return this->GetAbortExecute() == 0;
  };
  const double decimated = this->Triangles > 0 ? 0.3 : 0.0;
  if (this->Triangles > 0 && !mien::decimate(clean.mesh, this->Triangles, mien::partOf(progress, 0.0, decimated)))
    return "stopped before the curves were measured";
  mien::ScanSettings settings;
  settings.millimetres = this->Scale;
  settings.pose = static_cast<mien::ScanSettings::Pose>(this->Pose);
  settings.allParts = this->AllParts;
  settings.nostrils = this->Nostrils;
  settings.compareLandmarks = this->CompareLandmarks;
  settings.pointsPerCurve = this->PointsPerCurve;
  return mien::acquireScan(clean, table.given, landmarks, mien::referenceTemplate(), settings, *this->Acquired,
                           mien::partOf(progress, decimated, 1.0));
}

/// The whole scan, whatever piece of the curves is wanted.
int vtkBoundaryCurveAcquisitionFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                           vtkInformationVector*) {
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkBoundaryCurveAcquisitionFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                                   vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  *this->Acquired = mien::AcquiredScan();
  const std::string fault = this->Measure(vtkPolyData::GetData(inputs[0]));
  if (this->GetAbortExecute()) return 1;
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFaceCurves(this->Acquired->face, vtkPolyData::GetData(outputs, 0));
  writeMotion(this->Acquired->report.scanToFace, vtkPolyData::GetData(outputs, 0)->GetFieldData());
  mien::writeTriangleMesh(this->Acquired->mesh, vtkPolyData::GetData(outputs, 1));
  return 1;
}

void vtkBoundaryCurveAcquisitionFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LandmarkFileName: " << (this->LandmarkFileName ? this->LandmarkFileName : "(none)") << "\n";
  os << indent << "PointsPerCurve: " << this->PointsPerCurve << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Pose: " << this->Pose << "\n";
  os << indent << "Triangles: " << this->Triangles << "\n";
  os << indent << "AllParts: " << (this->AllParts ? "on" : "off") << "\n";
  os << indent << "Nostrils: " << (this->Nostrils ? "on" : "off") << "\n";
  os << indent << "CompareLandmarks: " << (this->CompareLandmarks ? "on" : "off") << "\n";
}
