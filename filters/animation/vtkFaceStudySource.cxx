#include "vtkFaceStudySource.h"

#include <algorithm>
#include <exception>
#include <thread>

#include "StudyColumns.h"
#include "StudyFailure.h"
#include "StudyTableRun.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFaceStudySource);

namespace {

int threadsFor(int wanted, int pieces) {
  if (wanted > 0) return wanted;
  return pieces > 1 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string textOf(const char* name) {
  return name ? name : "";
}

}  // namespace

vtkFaceStudySource::vtkFaceStudySource() {
  this->SetNumberOfInputPorts(0);
}

vtkFaceStudySource::~vtkFaceStudySource() {
  this->SetStudyFileName(nullptr);
  this->SetTableFileName(nullptr);
}

int vtkFaceStudySource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkFaceStudySource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputs->GetInformationObject(0);
  const int pieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const int piece = info->Has(Pipeline::UPDATE_PIECE_NUMBER()) ? info->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0;
  if (textOf(this->StudyFileName).empty()) {
    vtkErrorMacro("no study is given; set StudyFileName to a file STUDY.json");
    return 0;
  }
  try {
    return this->Compute(piece, pieces, vtkTable::GetData(outputs));
  } catch (const std::exception& failure) {
    vtkErrorMacro(<< failure.what());
    return 0;
  }
}

int vtkFaceStudySource::Compute(int piece, int pieces, vtkTable* output) {
  const std::string table = textOf(this->TableFileName);
  const mien::StudyRun::Share share = {piece, pieces, threadsFor(this->NumberOfThreads, pieces)};
  const auto progress = [this](double done) {
    this->UpdateProgress(done);
    return !this->GetAbortExecute();
  };
  mien::StudyTableRun run(this->StudyFileName, [this] { return !this->GetAbortExecute(); });
  this->NumberOfComputedCases = 0;
  if (this->GetAbortExecute()) return 1;
  mien::StudyTableRun::Rows rows;
  if (table.empty()) {
    rows = run.computedRows(share, progress);
    this->NumberOfComputedCases = static_cast<vtkIdType>(rows.size());
  } else {
    run.readDone(this->TableFileName);
    if (run.leftOf(share) > 0) this->NumberOfComputedCases = run.compute(table, share, progress).computed;
    rows = run.doneRowsOf(share);
  }
  mien::writeStudyColumns(run.study(), rows, output);
  return 1;
}

bool vtkFaceStudySource::WriteTable() {
  vtkMultiProcessController* const processes = vtkMultiProcessController::GetGlobalController();
  if (processes && processes->GetLocalProcessId() > 0) return true;
  const std::string table = textOf(this->TableFileName);
  try {
    if (table.empty()) throw mien::StudyFailure("no table is given; set TableFileName to a file TABLE.csv");
    mien::StudyTableRun run(textOf(this->StudyFileName));
    run.readDone(table);
    if (!run.isComplete())
      throw mien::StudyFailure(table + ": " + std::to_string(run.missing()) + " of " + std::to_string(run.caseCount()) +
                               " cases are in no part beside it; update all pieces first");
    run.writeTable(table);
    return true;
  } catch (const std::exception& failure) {
    vtkErrorMacro(<< failure.what());
    return false;
  }
}

void vtkFaceStudySource::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StudyFileName: " << (this->StudyFileName ? this->StudyFileName : "(none)") << "\n";
  os << indent << "TableFileName: " << (this->TableFileName ? this->TableFileName : "(none)") << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NumberOfComputedCases: " << this->NumberOfComputedCases << "\n";
}
