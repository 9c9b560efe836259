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
  return lengths;
}

bool outgrowsScale(const MotionVectorFigure& figure, const MotionVectorOptions& options) {
  return lengthsOf(figure, options).drawn > longestArrow * options.width * figure.scale();
}

bool outgrowsRange(const MotionVectorFigure& figure, const MotionVectorOptions& options) {
  return lengthsOf(figure, options).colored > figure.rangeEnd();
}

}  // namespace

/// Scale and range as they were chosen last. The numbers belong to the thread that computes.
struct LiveMotion::Held {
  std::atomic<bool> outdated{true};
  MotionVectorOptions options;  ///< for which
  std::optional<double> scale;
  std::optional<std::array<double, 2>> range;
  RecentMotion recent;

  /// Other lengths, colours or sizes of the figure have other scales.
  void follow(const MotionVectorOptions& other) {
    const bool same = options.length == other.length && options.color == other.color && options.width == other.width;
    if (outdated.exchange(false) || !same) {
      scale.reset();
      range.reset();
      recent.clear();
    }
    options = other;
  }

  /// Where all recent motion was much smaller, what fits it takes the place. @return whether there is a change
  bool shrink(const MotionVectorFigure& figure) {
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
  const auto work = [this, request, motion = motion_, held = held_](const BackgroundTask::Progress&) {
    const auto result = std::make_shared<MotionResult>();
    result->request = request;
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

/// A table holds what is behind the face too, where the sampling does not ask who is seen.
void LiveMotion::draw(Held& held, MotionResult& result) {
  const MotionVectorOptions& asked = result.request.options;
  held.follow(asked);
  MotionVectorOptions options = asked;
  if (!asked.scale && !asked.trueToFace) options.scale = held.scale;
  if (!asked.range) options.range = held.range;
  auto figure = figureOf(result, options);
  const bool longer = !asked.scale && options.scale && outgrowsScale(*figure, options);
  const bool beyond = !asked.range && options.range && outgrowsRange(*figure, options);
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
    held.range = {figure->rangeBegin(), figure->rangeEnd()};
  }
  result.figure = figure;
  VectorPictureOptions all = asked.picture;
  all.hidden = all.hidden || all.sampling.kind != VectorSampling::Kind::Even;
  result.chosen =
      all.hidden == asked.picture.hidden ? pictureOf(*figure).chosen : drawnVectors(*result.field, all).chosen;
}

}  // namespace mien
