#include "vtkFAPAnimationFilter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "AnimationData.h"
#include "AnimationRemarks.h"
#include "BoundaryCurveData.h"
#include "FAPTableData.h"
#include "FaceAnimator.h"
#include "HighLevelFAPs.h"
#include "SurfaceMesh.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFAPAnimationFilter);

namespace {

/// Copies a time when there is one.
void passTime(vtkInformation* from, vtkInformation* to, vtkInformationDoubleKey* key) {
  if (from->Has(key)) to->Set(key, from->Get(key));
}

/// When a file was modified and how large it is.
std::pair<long long, unsigned long long> stateOf(const std::string& file) {
  std::error_code none;
  if (file.empty()) return {};
  return {std::filesystem::last_write_time(file, none).time_since_epoch().count(),
          std::filesystem::file_size(file, none)};
}

std::vector<std::string> namesOf(const mien::ExpressionLibrary& library) {
  std::vector<std::string> names;
  for (const mien::ExpressionProfile& profile : library.expressions()) names.push_back(profile.name);
  return names;
}

}  // namespace

struct vtkFAPAnimationFilter::Internals {
  mien::FAPFrame Values;
  std::map<std::string, double> Expressions, Visemes;
  std::string TableFileName;

  mien::FaceAnimator Animator;
  bool Bound = false;
  bool TableMayHaveChanged = true;
  std::string BoundTable;
  std::pair<long long, unsigned long long> TableState;  // of the file bound: modified, size
  vtkPolyData* BoundInput = nullptr;                    // compared with, never used
  vtkMTimeType BoundTime = 0;
  mien::AnimationRemarks Remarks;
  int Load = 0;  // of the animation file that these belong to
};

vtkFAPAnimationFilter::vtkFAPAnimationFilter() : Impl(std::make_unique<Internals>()) {
  this->SetNumberOfInputPorts(2);
}

vtkFAPAnimationFilter::~vtkFAPAnimationFilter() = default;

int vtkFAPAnimationFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkTable");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkFAPAnimationFilter::SetFAPConnection(vtkAlgorithmOutput* frames) {
  this->SetInputConnection(1, frames);
}

bool vtkFAPAnimationFilter::CheckFAP(int fap) {
  if (fap >= mien::FAPFrame::firstLowLevel && fap <= mien::FAPFrame::count) return true;
  vtkErrorMacro(<< "FAP " << fap << " has no value that can be set; use 3 to " << mien::FAPFrame::count);
  return false;
}

void vtkFAPAnimationFilter::SetFAP(int fap, double value) {
  if (!this->CheckFAP(fap) || value == this->Impl->Values.value(fap)) return;
  if (!std::isfinite(value)) {
    vtkErrorMacro(<< "the value of FAP " << fap << " is not finite; give a number");
    return;
  }
  this->Impl->Values.setValue(fap, value);
  this->Superclass::Modified();
}

double vtkFAPAnimationFilter::GetFAP(int fap) const {
  const bool known = fap >= mien::FAPFrame::firstLowLevel && fap <= mien::FAPFrame::count;
  return known ? this->Impl->Values.value(fap) : 0.0;
}

void vtkFAPAnimationFilter::ClearFAPs() {
  if (this->Impl->Values.isNeutral()) return;
  this->Impl->Values = mien::FAPFrame();
  this->Superclass::Modified();
}

void vtkFAPAnimationFilter::SetExpression(const std::string& name, double intensity) {
  if (!mien::defaultExpressions().find(name)) {
    vtkErrorMacro(<< "there is no expression \"" << name << "\"; GetExpressionNames() lists them");
    return;
  }
  if (!(intensity >= 0.0 && intensity <= 1.0)) {
    vtkErrorMacro(<< "the intensity of " << name << " is " << intensity << "; it must lie within 0 and 1");
    return;
  }
  if (this->GetExpression(name) == intensity) return;
  this->Impl->Expressions[name] = intensity;
  this->Superclass::Modified();
}

