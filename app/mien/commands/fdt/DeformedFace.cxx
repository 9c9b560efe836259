#include "DeformedFace.h"

#include <iostream>

#include "FDTData.h"
#include "Failure.h"
#include "PipelineErrors.h"
#include "PupilMarkers.h"
#include "vtkCellData.h"
#include "vtkFDTCurveFilter.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace mien {

namespace {

vtkSmartPointer<vtkPointSet> deform(vtkPointSet* data, const DeformationTable& table, const DeformationOptions& options,
                                    const EyePupils* pupils, const std::string& file) {
  vtkNew<vtkFDTDeformationFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  vtkNew<vtkTable> rows;
  writeFDT(table, rows);
  filter->SetInputDataObject(0, data);
  filter->SetTableData(rows);
  filter->SetStrength(options.strength);
  filter->SetSmooth(!options.hard);
  filter->SetRegionFileName(options.reading.regionFile());
  filter->SetLandmarkFileName(options.landmarks);
  filter->SetLeftPupilName(options.reading.markers().leftPupil);
  filter->SetRightPupilName(options.reading.markers().rightPupil);
  if (pupils) {
    filter->SetLeftPupil(pupils->left.data());
    filter->SetRightPupil(pupils->right.data());
  }
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(file + ": " + surfaceFault(errors.first()));
  for (const std::string& warning : errors.warnings()) std::cerr << "mien: " << file << ": " << warning << "\n";
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Mien's own curves, whose lips and lids are known and must not cross.
vtkSmartPointer<vtkPointSet> deformCurves(vtkPointSet* curves, const DeformationTable& table,
                                          const DeformationOptions& options, const std::string& file) {
  vtkNew<vtkFDTCurveFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  vtkNew<vtkTable> rows;
  writeFDT(table, rows);
  filter->SetInputDataObject(0, curves);
  filter->SetInputDataObject(1, rows);
  filter->SetStrength(options.strength);
  filter->SetSmooth(!options.hard);
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(file + ": " + errors.first());
  for (const std::string& warning : errors.warnings()) std::cerr << "mien: " << file << ": " << warning << "\n";
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// The markers that were seen, as the filter takes them.
vtkSmartPointer<vtkPolyData> pointsOf(const PointTable& markers) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkStringArray> names;
  names->SetName("marker");
  vtkNew<vtkIntArray> regions;
  regions->SetName("region");
  for (const NamedPoint& marker : markers.points) {
    if (!marker.seen) continue;
    points->InsertNextPoint(marker.position.data());
    names->InsertNextValue(marker.name);
    regions->InsertNextValue(marker.region);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->AddArray(regions);
  return data;
}

void requireUpright(const PointTable& markers, const EyePupils& pupils, const std::string& file) {
  PupilNormalisation normalisation;
  std::string fault = normalisation.set(pupils.left, pupils.right);
  MarkerPlaces places;
  for (const NamedPoint& marker : markers.points)
    if (fault.empty() && marker.seen) places.emplace_back(marker.name, normalisation.apply(marker.position).head<2>());
  if (fault.empty()) fault = describePosture(places, false);
  if (!fault.empty()) throw FileFailure(file + ": " + fault);
}

}  // namespace

void deformMarkers(PointTable& markers, const DeformationTable& table, const DeformationOptions& options,
                   const std::string& file) {
  const MarkerOptions names = options.reading.markers();
  EyePupils pupils;
  const std::string fault = markers.findPupils(names, pupils);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  requireUpright(markers, pupils, file);
  const auto moved = deform(pointsOf(markers), table, options, &pupils, file);
  PupilNormalisation normalisation;
  normalisation.set(pupils.left, pupils.right);
  vtkIdType next = 0;
  for (NamedPoint& marker : markers.points) {
    if (!marker.seen) continue;
    const vtkIdType id = next++;
    const bool pupil = names.neutralPupils ? liesOnPupil(normalisation, marker.position)
                                           : marker.name == names.leftPupil || marker.name == names.rightPupil;
    if (!pupil) moved->GetPoint(id, marker.position.data());
  }
}

vtkSmartPointer<vtkPointSet> deformSurface(vtkPointSet* surface, const DeformationTable& table,
                                           const DeformationOptions& options, const std::string& file) {
  options.reading.requirePupilsInSpace();
  const MarkerOptions names = options.reading.markers();
  if (surface->GetCellData()->HasArray("CurveId")) return deformCurves(surface, table, options, file);
  const auto moved = deform(surface, table, options, names.neutralPupils ? &*names.neutralPupils : nullptr, file);
  const bool told = !options.landmarks.empty() || surface->GetPointData()->HasArray("LipSide") ||
                    surface->GetPointData()->HasArray("marker") || vtkStructuredGrid::SafeDownCast(surface);
  const bool face = surface->GetCellData()->HasArray("PatchId");  // of a PDE face without its rows
  if (!told)
    std::cerr << "mien: " << file
              << ": nothing tells its upper lips and lids from the lower ones, so the mouth will not open; "
              << (face ? "a face written as .vts tells them, or " : "") << "give the 68 landmarks with --landmarks\n";
  return moved;
}

}  // namespace mien
