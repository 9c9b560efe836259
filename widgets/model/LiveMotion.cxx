#include "LiveMotion.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "BackgroundTask.h"
#include "FaceMotion.h"
#include "MotionVectorFigure.h"
#include "RecentMotion.h"
#include "VectorScale.h"

namespace mien {

namespace {

constexpr double shrinkShare = 0.7;    // of the present scale: a smaller change is not worth a jump
constexpr double rangeSlack = 1.25;    // motion between the samples of a file may be that much more than theirs
constexpr double longestArrow = 0.13;  // over the width of the figure, as MotionVectorFigure chooses the scale

using Length = MotionVectorOptions::Length;
using Color = MotionVectorOptions::Color;

std::shared_ptr<MotionVectorFigure> figureOf(const MotionResult& result, const MotionVectorOptions& options) {
  return std::make_shared<MotionVectorFigure>(std::vector<MotionVectorPanel>{{*result.field, {}}}, options);
}

const VectorPicture& pictureOf(const MotionVectorFigure& figure) {
  return figure.panels().front().picture();
}

/// What scale and range depend on, in one picture.
RecentMotion::Lengths lengthsOf(const MotionVectorFigure& figure, const MotionVectorOptions& options) {
  const VectorPicture& picture = pictureOf(figure);
  RecentMotion::Lengths lengths = {options.length == Length::InSpace ? picture.largest() : picture.longest(), 0.0};
  for (const PictureArrow& arrow : picture.arrows)
    lengths.colored =
        std::max(lengths.colored, options.color == Color::Towards ? std::abs(arrow.towards) : arrow.magnitude);
  if (options.color == Color::Towards)
    lengths.colored = std::max(lengths.colored, MotionVectorFigure::leastTowards * picture.largest());
  return lengths;
}

bool outgrowsScale(const MotionVectorFigure& figure, const MotionVectorOptions& options) {
  return lengthsOf(figure, options).drawn > longestArrow * options.width * figure.scale();
}

bool outgrowsRange(const MotionVectorFigure& figure, const MotionVectorOptions& options, double slack) {
  return lengthsOf(figure, options).colored > slack * figure.rangeEnd();
}

}  // namespace

/// Scale and range as they were chosen last. The numbers belong to the thread that computes.
struct LiveMotion::Held {
  std::atomic<bool> outdated{true};
  MotionVectorOptions options;  ///< for which
  std::string fapFile;
  bool headMotionRemoved = false;
  std::optional<RecentMotion::Lengths> file;  ///< the most of all samples
  std::optional<double> scale;
  std::optional<std::array<double, 2>> range;
  RecentMotion recent;

  /// Other lengths, colours or sizes of the figure have other scales; the size alone does not change the motion.
  void follow(const MotionRequest& request) {
    const MotionVectorOptions& other = request.options;
    const bool same = options.length == other.length && options.color == other.color &&
                      fapFile == request.moved.fapFile && headMotionRemoved == request.headMotionRemoved;
    const bool anew = outdated.exchange(false) || !same;
    if (anew) file.reset();
    if (anew || options.width != other.width) {
      scale.reset();
      range.reset();
      recent.clear();
    }
    options = other;
    fapFile = request.moved.fapFile;
    headMotionRemoved = request.headMotionRemoved;
  }

  /// What all of the file needs.
  void fitFile(const MotionVectorFigure& figure) {
    const double end = automaticRangeEnd(file->colored);
    scale = figure.scaleFor(file->drawn);
    range = {options.color == Color::Towards ? -end : 0.0, end};
  }