double vtkFAPAnimationFilter::GetExpression(const std::string& name) const {
  const auto found = this->Impl->Expressions.find(name);
  return found == this->Impl->Expressions.end() ? 0.0 : found->second;
}

void vtkFAPAnimationFilter::ClearExpressions() {
  if (this->Impl->Expressions.empty()) return;
  this->Impl->Expressions.clear();
  this->Superclass::Modified();
}

void vtkFAPAnimationFilter::SetViseme(const std::string& name, double strength) {
  if (!mien::defaultVisemes().find(name)) {
    vtkErrorMacro(<< "there is no viseme \"" << name << "\"; GetVisemeNames() lists them");
    return;
  }
  if (!(strength >= 0.0 && strength <= 1.0)) {
    vtkErrorMacro(<< "the strength of viseme " << name << " is " << strength << "; it must lie within 0 and 1");
    return;
  }
  if (this->GetViseme(name) == strength) return;
  this->Impl->Visemes[name] = strength;
  this->Superclass::Modified();
}

double vtkFAPAnimationFilter::GetViseme(const std::string& name) const {
  const auto found = this->Impl->Visemes.find(name);
  return found == this->Impl->Visemes.end() ? 0.0 : found->second;
}

void vtkFAPAnimationFilter::ClearVisemes() {
  if (this->Impl->Visemes.empty()) return;
  this->Impl->Visemes.clear();
  this->Superclass::Modified();
}

const std::vector<std::string>& vtkFAPAnimationFilter::GetVisemeNames() {
  static const std::vector<std::string> names = namesOf(mien::defaultVisemes());
  return names;
}

const std::vector<std::string>& vtkFAPAnimationFilter::GetExpressionNames() {
  static const std::vector<std::string> names = namesOf(mien::defaultExpressions());
  return names;
}

std::string vtkFAPAnimationFilter::GetExpressionDefinition(const std::string& name) {
  const mien::ExpressionProfile* expression = mien::defaultExpressions().find(name);
  return expression ? expression->definition : std::string();
}

double vtkFAPAnimationFilter::GetExpressionFAP(const std::string& name, int fap) {
  mien::FAPFrame frame;
  const bool known = fap >= mien::FAPFrame::firstLowLevel && fap <= mien::FAPFrame::count;
  mien::defaultExpressions().add(name, 1.0, frame);
  return known ? frame.value(fap) : 0.0;
}

void vtkFAPAnimationFilter::SetAnimationTableFileName(const std::string& name) {
  if (name == this->Impl->TableFileName) return;
  this->Impl->TableFileName = name;
  this->Modified();
}

std::string vtkFAPAnimationFilter::GetAnimationTableFileName() const {
  return this->Impl->TableFileName;
}

double vtkFAPAnimationFilter::GetFAPUnit(const std::string& symbol) const {
  using mien::FAPUnit;
  for (FAPUnit unit : {FAPUnit::IrisDiameter, FAPUnit::EyeSeparation, FAPUnit::EyeNoseSeparation,
                       FAPUnit::MouthNoseSeparation, FAPUnit::MouthWidth})
    if (this->Impl->Bound && symbol == mien::symbol(unit)) return this->Impl->Animator.units().distance(unit);
  return 0.0;
}

double vtkFAPAnimationFilter::GetContactClamped() const {
  return this->Impl->Bound ? this->Impl->Animator.contactClamped() : 0.0;
}

int vtkFAPAnimationFilter::GetContactPoints() const {
  return this->Impl->Bound ? this->Impl->Animator.contactSamples() : 0;
}

double vtkFAPAnimationFilter::GetPushed() const {
  return this->Impl->Bound ? this->Impl->Animator.pushed() : 0.0;
}

double vtkFAPAnimationFilter::GetLargestPushed() const {
  return this->Impl->Remarks.largestPushed;
}

double vtkFAPAnimationFilter::GetSmallestKeptShare() const {
  return this->Impl->Remarks.smallestKept;
}

