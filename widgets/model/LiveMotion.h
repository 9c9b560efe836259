#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "FaceState.h"
#include "MotionVectorOptions.h"

namespace mien {

class BackgroundTask;
class FaceMotion;
class MotionVectorFigure;
struct MotionField;

/// What is drawn, and against what.
struct MotionRequest {
  FaceState moved, origin;
  std::string movedName;        ///< in words
  std::string originName;       ///< of the origin, in words
  std::string frames;           ///< "frame 100"; empty without an animation
  MotionVectorOptions options;  ///< without a region
  std::string region;           ///< as VectorRegion reads it; empty: the whole face
  bool headMotionRemoved = false;
  std::vector<int> samples;  ///< frames of an animation file, from 0, that tell how far all of it moves; empty: none
  bool againstFrameBefore = false;  ///< whether the origin of every sample is the frame before it
};

/// What came out.
struct MotionResult {
  QString fault;          ///< why there is nothing else
  MotionRequest request;  ///< with the region in its options
  std::shared_ptr<const MotionField> field;
  std::shared_ptr<const MotionVectorFigure> figure;
  std::vector<int> chosen;  ///< vectors of the region and the sampling, seen or not
};

/// Computes motion vector figures on a thread of its own, the latest request last.
///
/// While scale and range are left open, those of an animation file suit the motion of all its samples, and stay.
/// Without one they grow at once where the motion does, and shrink when it has been smaller for two seconds, so that
/// arrows keep their meaning from picture to picture and still can be seen. Another file begins anew, and so does
/// fit().
class LiveMotion : public QObject {
  Q_OBJECT
 public:
  explicit LiveMotion(QObject* parent);
  ~LiveMotion() override;

  void request(const MotionRequest& request);
  void fit();

  /// The last result; without a figure until there is one.
  const MotionResult& result() const { return result_; }

 signals:
  void finished();

 private:
  struct Held;
  using Progress = std::function<bool(double share)>;
  static void measure(FaceMotion& motion, MotionResult& result);
  static void survey(FaceMotion& motion, const MotionRequest& request, const Progress& progress, Held& held);
  static void draw(Held& held, MotionResult& result);

  MotionResult result_;
  std::shared_ptr<FaceMotion> motion_;
  std::shared_ptr<Held> held_;
  BackgroundTask* task_;
};

}  // namespace mien
