#include "WatchedUpdate.h"

#include <string>

#include "Failure.h"
#include "Interruption.h"
#include "ProgressLine.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace mien {

namespace {

constexpr int progressSteps = 1000;

void watch(vtkObject* caller, unsigned long, void* line, void*) {
  auto* algorithm = static_cast<vtkAlgorithm*>(caller);
  static_cast<ProgressLine*>(line)->show(static_cast<int>(progressSteps * algorithm->GetProgress()));
  if (wasInterrupted()) algorithm->SetAbortExecute(1);
}

}  // namespace

void updateWatched(vtkAlgorithm* filter, const char* what) {
  noteInterruptions();
  ProgressLine line(progressSteps, "part");
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(watch);
  callback->SetClientData(&line);
  const unsigned long observer = filter->AddObserver(vtkCommand::ProgressEvent, callback);
  filter->Update();
  filter->RemoveObserver(observer);
  if (wasInterrupted()) throw Stopped("stopped before the " + std::string(what) + " was complete; nothing was written");
}

}  // namespace mien