double vtkFAPAnimationFilter::GetLargestContactClamped() const {
  return this->Impl->Remarks.largestClamped;
}

double vtkFAPAnimationFilter::GetKeptShare() const {
  return this->Impl->Bound ? this->Impl->Animator.keptShare() : 1.0;
}

std::vector<int> vtkFAPAnimationFilter::GetIgnoredFAPs() const {
  return {this->Impl->Remarks.ignoredFAPs.begin(), this->Impl->Remarks.ignoredFAPs.end()};
}

int vtkFAPAnimationFilter::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                              vtkInformationVector* outputs) {
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* frames = inputs[1]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  // VTK forwards time from the first port only.
  if (frames && frames->Has(SDDP::TIME_STEPS())) out->CopyEntry(frames, SDDP::TIME_STEPS());
  if (frames && frames->Has(SDDP::TIME_RANGE())) out->CopyEntry(frames, SDDP::TIME_RANGE());
  return 1;
}

int vtkFAPAnimationFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                               vtkInformationVector* outputs) {
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* frames = inputs[1]->GetInformationObject(0);
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  mien::requestWhole(frames);
  if (frames) passTime(outputs->GetInformationObject(0), frames, SDDP::UPDATE_TIME_STEP());
  return 1;
}

void vtkFAPAnimationFilter::Modified() {
  if (this->Impl) this->Impl->TableMayHaveChanged = true;
  this->Superclass::Modified();
}

bool vtkFAPAnimationFilter::IsPrepared(vtkPolyData* curves) {
  Internals& impl = *this->Impl;
  if (!impl.Bound || impl.BoundInput != curves || impl.BoundTime != curves->GetMTime()) return false;
  if (!impl.TableMayHaveChanged) return true;
  const bool same = impl.BoundTable == impl.TableFileName && stateOf(impl.TableFileName) == impl.TableState;
  impl.TableMayHaveChanged = !same;
  return same;
}

/// Binds the animation table to the face when either is new.
std::string vtkFAPAnimationFilter::Prepare(vtkPolyData* curves) {
  if (this->IsPrepared(curves)) return {};
  Internals& impl = *this->Impl;
  impl.Bound = false;
  mien::FaceCurves face;
  std::string fault = mien::readFaceCurves(curves, face);
  mien::AnimationTable table;
  impl.TableState = stateOf(impl.TableFileName);
  if (fault.empty()) fault = mien::readAnimationTable(impl.TableFileName, table);
  if (fault.empty()) fault = impl.Animator.bind(face, table);
  impl.Bound = fault.empty();
  impl.BoundTable = impl.TableFileName;
  impl.TableMayHaveChanged = !impl.Bound;
  impl.BoundInput = curves;
  impl.BoundTime = curves->GetMTime();
  impl.Remarks = {};
  return fault;
}

/// What frames of one file left out is not said of another.
void vtkFAPAnimationFilter::ForgetOtherFile(int load) {
  if (load != this->Impl->Load) this->Impl->Remarks = {};
  this->Impl->Load = load;
}

void vtkFAPAnimationFilter::NoteResults(const mien::FAPFrame& frame) {
  if (this->Impl->Remarks.add(this->Impl->Animator, frame)) this->InvokeEvent(IgnoredFAPsEvent);
}

