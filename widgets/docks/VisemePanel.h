#pragma once

#include <QWidget>
#include <array>
#include <string>

#include "FaceState.h"

namespace mien {

class FaceModel;
class VisemeRow;

/// What does a mouth look like while it speaks? Up to two of the 14 visemes of MPEG-4, each as strong as wanted.
class VisemePanel : public QWidget {
  Q_OBJECT
 public:
  explicit VisemePanel(FaceModel* model, QWidget* parent = nullptr);

 private:
  void choose(size_t row, const std::string& name);
  void setPercent(size_t row, int percent);
  void follow();

  FaceModel* model_;
  std::array<VisemeRow*, FaceState::mostVisemes> rows_;
  std::array<std::string, FaceState::mostVisemes> names_;  ///< in the rows; empty: none
  bool slides_ = false;                                    ///< while a slider changes the state
};

}  // namespace mien
