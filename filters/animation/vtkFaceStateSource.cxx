#include "vtkFaceStateSource.h"

#include <algorithm>

#include "FacePipeline.h"
#include "FaceStateText.h"
#include "vtkCommand.h"
#include "vtkFAPReader.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkFaceStateSource);

namespace {

enum Port { gridPort, surfacePort, curvePort, portCount };

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The time that is asked for at a port, if any.
bool requestedTime(vtkInformation* request, vtkInformationVector* outputs, double& time) {
  const int port = request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT());
  vtkInformation* info = outputs->GetInformationObject(port < 0 ? gridPort : port);
  if (!info->Has(Pipeline::UPDATE_TIME_STEP())) return false;
  time = info->Get(Pipeline::UPDATE_TIME_STEP());
  return true;
}

}  // namespace

struct vtkFaceStateSource::Internals {
  vtkFaceStateSource* self;
  mien::FaceState state;
  mien::FacePipeline pipeline;
  vtkNew<vtkReverseSense> outwards;
  bool failed = false;

  explicit Internals(vtkFaceStateSource* source) : self(source) {
    outwards->SetInputConnection(pipeline.surface()->GetOutputPort());
    pipeline.face()->AddObserver(vtkCommand::ProgressEvent, this, &Internals::followProgress);
  }

  /// The surface takes almost all of the time.
  void followProgress() {
    self->UpdateProgress(pipeline.face()->GetProgress());
    pipeline.face()->SetAbortExecute(self->GetAbortExecute());
  }

  /// What was aborted is done again by the next update.
  int giveUp() {
    failed = true;
    pipeline.face()->SetAbortExecute(false);
    pipeline.face()->Modified();
    return 1;
  }

  /// The state, or the state at the time that is asked for.
  mien::FaceState stateAt(bool timed, double time) const {
    mien::FaceState shown = state;
    if (!timed || shown.fapFile.empty()) return shown;
    shown.frameChoice = mien::FaceState::FrameChoice::Time;
    shown.frame = time;
    return shown;
  }

  vtkPolyData* surface() {
    outwards->Update();
    return outwards->GetOutput();
  }
};

vtkFaceStateSource::vtkFaceStateSource() : Impl(new Internals(this)) {
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(portCount);
}

vtkFaceStateSource::~vtkFaceStateSource() = default;

void vtkFaceStateSource::SetState(const std::string& text) {
  mien::FaceState state;
  const std::string fault = mien::readFaceState(text, state);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return;
  }
  if (state == this->Impl->state) return;
  this->Impl->state = state;
  this->Modified();
}

std::string vtkFaceStateSource::GetState() const {
  return mien::writeFaceState(this->Impl->state);
}

vtkMTimeType vtkFaceStateSource::GetMTime() {
  if (this->Impl->failed) this->Modified();
  this->Impl->failed = false;
  return this->Superclass::GetMTime();
}

vtkPolyData* vtkFaceStateSource::GetSurface() {
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(surfacePort));
}

vtkPolyData* vtkFaceStateSource::GetCurves() {
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(curvePort));
}

int vtkFaceStateSource::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == gridPort ? "vtkStructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkFaceStateSource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  const mien::FaceState& state = this->Impl->state;
  const int rows = std::max(1, state.rows), columns = std::max(1, state.columns);
  outputs->GetInformationObject(gridPort)->Set(Pipeline::WHOLE_EXTENT(), 0, columns, 0, rows - 1, 0, 0);
  this->Impl->pipeline.setState(state);
  this->Impl->pipeline.updateNeutralCurves();  // what is wrong is told when data are asked for
  this->PublishTimes(outputs);
  return 1;
}

void vtkFaceStateSource::PublishTimes(vtkInformationVector* outputs) {
  for (int port = 0; port < portCount; ++port) {
    vtkInformation* output = outputs->GetInformationObject(port);
    vtkInformation* frames = this->Impl->pipeline.frames()->GetOutputInformation(0);
    for (vtkInformationDoubleVectorKey* key : {Pipeline::TIME_STEPS(), Pipeline::TIME_RANGE()}) {
      output->Remove(key);
      if (!this->Impl->state.fapFile.empty()) output->CopyEntry(frames, key);
    }
  }
}

int vtkFaceStateSource::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs) {
  double time = 0.0;
  const bool timed = requestedTime(request, outputs, time);
  this->Impl->pipeline.setState(this->Impl->stateAt(timed, time));
  const std::string fault = this->Impl->pipeline.update();
  if (!fault.empty()) return this->Refuse(fault);
  if (this->GetAbortExecute()) return this->Impl->giveUp();
  vtkStructuredGrid::GetData(outputs, gridPort)->ShallowCopy(this->Impl->pipeline.grid());
  vtkPolyData::GetData(outputs, surfacePort)->ShallowCopy(this->Impl->surface());
  vtkPolyData::GetData(outputs, curvePort)->ShallowCopy(this->Impl->pipeline.shownCurves()->GetOutputDataObject(0));
  for (int port = 0; timed && port < portCount; ++port)
    vtkDataObject::GetData(outputs, port)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}

int vtkFaceStateSource::Refuse(const std::string& fault) {
  vtkErrorMacro(<< fault);
  this->Impl->failed = true;
  return 0;
}

void vtkFaceStateSource::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "State: " << this->GetState() << "\n";
}
