#include "ScanSummary.h"

#include <fstream>
#include <iterator>
#include <numeric>
#include <vtksys/SystemTools.hxx>

#include "MeshCleaning.h"
#include "ReferenceFace.h"
#include "ScanAcquisition.h"
#include "ScanFile.h"

namespace mien {

namespace {

PolygonCounts polygonsOf(const std::string& file, long long triangles) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  PolygonCounts counts =
      countPolygons(text, vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file)));
  if (counts.sum() == 0) counts.triangles = triangles;  // of .stl there are no others
  return counts;
}

void measureParts(const TriangleMesh& mesh, ScanSummary& summary) {
  const MeshParts parts = partsOf(mesh);
  std::vector<bool> largest(static_cast<std::size_t>(parts.count()), false);
  largest[0] = true;
  summary.components = parts.count();
  summary.largestShare = parts.area[0] / std::accumulate(parts.area.begin(), parts.area.end(), 0.0);
  summary.boundaryLoops = boundaryLoops(mesh);
  summary.loopsOfLargest = boundaryLoops(withParts(mesh, parts, largest));
}

void guessUnit(const CleanMesh& scan, ScanSummary& summary, const Progress& progress) {
  std::vector<LengthUnit> fitting;
  summary.unitFault = recogniseScanUnit(scan, referenceTemplate(), fitting, progress);
  for (const LengthUnit& unit : fitting) summary.possibleUnits.push_back(unit.name);
  if (!summary.unitFault.empty()) return;
  summary.unit = fitting.front().name;
  summary.millimetres = fitting.front().millimetres;
}

}  // namespace

std::string summarizeScan(const std::string& file, ScanSummary& summary, const Progress& progress) {
  TriangleMesh mesh;
  const std::string fault = readScanFile(file, mesh);
  if (!fault.empty()) return file + ": " + fault;
  ScanSummary result;
  result.points = mesh.vertices.rows();
  result.triangles = mesh.triangles.rows();
  result.polygons = polygonsOf(file, result.triangles);
  const CleanMesh clean = cleaned(mesh);
  result.mergedVertices = clean.mergedVertices;
  result.degenerateTriangles = clean.degenerateTriangles;
  if (clean.mesh.triangles.rows() == 0) return file + ": all its triangles are without area; export the scan again";
  for (int i = 0; i < 3; ++i) {
    result.low[i] = mesh.vertices.col(i).minCoeff();
    result.high[i] = mesh.vertices.col(i).maxCoeff();
  }
  measureParts(clean.mesh, result);
  guessUnit(clean, result, progress);
  summary = result;
  return {};
}

}  // namespace mien
