#include "vtkFAPReader.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <system_error>

#include "AnimationData.h"
#include "AnimationText.h"
#include "AnimationTextFile.h"
#include "FAPTableData.h"
#include "SurfaceMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFAPReader);

namespace {

/// Returns nothing, or `FILE:LINE: what is wrong` (`FILE: what` for a file that cannot be read at all).
std::string readSequence(const std::string& name, mien::FAPSequence& sequence, std::string& format) {
  if (name.empty()) return "there is no file name; set one with SetFileName";
  std::string text;
  const std::string shown = mien::shownAnimationName(name);
  const std::string fault = mien::readAnimationText(name, text);
  if (!fault.empty()) return shown + ": " + fault;
  const mien::FacialActionMap& map = mien::defaultFacialActions();
  const auto recognised = mien::recogniseAnimation(text, map);
  const auto error = mien::parseAnimation(text, recognised, map, sequence);
  if (!error) format = mien::nameOf(*recognised);
  return error ? shown + ":" + std::to_string(error->line) + ": " + error->message : "";
}

std::atomic<int> loads{0};

}  // namespace

vtkFAPReader::vtkFAPReader() : Sequence(std::make_unique<mien::FAPSequence>()) {
  this->SetNumberOfInputPorts(0);
}

vtkFAPReader::~vtkFAPReader() {
  this->SetFileName(nullptr);
}

int vtkFAPReader::CanReadFile(const char* fileName) {
  std::error_code ignored;
  if (fileName && std::filesystem::path(fileName).extension() == ".fap")
    return std::filesystem::is_regular_file(fileName, ignored) ? 1 : 0;
  mien::FAPSequence sequence;
  std::string format;
  return fileName && readSequence(fileName, sequence, format).empty() ? 1 : 0;
}

std::string vtkFAPReader::Load() {
  FileState state;
  state.Name = this->FileName ? this->FileName : "";
  if (!this->MayHaveChanged && !this->Sequence->frames.empty() && state.Name == this->Loaded.Name) return {};
  if (state.Name == "-" && this->Streams)
    return this->Sequence->frames.empty() ? "standard input: no frame has come yet; wait for the first" : "";
  std::error_code ignored;
  if (state.Name != "-")
    state.Modified = std::filesystem::last_write_time(state.Name, ignored).time_since_epoch().count();
  if (state.Name != "-") state.Size = std::filesystem::file_size(state.Name, ignored);
  if (!this->Sequence->frames.empty() && state == this->Loaded) {
    this->MayHaveChanged = false;
    return {};
  }
  const std::string fault = readSequence(state.Name, *this->Sequence, this->Format);
  if (!fault.empty()) return fault;
  this->Loaded = state;
  this->MayHaveChanged = false;
  this->Streams = false;
  this->LoadNumber = ++loads;
  this->Times.resize(this->Sequence->frames.size());
  for (std::size_t index = 0; index < this->Times.size(); ++index)
    this->Times[index] = this->Sequence->timeOfFrame(index);
  return {};
}

void vtkFAPReader::StartStream(double framesPerSecond, const std::string& name) {
  *this->Sequence = mien::FAPSequence();
  this->Sequence->framesPerSecond = framesPerSecond;
  this->Sequence->name = name;
  this->Format = mien::nameOf(mien::AnimationFormat::FAP);
  this->Loaded = FileState();
  this->Loaded.Name = "-";
  this->Streams = true;
  this->LoadNumber = ++loads;
  this->Modified();
}

void vtkFAPReader::AppendFrame(const mien::FAPFrame& frame) {
  this->Sequence->frames.push_back(frame);
  this->Superclass::Modified();
}

void vtkFAPReader::ClearFrames() {
  if (!this->Streams) return;
  this->Sequence->frames.clear();
  this->Superclass::Modified();
}

void vtkFAPReader::Modified() {
  this->MayHaveChanged = true;
  this->Superclass::Modified();
}

void vtkFAPReader::SetFrameIndex(int index) {
  if (index == this->FrameIndex) return;
  this->FrameIndex = index;
  this->Superclass::Modified();  // of the file nothing is new
}

