#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "FaceState.h"
#include "SessionPart.h"

class QComboBox;
class QToolButton;

namespace mien {

class FaceModel;

/// Against what is motion measured? The neutral face, the frame before, or a state that was pinned.
/// Its widgets are vectorsAgainst, vectorsPin and vectorsUnpin.
class OriginChooser : public QWidget, public SessionPart {
  Q_OBJECT
 public:
  OriginChooser(FaceModel* model, QWidget* parent = nullptr);

  FaceState origin() const;
  bool isFrameBefore() const;  ///< whether the origin is another one for every frame
  QString originName() const;  ///< "the neutral face", "frame 100 of talk.fap, joy"

  nlohmann::json sessionState() const override;  ///< list of the pinned states: `number`, `name`, `words`, `face`
  QString changeName() const override { return tr("pinned states"); }
  void restoreSession(const nlohmann::json& state) override;

 public slots:
  void pin();    ///< keeps the present state and chooses it
  void unpin();  ///< forgets the chosen one

 signals:
  void changed();

 private:
  struct Pin {
    int number;
    FaceState state;
    QString words;
  };
  const Pin* pinned() const;
  void forgetAll();

  FaceModel* model_;
  QComboBox* choice_;
  QToolButton* unpin_;
  std::vector<Pin> pins_;
  int pinCount_ = 0;
};

}  // namespace mien
