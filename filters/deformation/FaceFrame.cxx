#include "FaceFrame.h"

#include <cmath>

#include "BoundaryCurveData.h"
#include "DefaultRegions.h"
#include "GridFaceSides.h"
#include "LandmarkTable.h"
#include "MeshEdgeData.h"
#include "NumberText.h"
#include "TextFileReader.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr std::size_t largestText = 5'000'000;  // landmark files and region maps have a few kB

vtkDataArray* pointArray(vtkPointSet* data, const char* name, int components) {
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

vtkStringArray* markerNames(vtkPointSet* data) {
  return vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("marker"));
}

/// The numbers of the 68 landmarks' vertices. @return nothing, or what is wrong
std::string placeLandmarks(const std::string& file, const MeshVertices& vertices, LandmarkVertices& landmarks) {
  std::string text;
  LandmarkTable table;
  std::string fault = readTextFile(file, largestText, text);
  if (fault.empty()) fault = parseLandmarks(text, table);
  if (!fault.empty()) return file + ":" + fault;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    Eigen::Index vertex = table.hasVertices ? table.vertices[i] : 0;
    if (!table.hasVertices)
      (vertices.rowwise() - table.positions.points.row(i)).rowwise().squaredNorm().minCoeff(&vertex);
    if (vertex < 0 || vertex >= vertices.rows())
      return file + ": landmark " + std::to_string(i) + " is vertex " + std::to_string(vertex) + ", but the mesh has " +
             std::to_string(vertices.rows()) + "; give the landmarks of this mesh";
    landmarks[i] = static_cast<int>(vertex);
  }
  return {};
}

MeshVertices verticesOf(vtkPointSet* data) {
  MeshVertices vertices(data->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) data->GetPoint(i, vertices.row(i).data());
  return vertices;
}

bool findByName(vtkPointSet* data, const FaceFrameOptions& options, EyePupils& pupils) {
  vtkStringArray* names = markerNames(data);
  if (!names) return false;
  const vtkIdType left = names->LookupValue(options.leftPupilName), right = names->LookupValue(options.rightPupilName);
  if (left < 0 || right < 0) return false;
  data->GetPoint(left, pupils.left.data());
  data->GetPoint(right, pupils.right.data());
  return true;
}

bool findInField(vtkPointSet* data, EyePupils& pupils) {
  vtkDataArray* array = data->GetFieldData()->GetArray("Pupils");
  if (!array || array->GetNumberOfTuples() != 2 || array->GetNumberOfComponents() != 3) return false;
  array->GetTuple(0, pupils.left.data());
  array->GetTuple(1, pupils.right.data());
  return true;
}

std::string findByLandmarks(vtkPointSet* data, const std::string& file, EyePupils& pupils) {
  const MeshVertices vertices = verticesOf(data);
  LandmarkVertices landmarks;
  MeshEdges edges;
  std::string fault = placeLandmarks(file, vertices, landmarks);
  if (fault.empty()) fault = readEdges(data, edges);
  if (fault.empty()) pupils = eyePupils(vertices, edges, landmarks);
  return fault;
}

std::string findPupils(vtkPointSet* data, const FaceFrameOptions& options, EyePupils& pupils) {
  pupils = {options.leftPupil, options.rightPupil};
  if (options.leftPupil != options.rightPupil || findByName(data, options, pupils) || findInField(data, pupils))
    return {};
  if (!options.landmarkFile.empty()) return findByLandmarks(data, options.landmarkFile, pupils);
  return "there are no pupils; set both, name two points " + options.leftPupilName + " and " + options.rightPupilName +
         " in the point array marker, add the field array Pupils (2 x 3), or give the 68 landmarks";
}

Eigen::Vector3d unturned(const HeadRotation& turned, const Eigen::Vector3d& point) {
  return turned.rotation.transpose() * (point - turned.centre) + turned.centre;
}

std::string readPoints(vtkPointSet* data, FaceFrame& frame) {
  vtkDataArray* normals = pointArray(data, "Normals", 3);
  std::vector<Eigen::Vector3d> computed;
  if (!normals) computed = polygonNormals(data);
  frame.isMesh = normals || !computed.empty();
  frame.points.resize(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    DeformationPoint& point = frame.points[i];
    Eigen::Vector3d place, normal = Eigen::Vector3d::UnitZ();
    data->GetPoint(i, place.data());
    if (normals)
      normals->GetTuple(i, normal.data());
    else if (!computed.empty())
      normal = computed[i];
    if (!place.allFinite() || !normal.allFinite())
      return "point " + std::to_string(i) + " has a position or normal that is not finite; repair the mesh";
    point.position = unturned(frame.turned, place);
    point.normalZ = (frame.turned.rotation.transpose() * normal).z();
  }
  return {};
}

