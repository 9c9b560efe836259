#include "FilterProgress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace mien {

namespace {

void tell(vtkObject* caller, unsigned long, void* progress, void*) {
  auto* algorithm = static_cast<vtkAlgorithm*>(caller);
  if (!goesOn(*static_cast<const Progress*>(progress), algorithm->GetProgress())) algorithm->SetAbortExecute(1);
}

}  // namespace

bool updateWith(const Progress& progress, vtkAlgorithm* algorithm) {
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(tell);
  callback->SetClientData(const_cast<Progress*>(&progress));
  const unsigned long observer = algorithm->AddObserver(vtkCommand::ProgressEvent, callback);
  algorithm->Update();
  algorithm->RemoveObserver(observer);
  return algorithm->GetAbortExecute() == 0;
}

}  // namespace mien
