#pragma once

#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

#include "FaceState.h"

class QComboBox;
class QToolButton;

namespace mien {

class FaceModel;

/// Against what is motion measured? The neutral face, the frame before, or a state that was pinned.
/// Its widgets are vectorsAgainst, vectorsPin and vectorsUnpin.
class OriginChooser : public QWidget {
  Q_OBJECT
 public:
  OriginChooser(FaceModel* model, QWidget* parent = nullptr);

  FaceState origin() const;
  QString originName() const;  ///< "the neutral face"

 public slots:
  void pin();    ///< keeps the present state and chooses it
  void unpin();  ///< forgets the chosen one

 signals:
  void changed();

 private:
  const FaceState* pinned() const;

  FaceModel* model_;
  QComboBox* choice_;
  QToolButton* unpin_;
  std::vector<std::pair<int, FaceState>> pins_;  ///< with their numbers
  int pinCount_ = 0;
};

}  // namespace mien