  /// Where all recent motion was much smaller, what fits it takes the place. @return whether there is a change
  bool shrink(const MotionVectorFigure& figure) {
    if (file) return false;
    const std::optional<RecentMotion::Lengths> most =
        recent.add(std::chrono::steady_clock::now(), lengthsOf(figure, options));
    if (!most || !scale || !range || !(most->drawn > 0.0)) return false;
    const double smaller = figure.scaleFor(most->drawn), end = automaticRangeEnd(most->colored);
    const bool shorter = smaller < shrinkShare * *scale, paler = end < shrinkShare * (*range)[1];
    if (shorter) scale = smaller;
    if (paler) range = {(*range)[0] < 0.0 ? -end : 0.0, end};
    return shorter || paler;
  }
};

LiveMotion::LiveMotion(QObject* parent)
    : QObject(parent),
      motion_(std::make_shared<FaceMotion>()),
      held_(std::make_shared<Held>()),
      task_(new BackgroundTask(this)) {}

LiveMotion::~LiveMotion() = default;

void LiveMotion::fit() {
  held_->outdated = true;
}

void LiveMotion::request(const MotionRequest& request) {
  const auto work = [this, request, motion = motion_, held = held_](const BackgroundTask::Progress& progress) {
    const auto result = std::make_shared<MotionResult>();
    result->request = request;
    held->follow(request);
    survey(*motion, request, progress, *held);
    measure(*motion, *result);
    if (result->fault.isEmpty()) draw(*held, *result);
    return std::function<void()>([this, result] {
      result_ = *result;
      emit finished();
    });
  };
  task_->start(work, BackgroundTask::Before::Finishes);
}

void LiveMotion::measure(FaceMotion& motion, MotionResult& result) {
  const MotionRequest& request = result.request;
  motion.setStates(request.moved, request.origin);
  motion.setHeadMotionRemoved(request.headMotionRemoved);
  std::string fault = motion.update();
  VectorPictureOptions& picture = result.request.options.picture;
  if (fault.empty() && !request.region.empty()) fault = picture.region.parse(request.region, &motion.originFace());
  result.fault = QString::fromStdString(fault);
  if (fault.empty()) result.field = std::make_shared<MotionField>(motion.field());
}

/// Once for a file. Work that is cancelled leaves it to the next.
void LiveMotion::survey(FaceMotion& motion, const MotionRequest& request, const Progress& progress, Held& held) {
  if (held.file || request.samples.empty()) return;
  RecentMotion::Lengths most;
  MotionResult sample;
  for (size_t i = 0; i < request.samples.size(); ++i) {
    if (!progress(static_cast<double>(i) / static_cast<double>(request.samples.size()))) return;
    sample.request = request;
    FaceState& moved = sample.request.moved;
    moved.frameChoice = FaceState::FrameChoice::Index;
    moved.interpolateFrames = false;
    moved.frame = request.samples[i];
    if (request.againstFrameBefore) sample.request.origin.frame = std::max(0, request.samples[i] - 1);
    measure(motion, sample);
    if (!sample.fault.isEmpty()) return;  // the picture will say so
    MotionVectorOptions& options = sample.request.options;
    options.picture.lines = false;
    const RecentMotion::Lengths lengths = lengthsOf(*figureOf(sample, options), options);
    most.drawn = std::max(most.drawn, lengths.drawn);
    most.colored = std::max(most.colored, lengths.colored);
  }
  held.file = most;
}

/// A table holds what is behind the face too, where the sampling does not ask who is seen.
void LiveMotion::draw(Held& held, MotionResult& result) {
  const MotionVectorOptions& asked = result.request.options;
  MotionVectorOptions options = asked;
  if (held.file && !held.range) held.fitFile(*figureOf(result, asked));
  if (!asked.scale && !asked.trueToFace) options.scale = held.scale;
  if (!asked.range) options.range = held.range;
  auto figure = figureOf(result, options);
  const bool longer = !asked.scale && options.scale && outgrowsScale(*figure, options);
  const bool beyond = !asked.range && options.range && outgrowsRange(*figure, options, held.file ? rangeSlack : 1.0);
  if (longer) options.scale.reset();
  if (beyond) options.range.reset();
  if (longer || beyond) figure = figureOf(result, options);
  if (held.shrink(*figure)) {
    if (!asked.scale && !asked.trueToFace) options.scale = held.scale;
    if (!asked.range) options.range = held.range;
    figure = figureOf(result, options);
  }
  if (!pictureOf(*figure).arrows.empty()) {
    if (!asked.trueToFace) held.scale = figure->scale();
    if (!figure->lacksTowards()) held.range = {figure->rangeBegin(), figure->rangeEnd()};
  }
  result.figure = figure;
  VectorPictureOptions all = asked.picture;
  if (all.sampling.kind == VectorSampling::Kind::Automatic) all.sampling.kind = VectorSampling::Kind::Every;
  all.hidden = all.hidden || all.sampling.kind != VectorSampling::Kind::Even;
  result.chosen = all.sampling.kind == VectorSampling::Kind::Even ? pictureOf(*figure).chosen
                                                                  : drawnVectors(*result.field, all).chosen;
}

}  // namespace mien
