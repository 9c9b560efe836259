#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "AnimationTable.h"
#include "FAPSequence.h"
#include "FacePipeline.h"
#include "FaceState.h"
#include "vtkSmartPointer.h"

class QTimer;

class vtkPolyData;

namespace mien {

class MotionReach;

/// The one face that all widgets show and change: a FaceState and the pipeline that draws it.
///
/// Widgets change the state and follow its signals; they do not talk to each other. Changes that come quicker than the
/// pipeline runs are shown once, the last of them.
class FaceModel : public QObject {
  Q_OBJECT
 public:
  explicit FaceModel(QObject* parent = nullptr);
  ~FaceModel() override;

  const FaceState& state() const { return state_; }
  FacePipeline& pipeline() { return pipeline_; }
  const FacePipeline& pipeline() const { return pipeline_; }

  /// Changes the state now and the picture when the event loop is next idle.
  void change(const std::function<void(FaceState&)>& edit);

  /// Brings the pipeline up to date with the state. A state that the pipeline refuses is taken back to the last
  /// good one, and failed() says why. @return whether the state was good
  bool update();
  bool isSettled() const;  ///< whether the picture shows the state, as update() makes it

  /// Opens a .fap file at its first frame. When it has a fault all stays as it was. @return whether it was good
  bool openAnimation(const QString& fileName);
  void closeAnimation();

  /// Appends frames of a stream that is still being written; the first take the place of the animation that is open.
  void appendLive(double framesPerSecond, const QString& name, const std::vector<FAPFrame>& frames);
  bool isLive() const { return state_.fapFile == "-"; }

  /// What another pipeline or a file may be given: of a stream the frame that the state shows, as FAP values, since
  /// nobody can read a stream twice.
  FaceState withoutStream(FaceState state) const;
  FaceState lastingState() const { return withoutStream(state_); }

  /// Takes over a user's own animation table (.json), read anew from disk; an empty name: the one compiled in.
  /// @return whether it was good; else all stays as it was
  bool openAnimationTable(const QString& fileName);

  /// Lets a facial deformation table bend the face, by name or file, read anew from disk. @return whether it was good
  bool openDeformationTable(const QString& nameOrFile);

  /// Makes other boundary curves (.vtp, .mienz) the face, read anew from disk, without the edits of those before.
  /// @return whether they were good; else all stays as it was
  bool openCurves(const QString& fileName);

  int frameCount() const;          ///< of the open animation; 0 without one
  double framesPerSecond() const;  ///< of the open animation; 0 without one
  int frameIndex() const;          ///< from 0; between two frames that of the one before
  double framePosition() const;    ///< from 0; between two frames only while interpolating
  QString frameNumber() const;     ///< as written in the file
  std::string frameText() const;   ///< "frame 100"; empty without an animation
  vtkPolyData* mouth();  ///< the inside of the mouth as the face is now (MouthSack.h), made once for all views
  std::string motionText() const;   ///< what moves the face, in words; empty at rest
  void showFrame(double position);  ///< from 0; brought to the nearer end when outside

  /// Whether positions between two frames show their linear mixture, not the frame before. Default: off.
  bool interpolates() const { return state_.interpolateFrames; }
  void setInterpolating(bool on);

  /// What the open animation moves: its frames with visemes and expressions turned into the FAPs that they stand for.
  const FAPSequence& motion() const { return motion_; }

  /// Whether a FAP moves the face: it has surface for it, and the animation table an entry.
  bool moves(int fap) const;

  /// What the face shows of one FAP, in FAP units: its slider, the animation's frame and the expression together.
  double shownFAP(int fap) const;

  /// How far one FAP unit moves on this face, in mm; 0 for angles and for FAP 1 and 2.
  double millimetresPerUnit(int fap) const;

  /// Where the face has been and will be in its animation.
  const MotionReach& reach() const { return *reach_; }

  int pointsPerCurve() const { return pipeline_.pointsPerCurve(); }

  double pipelineTime() const { return pipelineTime_; }  ///< of the last update, in ms

 signals:
  void stateChanged();      ///< at once, with every change
  void updated();           ///< the pipeline's output is new
  void animationChanged();  ///< another .fap file, or none
  void animationGrew();     ///< a stream has more frames
  void reachChanged();      ///< the face moves further than it did, or rests
  void tableChanged();      ///< other FAPs may move the face
  void recovered();         ///< a change of more than the frame was good; what failed before it is history
  void failed(const QString& sentence, const QString& details);
  void remarked(const QString& sentence, const QString& details);  ///< accepted, but worth knowing

 private:
  bool takeTable(const std::string& name, const std::string& fault,
                 const std::function<std::string&(FaceState&)>& part);
  QString show(const FaceState& state);
  void accept();
  bool isReadAnew() const;
  void followAnimation();
  void followReach();
  void followTable();
  std::vector<int> stillFAPs() const;
  QString stillText() const;
  void reportAnimation();

  FacePipeline pipeline_;
  FaceState state_, good_;
  FAPSequence motion_;
  AnimationTable table_;
  QTimer* idle_;
  double pipelineTime_ = 0.0;
  bool reopened_ = false;
  std::set<int> reported_;  ///< FAPs of the animation that move nothing, as far as the user knows
  std::unique_ptr<MotionReach> reach_;
  vtkSmartPointer<vtkPolyData> mouth_;
  vtkMTimeType mouthTime_ = 0;  ///< of the curves that it belongs to
};

}  // namespace mien
