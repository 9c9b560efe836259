#include "FittedTable.h"

#include <iostream>

#include "FDTData.h"
#include "Failure.h"
#include "PipelineErrors.h"
#include "SampleOutliers.h"
#include "TableFit.h"
#include "TableRows.h"
#include "vtkFDTFitFilter.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace mien {

using json = nlohmann::ordered_json;

namespace {

json coefficients(const QuadraticMap& map, int row) {
  json values = json::array();
  for (int i = 0; i < 6; ++i) values.push_back(map.coefficients(row, i));
  return values;
}

json valueOf(const DeformationTable& table, int region, double value) {
  return table.knows(region) ? json(value) : json(nullptr);
}

}  // namespace

json FittedTable::description(const FacialRegions& map) const {
  json about = {{"rms", rms}, {"unit", "half the distance between the pupils"}};
  about["regions"] = json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Region& fit = regions[region - 1];
    about["regions"].push_back({{"region", region},
                                {"name", map.name(region)},
                                {"points", fit.points},
                                {"a", coefficients(table.maps[region - 1], 0)},
                                {"b", coefficients(table.maps[region - 1], 1)},
                                {"rms", fit.rms}});
  }
  if (!warning.empty()) about["warning"] = warning;
  if (!suspects.empty()) about["suspects"] = suspects;
  if (!missing.empty()) about["missing"] = missing;
  return about;
}

json FittedTable::rows(const FacialRegions& map) const {
  json rows = json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Region& fit = regions[region - 1];
    const Eigen::Vector2d& centre = map.centre(region);
    const Eigen::Vector2d move = table.maps[region - 1].apply(centre) - centre;
    rows.push_back({{"region", std::to_string(region) + " " + map.name(region)},
                    {"points", fit.points},
                    {"rms", valueOf(table, region, fit.rms)},
                    {"centre_dx", valueOf(table, region, move.x())},
                    {"centre_dy", valueOf(table, region, move.y())}});
  }
  return rows;
}

FittedTable fitMarkers(const MarkerTable& markers, const FacialRegions& regions, bool strict, const std::string& file) {
  TableFit fit;
  const TableSamples samples = samplesOf(markers, regions);
  const std::string fault = fit.fit(samples, {strict, true});
  if (!fault.empty()) throw FileFailure(file + ": " + fault);
  FittedTable fitted;
  fitted.table = fit.table;
  fitted.rms = fit.rms;
  fitted.warning = fit.warning();
  fitted.missing = markers.missing;
  for (const SampleOutlier& outlier : sampleOutliers(samples)) {
    const Marker& marker = markers.markers[outlier.sample];
    fitted.suspects.push_back(marker.name);
    std::cerr << "mien: " << file << ":" << marker.line << ": marker " << marker.name << " moves "
              << readableNumber(outlier.difference)
              << " pupil units otherwise than those around it; it is fitted all the same: correct it, or blank its "
                 "cells\n";
  }
  for (int i = 0; i < FacialRegions::count; ++i) fitted.regions[i] = {fit.regions[i].points, fit.regions[i].rms};
  return fitted;
}

FittedTable fitSurfaces(vtkPointSet* neutral, vtkPointSet* expression, const MarkerFileOptions& options,
                        const std::string& landmarkFile, bool strict, const std::string& names) {
  options.requirePupilsInSpace();
  vtkNew<vtkFDTFitFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputDataObject(0, neutral);
  filter->SetExpressionData(expression);
  filter->SetRegionFileName(options.regionFile());
  filter->SetLandmarkFileName(landmarkFile);
  filter->SetStrict(strict);
  filter->SetAllowEmptyRegions(true);
  const MarkerOptions markers = options.markers();
  filter->SetLeftPupilName(markers.leftPupil);
  filter->SetRightPupilName(markers.rightPupil);
  options.tellStillHead(names);
  if (markers.neutralPupils) {
    filter->SetLeftPupil(markers.neutralPupils->left.data());
    filter->SetRightPupil(markers.neutralPupils->right.data());
    filter->SetOtherLeftPupil(markers.expressionPupils->left.data());
    filter->SetOtherRightPupil(markers.expressionPupils->right.data());
  }
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(names + ": " + surfaceFault(errors.first()));
  FittedTable fitted;
  const std::string fault = readFDT(filter->GetOutput(), fitted.table);
  if (!fault.empty()) throw FileFailure(names + ": " + fault);
  fitted.rms = filter->GetRMS();
  fitted.warning = filter->GetWarning();
  for (const std::string& warning : errors.warnings())
    if (warning != fitted.warning) std::cerr << "mien: " << names << ": " << warning << "\n";
  for (int i = 0; i < FacialRegions::count; ++i)
    fitted.regions[i] = {filter->GetOutput()->GetValueByName(i, "points").ToInt(),
                         filter->GetOutput()->GetValueByName(i, "rms").ToDouble()};
  return fitted;
}

}  // namespace mien
