#include "Acquire.h"

#include <memory>
#include <utility>

#include "CurveCrossings.h"
#include "FilterProgress.h"
#include "PipelineErrors.h"
#include "WholeFile.h"
#include "XMLPolyDataFile.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkBoundaryCurveMeanFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceDistanceFilter.h"
#include "vtkTable.h"

namespace mien {

namespace {

std::string describeOptions(const AcquireOptions& options) {
  if (options.scans.empty()) return "there is no scan; give at least one .ply, .obj, .stl or .off file";
  if (options.scans.size() > 1 && !options.mean)
    return "there is more than one scan; ask for their mean or give only one";
  return {};
}

std::string measureDistance(vtkPolyData* curves, vtkPolyData* scan, AcquireResult& result) {
  vtkNew<vtkPDEFaceFilter> face;
  vtkNew<vtkSurfaceDistanceFilter> distance;
  PipelineErrors errors;
  errors.observe(face);
  errors.observe(distance);
  face->SetInputData(curves);
  face->SetResolution(224, 160);
  distance->SetInputConnection(face->GetOutputPort());
  distance->SetReferenceData(scan);
  distance->SetFrontalOnly(true);
  distance->Update();
  if (!errors.first().empty()) return errors.first();
  auto* table = vtkTable::SafeDownCast(distance->GetOutputDataObject(2));
  result.frontalRMS = table->GetValueByName(0, "rms_mm").ToDouble();
  result.frontalMaximum = table->GetValueByName(0, "max_mm").ToDouble();
  return {};
}

std::string measure(const AcquireOptions& options, vtkBoundaryCurveAcquisitionFilter* filter, AcquireResult& result,
                    const Progress& progress) {
  vtkNew<vtkScanReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  errors.observe(filter);
  reader->SetFileName(result.scan.c_str());
  reader->Update();
  if (!errors.first().empty()) return errors.first();
  filter->SetInputData(reader->GetOutput());
  filter->SetLandmarkFileName(options.landmarkFile.c_str());
  filter->SetPointsPerCurve(options.scan.pointsPerCurve);
  filter->SetScale(options.scan.millimetres);
  filter->SetPose(static_cast<int>(options.scan.pose));
  filter->SetAllParts(options.scan.allParts);
  filter->SetNostrils(options.scan.nostrils);
  filter->SetTriangles(options.triangles);
  filter->SetCompareLandmarks(options.report);
  if (!updateWith(progress, filter)) return "stopped before the curves were measured";
  std::string fault = errors.first();
  if (fault.empty() && options.report) fault = measureDistance(filter->GetOutput(), filter->GetOutput(1), result);
  result.report = filter->GetAcquired().report;
  result.crossings = countCrossings(filter->GetAcquired().face.curves);
  result.crossingCurves = namedCrossings(filter->GetAcquired().face.curves);
  const bool namesLandmarks = !options.landmarkFile.empty() && fault.rfind(options.landmarkFile + ":", 0) == 0;
  return fault.empty() || namesLandmarks ? fault : result.scan + ": " + fault;
}

/// Files that appear together: all of them are filled before the first is given its name.
class Files {
 public:
  template <class Fill>
  void add(const std::string& name, Fill fill) {
    if (name.empty() || !fault_.empty()) return;
    files_.emplace_back(name, std::make_unique<WholeFile>(name));
    if (!fill(*files_.back().second)) fault_ = name + ": " + WholeFile::unwritable;
  }

  std::string commit() {
    for (auto& [name, file] : files_)
      if (fault_.empty() && !file->commit()) fault_ = name + ": " + WholeFile::unwritable;
    return fault_;
  }

 private:
  std::vector<std::pair<std::string, std::unique_ptr<WholeFile>>> files_;
  std::string fault_;
};

/// The curves of all scans and, with them, what else is to be written.
class Measurements {
 public:
  explicit Measurements(const AcquireOptions& options) : Options(options) {}

  std::string add(AcquireResult& result, const Progress& progress) {
    MeasuredScan measured;
    const std::string fault = measureScan(this->Options, result.scan, measured, progress);
    result = measured.result;
    if (!fault.empty()) return fault;
    if (!this->Options.mean)  // as landmarks of the scan are given, so that they can be given back
      measured.landmarks.points = result.report.scanToFace.inverse().applied(measured.landmarks.points);
    this->Landmarks.points += measured.landmarks.points / static_cast<double>(this->Options.scans.size());
    this->Curves = measured.curves;
    this->Scan = measured.scan;
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(this->Curves);
    this->Mean->AddInputDataObject(copy);
    return {};
  }

  std::string write() {
    PipelineErrors errors;
    errors.observe(this->Mean);
    if (this->Options.mean) {
      this->Mean->Update();
      if (!errors.first().empty()) return errors.first();
      this->Curves = this->Mean->GetOutput();
      this->Landmarks = symmetrised(this->Landmarks);
    }
    Files files;
    files.add(this->Options.landmarkOutput,
              [this](const WholeFile& file) { return file.fill(landmarkText(this->Landmarks)); });
    files.add(this->Options.scanOutput,
              [this](const WholeFile& file) { return fillPolyData(this->Scan, file.temporaryName()); });
    files.add(this->Options.outputFile,
              [this](const WholeFile& file) { return fillPolyData(this->Curves, file.temporaryName()); });
    return files.commit();
  }

 private:
  const AcquireOptions& Options;
  vtkNew<vtkBoundaryCurveMeanFilter> Mean;
  vtkSmartPointer<vtkPolyData> Curves, Scan;
  FaceLandmarks Landmarks;
};

}  // namespace

std::string measureScan(const AcquireOptions& options, const std::string& file, MeasuredScan& measured,
                        const Progress& progress) {
  vtkNew<vtkBoundaryCurveAcquisitionFilter> filter;
  measured.result.scan = file;
  const std::string fault = measure(options, filter, measured.result, progress);
  if (!fault.empty()) return fault;
  measured.landmarks = filter->GetAcquired().landmarks;
  measured.curves = filter->GetOutput();
  measured.scan = filter->GetOutput(1);
  return {};
}

std::string acquire(const AcquireOptions& options, std::vector<AcquireResult>* results, const Progress& progress) {
  std::string fault = describeOptions(options);
  Measurements measurements(options);
  const double count = static_cast<double>(options.scans.size());
  for (std::size_t i = 0; i < options.scans.size() && fault.empty(); ++i) {
    AcquireResult result;
    result.scan = options.scans[i];
    fault =
        measurements.add(result, partOf(progress, static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    if (results) results->push_back(result);
  }
  return fault.empty() ? measurements.write() : fault;
}

}  // namespace mien
