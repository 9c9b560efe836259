#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QSpinBox;
class QToolButton;

namespace mien {

class FaceModel;
class ValueSlider;

/// Which facial deformation table bends the face, how strongly, and whether its regions blend.
class DeformationChoice : public QWidget {
  Q_OBJECT
 public:
  explicit DeformationChoice(FaceModel* model, QWidget* parent = nullptr);

  /// A table from a file, read anew; the message bar says what is wrong with it. @return whether it was good
  bool open(const QString& fileName);

 private:
  void describeControls();
  void connectControls();
  void setPercent(int percent);
  void follow();
  int rowOf(const QString& table);

  FaceModel* model_;
  QComboBox* table_;
  QToolButton* open_;
  ValueSlider* strength_;
  QSpinBox* percent_;
  QCheckBox* blend_;
};

}  // namespace mien
