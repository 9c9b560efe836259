#include "ScanSummary.h"

#include <numeric>

#include "MeshCleaning.h"
#include "ReferenceFace.h"
#include "ScanAcquisition.h"
#include "ScanFile.h"

namespace mien {

namespace {

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
  MeshText scan;
  const std::string fault = readScanFile(file, scan);
  if (!fault.empty()) return fault;
  const TriangleMesh& mesh = scan.mesh;
  ScanSummary result;
  result.points = mesh.vertices.rows();
  result.triangles = mesh.triangles.rows();
  result.polygons = scan.polygons;
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