/// Sides that the data bring along. @return whether there are any
bool readSideArrays(vtkPointSet* data, FaceFrame& frame, std::string& fault) {
  vtkDataArray *lips = pointArray(data, "LipSide", 1), *lids = pointArray(data, "LidSide", 1);
  for (std::size_t i = 0; (lips || lids) && i < frame.points.size(); ++i) {
    if (lips) frame.points[i].side.lips = lips->GetComponent(i, 0);
    if (lids) frame.points[i].side.lids = lids->GetComponent(i, 0);
    if (!(std::abs(frame.points[i].side.lips) <= 1.0) || !(std::abs(frame.points[i].side.lids) <= 1.0))
      fault =
          "point " + std::to_string(i) + " has a LipSide or LidSide that is no number from -1 to 1; repair the array";
  }
  return lips || lids;
}

/// Sides by the names of points. @return whether there are names
bool readMarkerSides(vtkPointSet* data, FaceFrame& frame) {
  vtkStringArray* names = markerNames(data);
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i) {
    const std::string& name = names->GetValue(i);
    const auto number =
        name.rfind("landmark", 0) == 0 ? parseWholeNumber(std::string_view(name).substr(8)) : std::nullopt;
    if (number && *number >= 0 && *number < 68) frame.points[i].side = landmarkSide(static_cast<int>(*number));
  }
  return names;
}

std::string readSides(vtkPointSet* data, const FaceFrameOptions& options, const FacialRegions& regions,
                      FaceFrame& frame) {
  std::string fault;
  if (readSideArrays(data, frame, fault) || readMarkerSides(data, frame)) return fault;
  std::vector<FaceSide> sides;
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data)) sides = gridFaceSides(grid, regions, frame);
  if (sides.empty() && !options.landmarkFile.empty()) {
    MeshEdges edges;
    LandmarkVertices landmarks;
    const MeshVertices vertices = verticesOf(data);
    fault = placeLandmarks(options.landmarkFile, vertices, landmarks);
    if (fault.empty()) fault = readEdges(data, edges);
    if (fault.empty()) sides = faceSides(vertices, edges, landmarks, regions, frame.pupils.unit());
  }
  for (std::size_t i = 0; i < sides.size(); ++i) frame.points[i].side = sides[i];
  return fault;
}

std::string readGivenRegions(vtkPointSet* data, FaceFrame& frame) {
  vtkDataArray* given = pointArray(data, "region", 1);
  for (std::size_t i = 0; given && i < frame.points.size(); ++i) {
    const double value = given->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= FacialRegions::count))
      return "point " + std::to_string(i) + " has a region outside 0 .. 16; 1 to 16 are regions, 0 is by place";
    frame.points[i].region = static_cast<int>(value);
  }
  return {};
}

}  // namespace

std::string readPupils(vtkPointSet* data, const FaceFrameOptions& options, FaceFrame& frame) {
  std::string fault = readHeadRotation(data->GetFieldData(), frame.turned);
  if (fault.empty()) fault = findPupils(data, options, frame.places);
  return fault.empty()
             ? frame.pupils.set(unturned(frame.turned, frame.places.left), unturned(frame.turned, frame.places.right))
             : fault;
}

std::string readFaceFrame(vtkPointSet* data, const FaceFrameOptions& options, const FacialRegions& regions,
                          FaceFrame& frame) {
  std::string fault = readPupils(data, options, frame);
  if (fault.empty()) fault = readPoints(data, frame);
  if (fault.empty()) fault = readSides(data, options, regions, frame);
  return fault.empty() ? readGivenRegions(data, frame) : fault;
}

std::string readRegions(const std::string& file, FacialRegions& regions) {
  regions = defaultRegions();
  if (file.empty()) return {};
  std::string text;
  const std::string unreadable = readTextFile(file, largestText, text);
  if (!unreadable.empty()) return file + ":" + unreadable;
  const std::string fault = regions.parse(text);
  return fault.empty() ? fault : file + ": " + fault;
}

}  // namespace mien
