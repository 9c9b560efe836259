#include "StudyRun.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "BoundaryCurveData.h"
#include "CaseMeasures.h"
#include "Checksum.h"
#include "FAPSequence.h"
#include "FaceMotion.h"
#include "FacePipeline.h"
#include "HelperThreads.h"
#include "NumberText.h"
#include "TextFileReader.h"
#include "vtkAlgorithm.h"
#include "vtkFAPReader.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr std::chrono::milliseconds longestWait(50);  // until an interruption is seen
constexpr std::size_t largestStudyFile = std::size_t{1} << 32;
constexpr std::size_t keptCurves = 64;  // 20 kB each

/// The curves of a face in a pose, or why there are none.
struct PosedCurves {
  FaceCurves face;
  std::string fault;
};

/// Makes the curves of one case after the other; the last ones are kept. One pipeline serves all threads: it takes a
/// small part of the time of a block.
class CurveSource {
 public:
  std::shared_ptr<const PosedCurves> curves(const FaceState& state) {
    const std::lock_guard<std::mutex> guard(lock_);
    const std::string key = keyOf(state);
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    if (made_.size() >= keptCurves) made_.clear();
    return made_[key] = make(state);
  }

  FacePipeline& pipeline() { return pipeline_; }

 private:
  static std::string keyOf(const FaceState& state) {
    std::string key = state.curvesFile + "\n" + state.fapFile + "\n" + numberText(state.frame);
    for (const auto& [name, intensity] : state.expressions) key += "\n" + name + " " + numberText(intensity);
    return key;
  }

  std::shared_ptr<const PosedCurves> make(FaceState state) {
    state.surface = FaceSurfaceOptions();  // the curves do not depend on it; the measures say what is wrong with it
    auto posed = std::make_shared<PosedCurves>();
    pipeline_.setState(state);
    posed->fault = pipeline_.updateCurves();
    if (posed->fault.empty())
      posed->fault = readFaceCurves(vtkPolyData::SafeDownCast(pipeline_.curves()->GetOutputDataObject(0)), posed->face);
    return posed;
  }

  std::mutex lock_;
  FacePipeline pipeline_;
  std::map<std::string, std::shared_ptr<const PosedCurves>> made_;
};

/// The blocks of a share, worked off by several threads.
class Work {
 public:
  Work(const Study& study, const StudyCases& cases, const StudyRun::Share& share, const StudyRun::Calls& calls,
       CurveSource& source)
      : study_(study), cases_(cases), share_(share), calls_(calls), source_(source) {}

  /// Takes blocks until none is left; keeps the first exception of any thread.
  void run() {
    try {
      for (std::int64_t i = next(); i < cases_.blockCount() && !stopped_; i = next()) compute(cases_.block(i));
    } catch (...) {
      const std::lock_guard<std::mutex> guard(lock_);
      if (!failure_) failure_ = std::current_exception();
      stopped_ = true;
    }
    ++ended_;
    changed_.notify_one();
  }

  /// Until all threads have ended.
  void await(int threads) {
    while (ended_ < threads) {
      if (!calls_.goOn()) stopped_ = true;
      std::unique_lock<std::mutex> guard(lock_);
      changed_.wait_for(guard, longestWait, [&] { return ended_ >= threads; });
    }
  }

  bool isComplete() const {
    if (failure_) std::rethrow_exception(failure_);
    return !stopped_;
  }

 private:
  std::int64_t next() { return share_.first + share_.step * taken_++; }

  void compute(const StudyBlock& block) {
    std::shared_ptr<const PosedCurves> moved, neutral;
    std::unique_ptr<CaseMeasures> measures;
    for (std::int64_t number = block.first; number < block.last && !stopped_; ++number) {
      if (calls_.isDone(number)) continue;
      const StudyCase one = cases_.at(number);
      if (!moved) moved = source_.curves(one.state);
      if (!neutral) neutral = source_.curves(FaceMotion::neutralOf(one.state));
      const std::string& fault = moved->fault.empty() ? neutral->fault : moved->fault;
      if (fault.empty() && !measures)
        measures = std::make_unique<CaseMeasures>(study_, one, moved->face, neutral->face);
      append(one, fault.empty() ? measures->measure(one.state.surface.smoothing[0]) : without(fault));
    }
  }

  CaseValues without(const std::string& reason) const {
    return {std::vector<double>(study_.measures.size(), std::numeric_limits<double>::quiet_NaN()), reason};
  }

