#include "FaceFrame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "BoundaryCurveData.h"
#include "DefaultRegions.h"
#include "EyeShells.h"
#include "FaceFront.h"
#include "FaceLandmarks.h"
#include "FacePosture.h"
#include "FaceTurn.h"
#include "GridFaceSides.h"
#include "MeshEdgeData.h"
#include "MeshLandmarks.h"
#include "NumberText.h"
#include "TextFileReader.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr std::size_t largestRegionText = 5'000'000;  // region maps have a few kB
constexpr std::size_t pointsBetweenReports = 65536;

vtkDataArray* pointArray(vtkPointSet* data, const char* name, int components) {
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

constexpr double warnedPose = 10.0, refusedPose = 45.0;  // degrees away from +z
const char* const stopped = "stopped before the face was read";

/// What is read of a face, landmarks of a mesh at most once.
struct Reading {
  vtkPointSet* data;
  const FaceFrameOptions& options;
  FaceFrame& frame;
  std::optional<MeshLandmarks> mesh;

  std::string readLandmarks() {
    if (mesh) return {};
    mesh.emplace();
    return mesh->read(data, options.landmarkFile);
  }

  /// Whether landmarks say more of the points than the data themselves do.
  bool wantsLandmarks() const {
    return !options.landmarkFile.empty() && !markerNames(data) &&
           !(vtkStructuredGrid::SafeDownCast(data) && data->GetCellData()->HasArray("PatchId"));
  }
};

/// Arrays that files may bring along with another number of values than there are points.
std::string describeArrays(vtkPointSet* data) {
  for (const char* name : {"marker", "Normals", "LipSide", "LidSide", "region"}) {
    vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(name);
    if (array && array->GetNumberOfTuples() != data->GetNumberOfPoints())
      return std::string("the point array ") + name + " has " + std::to_string(array->GetNumberOfTuples()) +
             " values for " + std::to_string(data->GetNumberOfPoints()) + " points; repair or remove it";
  }
  vtkStringArray* names = markerNames(data);
  return names && names->GetNumberOfComponents() != 1
             ? "the point array marker has " + std::to_string(names->GetNumberOfComponents()) +
                   " components; give one name for each point"
             : "";
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

std::string findPupils(Reading& reading, EyePupils& pupils) {
  const FaceFrameOptions& options = reading.options;
  pupils = {options.leftPupil, options.rightPupil};
  if (options.leftPupil != options.rightPupil || findByName(reading.data, options, pupils) ||
      findInField(reading.data, pupils))
    return {};
  if (options.landmarkFile.empty())
    return "there are no pupils; set both, name two points " + options.leftPupilName + " and " +
           options.rightPupilName +
           " in the point array marker, add the field array Pupils (2 x 3), or give the 68 landmarks";
  const std::string fault = reading.readLandmarks();
  if (fault.empty()) pupils = reading.mesh->pupils;
  return fault;
}

Eigen::Vector3d unturned(const HeadRotation& turned, const Eigen::Vector3d& point) {
  return turned.rotation.transpose() * (point - turned.centre) + turned.centre;
}

std::string setPupils(FaceFrame& frame) {
  return frame.pupils.set(unturned(frame.turned, frame.places.left), unturned(frame.turned, frame.places.right));
}

std::string readPoints(vtkPointSet* data, FaceFrame& frame, const Progress& progress) {
  frame.isMesh = hasPolygons(data);
  frame.points.resize(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (i % pointsBetweenReports == 0 && !goesOn(progress, double(i) / frame.points.size())) return stopped;
    Eigen::Vector3d place;
    data->GetPoint(i, place.data());
    if (!place.allFinite()) return "point " + std::to_string(i) + " has a position that is not finite; repair the mesh";
    frame.points[i].position = unturned(frame.turned, place);
  }
  return {};
}

std::string describePosture(const FaceFrame& frame) {
  return frame.isMesh && standsOnItsHead(frame.points, frame.pupils)
             ? "the nose lies above the eyes; exchange the pupils (the subject's own left one has the larger x), or "
               "turn "
               "the face upright"
             : "";
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
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    frame.points[i].side = landmarkSide(landmarkNumber(names->GetValue(i)));
  return names;
}

std::string readSides(Reading& reading, const FacialRegions& regions, const Progress& progress) {
  FaceFrame& frame = reading.frame;
  std::string fault;
  if (readSideArrays(reading.data, frame, fault) || readMarkerSides(reading.data, frame)) return fault;
  std::vector<FaceSide> sides;
  if (auto* grid = vtkStructuredGrid::SafeDownCast(reading.data)) sides = gridFaceSides(grid, regions, frame);
  if (sides.empty() && !reading.options.landmarkFile.empty()) {
    fault = reading.readLandmarks();
    if (fault.empty())
      sides = faceSides(reading.mesh->vertices, reading.mesh->edges, reading.mesh->numbers, regions,
                        frame.pupils.unit(), progress);
  }
  for (std::size_t i = 0; i < sides.size(); ++i) frame.points[i].side = sides[i];
  return fault;
}

/// Whether it is a mesh whose parts and posture are not known otherwise, as those of the PDE face are.
bool isScan(const Reading& reading) {
  return reading.frame.isMesh && !vtkStructuredGrid::SafeDownCast(reading.data) && !markerNames(reading.data);
}

/// Holds the eyes.
std::string readEyes(Reading& reading) {
  FaceFrame& frame = reading.frame;
  if (reading.mesh)
    for (std::size_t i = 0; i < frame.points.size(); ++i) frame.points[i].stays = reading.mesh->inEyes[i];
  if (!isScan(reading)) return {};
  MeshEdges edges;
  const std::string fault = reading.mesh ? "" : readEdges(reading.data, edges);
  if (!fault.empty()) return fault;
  MeshVertices places(frame.points.size(), 3);
  for (std::size_t i = 0; i < frame.points.size(); ++i)
    places.row(i) = frame.pupils.apply(frame.points[i].position).transpose();
  const std::vector<bool> inEyes = eyeShells(places, reading.mesh ? reading.mesh->edges : edges);
  for (std::size_t i = 0; i < frame.points.size(); ++i) frame.points[i].stays = frame.points[i].stays || inEyes[i];
  return {};
}

FaceLandmarks landmarksOf(const Reading& reading) {
  FaceLandmarks landmarks;
  for (int i = 0; i < FaceLandmarks::count; ++i)
    landmarks.points.row(i) =
        unturned(reading.frame.turned, reading.mesh->vertices.row(reading.mesh->numbers[i]).transpose()).transpose();
  return landmarks;
}

std::string degrees(double radians) {
  return roundedText(std::round(std::abs(radians) * 180.0 / M_PI));
}

/// Refuses what does not look forward by its landmarks, and turns what looks aside.
std::string readPose(Reading& reading) {
  if (!reading.wantsLandmarks()) return {};
  const std::string fault = reading.readLandmarks();
  if (!fault.empty()) return fault;
  FaceFrame& frame = reading.frame;
  const FaceLandmarks landmarks = landmarksOf(reading);
  if (isMirrored(landmarks))
    return "the face is mirrored by its landmarks: its nose points backwards, or left and right are exchanged; turn "
           "one axis of the mesh round, or give landmarks whose left is the subject's own";
  const Eigen::Matrix3d rotation = faceRotation(landmarks);
  if (rotation(2, 2) < -0.5)
    return "the face looks backwards by its landmarks, " + degrees(std::acos(std::max(rotation(2, 2), -1.0))) +
           " degrees away from +z; turn it to look along +z";
  const FacePose pose = facePose(landmarks);
  const std::string text = "the face looks " + degrees(pose.yaw) + " degrees to the side and " + degrees(pose.pitch) +
                           (pose.pitch > 0.0 ? " down" : " up") +
                           " by its landmarks; tables are for faces that look "
                           "along +z";
  const double largest = std::max(std::abs(pose.yaw), std::abs(pose.pitch)) * 180.0 / M_PI;
  if (!(largest <= refusedPose))
    return text + ": turn it there, or say how it is turned with the field array HeadRotation";
  if (largest <= warnedPose) return {};
  frame.warning = text + (reading.options.turnsToFront
                              ? ", so it was turned there for the table, and back"
                              : ": turn it there, or say how it is turned with the field array HeadRotation");
  if (!reading.options.turnsToFront) return {};
  // An angle that may be the face's own leaning is not taken for a turn beside one that is.
  frame.turned.rotation = frame.turned.rotation * faceRotation(landmarks, warnedPose * M_PI / 180.0);
  return setPupils(frame);
}

/// Without landmarks: refuses what cannot be a face that looks forward.
std::string judgeFront(Reading& reading) {
  FaceFrame& frame = reading.frame;
  if (!isScan(reading) || reading.wantsLandmarks()) return {};
  std::vector<Eigen::Vector3d> places;
  places.reserve(frame.points.size());
  for (const DeformationPoint& point : frame.points) places.push_back(frame.pupils.apply(point.position));
  const Eigen::Vector3d aside = frame.pupils.apply(unturned(frame.turned, frame.places.left)) -
                                frame.pupils.apply(unturned(frame.turned, frame.places.right));
  const double yaw = std::atan2(aside.z(), aside.head<2>().norm());
  if (std::abs(yaw) > warnedPose * M_PI / 180.0)
    frame.warning = "the face looks " + degrees(yaw) +
                    " degrees to the side by its pupils; tables are for faces that look along +z: turn it there, or "
                    "give its 68 landmarks";
  return describeFront(places);
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

std::string readPupils(Reading& reading) {
  FaceFrame& frame = reading.frame;
  std::string fault = describeArrays(reading.data);
  if (fault.empty()) fault = readHeadRotation(reading.data->GetFieldData(), frame.turned);
  if (fault.empty()) fault = findPupils(reading, frame.places);
  return fault.empty() ? setPupils(frame) : fault;
}

}  // namespace

vtkStringArray* markerNames(vtkPointSet* data) {
  return vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("marker"));
}

std::string readPupils(vtkPointSet* data, const FaceFrameOptions& options, FaceFrame& frame) {
  Reading reading{data, options, frame, {}};
  return readPupils(reading);
}

std::string readFaceFrame(vtkPointSet* data, const FaceFrameOptions& options, const FacialRegions& regions,
                          FaceFrame& frame, const Progress& progress) {
  Reading reading{data, options, frame, {}};
  if (!goesOn(progress, 0.0)) return stopped;
  std::string fault = readPupils(reading);
  if (fault.empty()) fault = readPose(reading);
  if (fault.empty()) fault = readPoints(data, frame, partOf(progress, 0.2, 0.5));
  if (fault.empty()) fault = judgeFront(reading);
  if (fault.empty()) fault = describePosture(frame);
  if (fault.empty()) fault = readSides(reading, regions, partOf(progress, 0.5, 0.9));
  if (fault.empty()) fault = readEyes(reading);
  if (fault.empty() && !goesOn(progress, 1.0)) fault = stopped;
  return fault.empty() ? readGivenRegions(data, frame) : fault;
}

std::string readRegions(const std::string& file, FacialRegions& regions) {
  regions = defaultRegions();
  if (file.empty()) return {};
  std::string text;
  const std::string unreadable = readTextFile(file, largestRegionText, text);
  if (!unreadable.empty()) return file + ":" + unreadable;
  int line = 0;
  const std::string fault = regions.parse(text, &line);
  return fault.empty() ? fault : file + (line ? ":" + std::to_string(line) : "") + ": " + fault;
}

}  // namespace mien
