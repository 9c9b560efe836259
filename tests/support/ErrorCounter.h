#pragma once

#include <string>

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

/// Catches the errors that a filter and its executive report, so that expected ones can be checked.
class ErrorCounter {
 public:
  explicit ErrorCounter(vtkAlgorithm* algorithm) {
    command_->SetClientData(this);
    command_->SetCallback([](vtkObject*, unsigned long, void* data, void* message) {
      auto* self = static_cast<ErrorCounter*>(data);
      if (self->count_++ == 0) self->first_ = static_cast<const char*>(message);
    });
    algorithm->AddObserver(vtkCommand::ErrorEvent, command_);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command_);
  }
  int count() const { return count_; }
  /// The first message: the executive repeats the failure after the filter has said why.
  const std::string& first() const { return first_; }

 private:
  vtkNew<vtkCallbackCommand> command_;
  int count_ = 0;
  std::string first_;
};