namespace {

std::string readFrame(vtkTable* table, mien::FAPFrame& frame) {
  if (!table) return {};
  if (table->GetNumberOfRows() != 1)
    return "the FAP table has " + std::to_string(table->GetNumberOfRows()) + " rows; a FAP frame has one";
  const std::string fault = mien::readFAPFrame(table, 0, frame);
  return fault.empty() ? fault : "the FAP table: " + fault;
}

void addValues(const mien::FAPFrame& values, mien::FAPFrame& frame) {
  for (int fap = mien::FAPFrame::firstLowLevel; fap <= mien::FAPFrame::count; ++fap)
    frame.setValue(fap, frame.value(fap) + values.value(fap));
}

/// 7.1, the top of the spine: as high as the nose base, midway between the front and the back of the curve there.
Eigen::Vector3d topOfSpine(const mien::FaceCurves& face) {
  const mien::FeaturePoint* noseBase = face.feature("9.15");
  const Eigen::VectorXd depth = face.curves.curve(noseBase->curve).col(2);
  return {0.0, face.curves.at(noseBase->curve, noseBase->v).y(), 0.5 * (depth.minCoeff() + depth.maxCoeff())};
}

/// Takes the rotation of the head out of the frame: it comes last, when contact and order are judged.
mien::HeadRotation takeHeadRotation(const mien::FaceCurves& face, mien::FAPFrame& frame) {
  const mien::HeadRotation rotation(frame, topOfSpine(face));
  for (int fap : {48, 49, 50}) frame.setValue(fap, 0.0);
  return rotation;
}

/// Turns the pupils with the head and notes the rotation.
void turnFields(const mien::FaceCurves& face, const mien::HeadRotation& rotation, vtkPolyData* output) {
  if (!rotation.turns()) return;
  mien::ClosedCurves::Points pupils(2, 3);
  pupils << face.leftPupil.transpose(), face.rightPupil.transpose();
  rotation.apply(pupils);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Pupils");
  array->SetNumberOfComponents(3);
  for (int i = 0; i < 2; ++i) array->InsertNextTuple(pupils.row(i).data());
  output->GetFieldData()->AddArray(array);
  mien::writeHeadRotation(rotation, output->GetFieldData());
}

void copyDataTime(vtkDataObject* from, vtkDataObject* to) {
  if (from) passTime(from->GetInformation(), to->GetInformation(), vtkDataObject::DATA_TIME_STEP());
}

}  // namespace

int vtkFAPAnimationFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                       vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkTable* table = inputs[1]->GetNumberOfInformationObjects() > 0 ? vtkTable::GetData(inputs[1]) : nullptr;
  this->UpdateProgress(0.0);
  mien::FAPFrame frame;
  std::string fault = curves ? this->Prepare(curves) : "there are no boundary curves on port 0";
  if (fault.empty()) fault = readFrame(table, frame);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::resolveHighLevelFAPs(mien::defaultVisemes(), mien::defaultExpressions(), frame);
  addValues(this->Impl->Values, frame);
  for (const auto& [name, intensity] : this->Impl->Expressions) mien::defaultExpressions().add(name, intensity, frame);
  for (const auto& [name, strength] : this->Impl->Visemes) mien::defaultVisemes().add(name, strength, frame);
  if (this->GetAbortExecute()) return 1;
  this->ForgetOtherFile(table ? mien::readLoadNumber(table) : 0);
  const mien::FaceCurves& neutral = this->Impl->Animator.neutral();
  const mien::HeadRotation rotation = takeHeadRotation(neutral, frame);
  mien::ClosedCurves moved = this->Impl->Animator.animate(frame);
  rotation.apply(moved.points);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  mien::writeMovedCurves(this->Impl->Animator.neutral().curves, moved, curves, output);
  turnFields(neutral, rotation, output);
  copyDataTime(table, output);
  this->NoteResults(frame);
  return 1;
}

void vtkFAPAnimationFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  const Internals& impl = *this->Impl;
  os << indent << "AnimationTableFileName: " << (impl.TableFileName.empty() ? "(compiled in)" : impl.TableFileName)
     << "\n";
  for (int fap = mien::FAPFrame::firstLowLevel; fap <= mien::FAPFrame::count; ++fap)
    if (impl.Values.value(fap) != 0.0) os << indent << "FAP " << fap << ": " << impl.Values.value(fap) << "\n";
  for (const auto& [name, intensity] : impl.Expressions)
    os << indent << "Expression " << name << ": " << intensity << "\n";
  for (const auto& [name, strength] : impl.Visemes) os << indent << "Viseme " << name << ": " << strength << "\n";
}
