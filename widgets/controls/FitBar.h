#pragma once

#include <QWidget>

class QToolButton;

namespace mien {

class ElidedLabel;
class FaceModel;
class PresentTable;

/// A table from two states of the face: pins the neutral one, says how well the fit is, uses it and saves it.
class FitBar : public QWidget {
  Q_OBJECT
 public:
  FitBar(FaceModel* model, PresentTable* present, QWidget* parent = nullptr);

  /// Writes the fit as a .csv; the message bar says what went wrong. @return whether it was written
  bool save(const QString& fileName);

 private:
  void describeControls();
  std::string comment(const std::string& name) const;
  void ask();
  void use();
  void showFit();

  FaceModel* model_;
  PresentTable* present_;
  QToolButton *pin_, *use_, *save_;
  ElidedLabel* status_;
  int used_ = 0;  ///< fits of this session
};

}  // namespace mien
