#include "PipelineErrors.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"

namespace mien {

namespace {

/// VTK's text is "ERROR: In FILE, line N\nCLASS (ADDRESS): MESSAGE\n\n".
std::string messageOf(const std::string& text) {
  const size_t line = text.find('\n');
  const size_t source = line == std::string::npos ? line : text.find("): ", line);
  const size_t begin = source == std::string::npos ? 0 : source + 3;
  const size_t end = text.find_last_not_of(" \n\r\t");
  return end == std::string::npos || end < begin ? std::string() : text.substr(begin, end + 1 - begin);
}

}  // namespace

class PipelineErrors::Keeper : public vtkCommand {
 public:
  static Keeper* New() { return new Keeper; }

  void Execute(vtkObject*, unsigned long event, void* data) override {
    const std::string message = data ? messageOf(static_cast<const char*>(data)) : "something failed without a message";
    (event == vtkCommand::ErrorEvent ? errors : warnings).push_back(message);
  }

  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

PipelineErrors::PipelineErrors() : Kept(Keeper::New()) {}

PipelineErrors::~PipelineErrors() {
  this->Kept->UnRegister();
}

void PipelineErrors::observe(vtkAlgorithm* algorithm) {
  for (vtkObject* source : {static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive())})
    for (const unsigned long event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent})
      source->AddObserver(event, this->Kept);
}

vtkCommand* PipelineErrors::observer() const {
  return this->Kept;
}

std::string PipelineErrors::first() const {
  return this->Kept->errors.empty() ? std::string() : this->Kept->errors.front();
}

std::vector<std::string> PipelineErrors::warnings() const {
  return this->Kept->warnings;
}

void PipelineErrors::clear() {
  this->Kept->errors.clear();
  this->Kept->warnings.clear();
}

}  // namespace mien
