#include "Acquire.h"

#include "PipelineErrors.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkBoundaryCurveMeanFilter.h"
#include "vtkScanReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

namespace mien
{

namespace
{

std::string describeOptions(const AcquireOptions& options)
{
  if (options.scans.empty())
    return "there is no scan; give at least one .ply, .obj, .stl or .off file";
  if (options.scans.size() > 1 && !options.mean)
    return "there is more than one scan; ask for their mean or give only one";
  return {};
}

std::string measureScan(const std::string& scan, const AcquireOptions& options, vtkPolyData* curves)
{
  vtkNew<vtkScanReader> reader;
  vtkNew<vtkBoundaryCurveAcquisitionFilter> filter;
  PipelineErrors errors;
  errors.observe(reader);
  errors.observe(filter);
  reader->SetFileName(scan.c_str());
  reader->Update();
  if (!errors.first().empty())
    return errors.first();
  filter->SetInputData(reader->GetOutput());
  filter->SetLandmarkFileName(options.landmarkFile.c_str());
  filter->SetPointsPerCurve(options.pointsPerCurve);
  filter->Update();
  curves->ShallowCopy(filter->GetOutput());
  const std::string fault = errors.first();
  return fault.empty() || fault.rfind(options.landmarkFile + ":", 0) == 0 ? fault : scan + ": " + fault;
}

std::string writeCurves(vtkPolyData* curves, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetFileName(file.c_str());
  writer->SetInputData(curves);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  const bool written = writer->Write() == 1 && errors.first().empty() && writer->GetErrorCode() == 0;
  return written ? std::string() : file + ": the curves cannot be written there; check folder and rights";
}

} // namespace

std::string acquire(const AcquireOptions& options)
{
  std::string fault = describeOptions(options);
  vtkNew<vtkBoundaryCurveMeanFilter> mean;
  vtkNew<vtkPolyData> curves;
  for (std::size_t i = 0; i < options.scans.size() && fault.empty(); ++i)
  {
    curves->Initialize();
    fault = measureScan(options.scans[i], options, curves);
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(curves);
    mean->AddInputDataObject(copy);
  }
  if (!fault.empty())
    return fault;
  PipelineErrors errors;
  errors.observe(mean);
  if (options.mean)
  {
    mean->Update();
    curves->ShallowCopy(mean->GetOutput());
  }
  return errors.first().empty() ? writeCurves(curves, options.outputFile) : errors.first();
}

} // namespace mien
