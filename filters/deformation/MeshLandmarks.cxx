#include "MeshLandmarks.h"

#include <algorithm>
#include <cmath>

#include "LandmarkTable.h"
#include "MeshEdgeData.h"
#include "NumberText.h"
#include "TextFileReader.h"
#include "vtkPointSet.h"

namespace mien {

namespace {

constexpr std::size_t largestFile = 1 << 20;  // bytes of a landmark file
constexpr double furthest = 0.1;              // a landmark from its vertex, distances of the outer eye corners

std::string describeMissing(const LandmarkTable& table) {
  const auto missing = std::find(table.given.begin(), table.given.end(), false);
  if (missing == table.given.end()) return {};
  const std::string name = landmarkName(static_cast<int>(missing - table.given.begin()));
  return "landmark " + std::to_string(missing - table.given.begin()) + (name.empty() ? "" : " (" + name + ")") +
         " is missing; pupils, lips and lids of a mesh need all 68";
}

/// The vertex of a landmark by its number. @return nothing, or what is wrong
std::string byNumber(const LandmarkTable& table, int landmark, Eigen::Index vertices, int& vertex) {
  if (table.vertices[landmark] >= vertices)
    return "landmark " + std::to_string(landmark) + " is vertex " + std::to_string(table.vertices[landmark]) +
           ", but the mesh has " + std::to_string(vertices) + "; give the landmarks of this mesh";
  vertex = static_cast<int>(table.vertices[landmark]);
  return {};
}

/// The vertex of a landmark by its place. @return nothing, or what is wrong
std::string byPlace(const LandmarkTable& table, int landmark, const MeshVertices& vertices, int& vertex) {
  Eigen::Index nearest = 0;
  const double squared =
      (vertices.rowwise() - table.positions.points.row(landmark)).rowwise().squaredNorm().minCoeff(&nearest);
  const double eyes = eyeDistance(table.positions);
  if (!(std::sqrt(squared) <= furthest * eyes))
    return "landmark " + std::to_string(landmark) + " lies " + roundedText(std::sqrt(squared)) +
           " from the nearest vertex, more than a tenth of the distance of the outer eye corners (" +
           roundedText(eyes) + "); give the landmarks of this mesh, in its unit";
  vertex = static_cast<int>(nearest);
  return {};
}

}  // namespace

std::string MeshLandmarks::read(vtkPointSet* data, const std::string& file) {
  std::string text;
  LandmarkTable table;
  std::string fault = readTextFile(file, largestFile, text, "CSV file with the 68 landmarks");
  if (fault.empty()) fault = parseLandmarks(text, table);
  if (!fault.empty()) return file + ":" + fault;
  vertices.resize(data->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) data->GetPoint(i, vertices.row(i).data());
  if (!vertices.allFinite()) return "the mesh has points that are not finite; repair or remove them";
  fault = describeMissing(table);
  for (int i = 0; i < FaceLandmarks::count && fault.empty(); ++i)
    fault =
        table.hasVertices ? byNumber(table, i, vertices.rows(), numbers[i]) : byPlace(table, i, vertices, numbers[i]);
  if (!fault.empty()) return file + ": " + fault;
  fault = readEdges(data, edges);
  if (fault.empty()) pupils = eyePupils(vertices, edges, numbers, &inEyes);
  return fault;
}

}  // namespace mien