void vtkFAPReader::SetInterpolate(bool on) {
  if (on == this->Interpolate) return;
  this->Interpolate = on;
  this->Superclass::Modified();
}

int vtkFAPReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  const std::string fault = this->Load();
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  // All filters behind copy what is published; a frame chosen by its index follows no time.
  using SDDP = vtkStreamingDemandDrivenPipeline;
  const double range[2] = {0.0, this->Sequence->duration()};
  vtkInformation* information = outputs->GetInformationObject(0);
  information->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  information->Remove(SDDP::TIME_STEPS());
  information->Remove(SDDP::TIME_RANGE());
  if (this->FrameIndex >= 0) return 1;
  information->Set(SDDP::TIME_RANGE(), range, 2);
  if (!this->Streams) information->Set(SDDP::TIME_STEPS(), this->Times.data(), static_cast<int>(this->Times.size()));
  return 1;
}

int vtkFAPReader::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  // Data may be asked for although the information was refused: a second update does not ask for it again.
  const std::string fault = this->Load();
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  const mien::FAPSequence& sequence = *this->Sequence;
  if (this->FrameIndex < -1 || this->FrameIndex >= this->GetNumberOfFrames()) {
    vtkErrorMacro(<< this->Loaded.Name << ": there is no frame with index " << this->FrameIndex << "; give 0 to "
                  << this->GetNumberOfFrames() - 1 << ", or -1 for the frame of the time");
    return 0;
  }
  vtkInformation* information = outputs->GetInformationObject(0);
  const auto timeKey = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  double time = 0.0;
  if (this->FrameIndex >= 0)
    time = sequence.timeOfFrame(static_cast<std::size_t>(this->FrameIndex));
  else if (information->Has(timeKey))
    time = information->Get(timeKey);
  vtkTable* table = vtkTable::GetData(outputs);
  mien::writeFAPFrame(sequence.frameAtTime(time, this->Interpolate), table);
  const double shown =
      this->Interpolate ? std::clamp(time, 0.0, sequence.duration()) : sequence.timeOfFrame(sequence.indexAtTime(time));
  table->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), shown);
  mien::writeLoadNumber(this->LoadNumber, table);
  return 1;
}

int vtkFAPReader::GetNumberOfFrames() const {
  return static_cast<int>(this->Sequence->frames.size());
}

double vtkFAPReader::GetFramesPerSecond() const {
  return this->Sequence->framesPerSecond;
}

std::string vtkFAPReader::GetFormat() const {
  return this->Format;
}

std::string vtkFAPReader::GetName() const {
  return this->Sequence->name;
}

std::string vtkFAPReader::GetVersion() const {
  return this->Sequence->version;
}

std::vector<std::string> vtkFAPReader::GetWarnings() const {
  std::vector<std::string> warnings;
  for (const mien::FAPWarning& warning : this->Sequence->warnings)
    warnings.push_back(mien::shownAnimationName(this->Loaded.Name) + ":" + std::to_string(warning.line) + ": " +
                       warning.message);
  return warnings;
}

std::vector<int> vtkFAPReader::GetFAPsUsed() const {
  return this->Sequence->fapsUsed();
}

int vtkFAPReader::GetIndexOfFrameNumber(double number) const {
  const std::optional<std::size_t> index = this->Sequence->indexOfNumber(number);
  return index ? static_cast<int>(*index) : -1;
}

const mien::FAPSequence& vtkFAPReader::GetSequence() const {
  return *this->Sequence;
}

void vtkFAPReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FrameIndex: " << this->FrameIndex << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "on" : "off") << "\n";
  os << indent << "Loaded: " << this->Loaded.Name << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "Name: " << this->GetName() << "\n";
  os << indent << "Version: " << this->GetVersion() << "\n";
  os << indent << "NumberOfFrames: " << this->GetNumberOfFrames() << "\n";
  os << indent << "FramesPerSecond: " << this->GetFramesPerSecond() << "\n";
}
