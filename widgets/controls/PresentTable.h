#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "DeformationTable.h"
#include "FacePipeline.h"
#include "SessionPart.h"
#include "TableRecognition.h"

namespace mien {

class BackgroundTask;
class FaceModel;

/// Which table moves the neutral face A to the present one, and which expression is that? Fitted in the background.
///
/// A is the face at rest, or one that was pinned with all that moves it, its table too; always of the present surface
/// and mesh.
class PresentTable : public QObject, public SessionPart {
  Q_OBJECT
 public:
  struct Fit {
    DeformationTable table;
    std::array<double, DeformationTable::regionCount> rms{};  ///< of what is left in each region, pupil units
    std::array<int, DeformationTable::regionCount> points{};
    double totalRms = 0.0;                 ///< pupil units
    std::vector<RecognitionScore> scores;  ///< against expressions(), nearest first
    QString warning;                       ///< names sparse regions
    QString fault;                         ///< why there is no table; the rest is empty then

    bool moves() const;  ///< more than rounding and measuring: else there is nothing to name
  };

  PresentTable(FaceModel* model, QObject* parent);
  ~PresentTable() override;

  /// Names of the mean tables that faces are compared with.
  static const std::vector<std::string>& expressions();

  void pin();    ///< A is the present face from now on
  void unpin();  ///< A is the face at rest
  bool isPinned() const { return pinned_.has_value(); }

  nlohmann::json sessionState() const override;  ///< `face`: the pinned state; {} without one
  QString changeName() const override { return tr("pinned face"); }
  void restoreSession(const nlohmann::json& state) override;

  /// A, with the present surface and mesh.
  FaceState neutralState() const;

  /// A in words: "the face at rest", "pinned: deformation table joy at 2".
  QString neutralText() const;

  void request();  ///< fits anew; the last request of several wins
  const std::optional<Fit>& fit() const { return fit_; }
  bool isOfPresentFace() const;  ///< whether the fit is of the face as it stands now, not of one before

 signals:
  void changed();

 private:
  FaceModel* model_;
  BackgroundTask* task_;
  FacePipeline neutral_;
  std::optional<FaceState> pinned_;
  std::optional<Fit> fit_;
  FaceState fitted_;  ///< that the fit is of
};

}  // namespace mien
