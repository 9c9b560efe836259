#include "Acquire.h"

#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkBoundaryCurveMeanFilter.h"
#include "vtkScanReader.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

namespace mien
{

namespace
{

/// Keeps the first error of a pipeline instead of printing it.
class ErrorKeeper
{
public:
  ErrorKeeper()
  {
    this->Observer->SetClientData(&this->Message);
    this->Observer->SetCallback([](vtkObject*, unsigned long, void* kept, void* text) {
      auto& message = *static_cast<std::string*>(kept);
      if (message.empty())
        message = text ? static_cast<const char*>(text) : "an error without a word";
    });
  }
  void Watch(vtkObject* object) { object->AddObserver(vtkCommand::ErrorEvent, this->Observer); }

  /// VTK puts the class and its address before the sentence, and blank lines behind.
  std::string Sentence() const
  {
    const std::size_t colon = this->Message.find("): ");
    const std::string text = colon == std::string::npos ? this->Message : this->Message.substr(colon + 3);
    return text.substr(0, text.find_last_not_of("\n") + 1);
  }

private:
  vtkNew<vtkCallbackCommand> Observer;
  std::string Message;
};

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
  ErrorKeeper reading, measuring;
  reading.Watch(reader);
  measuring.Watch(filter);
  reader->SetFileName(scan.c_str());
  reader->Update();
  if (!reading.Sentence().empty())
    return reading.Sentence();
  filter->SetInputData(reader->GetOutput());
  filter->SetLandmarkFileName(options.landmarkFile.c_str());
  filter->SetPointsPerCurve(options.pointsPerCurve);
  filter->Update();
  curves->ShallowCopy(filter->GetOutput());
  const std::string fault = measuring.Sentence();
  return fault.empty() || fault.rfind(options.landmarkFile + ":", 0) == 0 ? fault : scan + ": " + fault;
}

std::string writeCurves(vtkPolyData* curves, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  ErrorKeeper writing;
  writing.Watch(writer);
  writer->SetFileName(file.c_str());
  writer->SetInputData(curves);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  return writer->Write() == 1 ? std::string() : file + ": the curves cannot be written there; check folder and rights";
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
  ErrorKeeper averaging;
  averaging.Watch(mean);
  if (options.mean)
  {
    mean->Update();
    curves->ShallowCopy(mean->GetOutput());
  }
  return averaging.Sentence().empty() ? writeCurves(curves, options.outputFile) : averaging.Sentence();
}

} // namespace mien