  void append(const StudyCase& one, const CaseValues& measured) {
    const std::lock_guard<std::mutex> guard(appending_);
    calls_.append(one, measured);
  }

  const Study& study_;
  const StudyCases& cases_;
  const StudyRun::Share share_;
  const StudyRun::Calls& calls_;
  CurveSource& source_;
  std::atomic<std::int64_t> taken_{0};
  std::atomic<int> ended_{0};
  std::atomic<bool> stopped_{false};
  std::mutex lock_, appending_;
  std::condition_variable changed_;
  std::exception_ptr failure_;
};

}  // namespace

struct StudyRun::Internals {
  Study study;
  std::unique_ptr<StudyCases> cases;
  CurveSource source;
  std::string contents;
  bool isOfValue = false;

  FacePipeline& pipeline() { return source.pipeline(); }

  /// @return nothing, or why the file cannot be told from another
  std::string addContent(const std::string& file) {
    std::string bytes;
    const std::string fault = readTextFile(file, largestStudyFile, bytes);
    if (!fault.empty()) return file + ":" + fault;
    contents += hashText(bytes) + "\n";
    return {};
  }

  std::string readFace(const std::string& name) {
    FaceState state;
    if (name != Study::genericFace) state.curvesFile = study.pathOf(name);
    pipeline().setState(state);
    const std::string fault = pipeline().updateNeutralCurves();
    return fault.empty() && !state.curvesFile.empty() ? addContent(state.curvesFile) : fault;
  }

  std::string readFrames() {
    if (study.fapFile.empty()) return {};
    FaceState state;
    state.fapFile = study.pathOf(study.fapFile);
    pipeline().setState(state);
    const std::string fault = pipeline().updateNeutralCurves();
    if (!fault.empty()) return fault;
    std::vector<double> numbers;
    for (const FAPFrame& frame : pipeline().frames()->GetSequence().frames) numbers.push_back(frame.number);
    study.addAllFrames(numbers);
    return addContent(state.fapFile);
  }

  std::string countCases() {
    const double count = study.caseCount();
    isOfValue = !(count >= 1.0 && count <= static_cast<double>(Study::mostCases));
    if (isOfValue)
      return "the study has " + numberText(count) + " cases with all frames; 1 to 10,000,000 can be computed";
    cases = std::make_unique<StudyCases>(study);
    return {};
  }

  /// Poses that the generic face cannot take are wrong for all: a misspelt name, a frame that is not there.
  std::string checkPoses() {
    FaceState state;
    for (const StudyPose& pose : study.poses) {
      state.expressions = pose.expressions;
      state.fapFile = pose.isFrame ? study.pathOf(study.fapFile) : std::string();
      state.frameChoice = FaceState::FrameChoice::Number;
      state.frame = pose.frame;
      pipeline().setState(state);
      std::string fault = pipeline().updateNeutralCurves();
      if (fault.empty()) fault = pipeline().describeValueFault();
      if (fault.empty()) continue;
      isOfValue = true;
      return fault;
    }
    return {};
  }
};

StudyRun::StudyRun(const Study& study) : Impl(new Internals) {
  this->Impl->study = study;
}

StudyRun::~StudyRun() = default;

std::string StudyRun::open(const std::function<bool()>& goOn) {
  Internals& own = *this->Impl;
  own.contents.clear();
  for (const std::string& face : own.study.faces) {
    if (!goOn()) return {};
    const std::string fault = own.readFace(face);
    if (!fault.empty()) return fault;
  }
  std::string fault = own.readFrames();
  if (fault.empty()) fault = own.countCases();
  return fault.empty() ? own.checkPoses() : fault;
}

bool StudyRun::faultIsOfValue() const {
  return this->Impl->isOfValue;
}

const Study& StudyRun::study() const {
  return this->Impl->study;
}

const StudyCases& StudyRun::cases() const {
  return *this->Impl->cases;
}

const std::string& StudyRun::contents() const {
  return this->Impl->contents;
}

bool StudyRun::run(const Share& share, const Calls& calls) {
  Work work(study(), cases(), share, calls, this->Impl->source);
  HelperThreads threads;
  int started = 0;
  for (int i = 0; i < share.threads; ++i) started += threads.start([&] { work.run(); });
  if (started == 0) {
    work.run();
    started = 1;
  }
  work.await(started);
  threads.join();
  return work.isComplete();
}

}  // namespace mien
