#include "vtkBoundaryCurveAcquisitionFilter.h"

#include "BoundaryCurveData.h"
#include "FaceAcquisition.h"
#include "LandmarkTable.h"
#include "MeshData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <fstream>
#include <sstream>

vtkStandardNewMacro(vtkBoundaryCurveAcquisitionFilter);

namespace
{

constexpr int maximumPointsPerCurve = 4096;

std::string readLandmarkFile(const std::string& name, mien::LandmarkTable& table)
{
  if (name.empty())
    return "there is no landmark file; give a CSV file with the 68 landmarks";
  std::ifstream file(name);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
    return name + ": there is no such file or it is empty; give a CSV file with the 68 landmarks";
  const std::string fault = mien::parseLandmarks(text.str(), table);
  return fault.empty() ? fault : name + ":" + fault;
}

std::string describePointCount(int count)
{
  if (count % 2 == 0 && count >= 8 && count <= maximumPointsPerCurve)
    return {};
  return "points per curve must be an even number from 8 to " + std::to_string(maximumPointsPerCurve) + ", not " +
    std::to_string(count);
}

std::string measure(vtkPolyData* scan, const std::string& landmarkFile, int pointsPerCurve, mien::FaceCurves& face)
{
  mien::LandmarkTable table;
  mien::FaceLandmarks landmarks;
  mien::TriangleMesh mesh;
  std::string fault = describePointCount(pointsPerCurve);
  if (fault.empty())
    fault = readLandmarkFile(landmarkFile, table);
  if (fault.empty())
    fault = mien::readTriangleMesh(scan, mesh);
  if (fault.empty())
    fault = mien::placeLandmarks(table, mesh, landmarks);
  return fault.empty() ? mien::acquireFace(mesh, landmarks, pointsPerCurve, face) : fault;
}

} // namespace

vtkBoundaryCurveAcquisitionFilter::vtkBoundaryCurveAcquisitionFilter() = default;

vtkBoundaryCurveAcquisitionFilter::~vtkBoundaryCurveAcquisitionFilter()
{
  this->SetLandmarkFileName(nullptr);
}

int vtkBoundaryCurveAcquisitionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  mien::FaceCurves face;
  const std::string fault = measure(vtkPolyData::GetData(inputs[0]),
    this->LandmarkFileName ? this->LandmarkFileName : "", this->PointsPerCurve, face);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFaceCurves(face, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkBoundaryCurveAcquisitionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LandmarkFileName: " << (this->LandmarkFileName ? this->LandmarkFileName : "(none)") << "\n";
  os << indent << "PointsPerCurve: " << this->PointsPerCurve << "\n";
}
