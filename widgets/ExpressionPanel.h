#pragma once

#include <QHash>
#include <QWidget>

class QPushButton;
class QSpinBox;

namespace mien {

class ValueSlider;
class FaceModel;

/// What does an expression look like? The six of MPEG-4, each as strong as wanted.
class ExpressionPanel : public QWidget {
  Q_OBJECT
 public:
  ExpressionPanel(FaceModel* model, QWidget* parent = nullptr);

 private:
  QWidget* buttons();
  QWidget* intensityRow();
  void choose(const QString& name);
  void follow();

  FaceModel* model_;
  QHash<QString, QPushButton*> buttons_;
  ValueSlider* slider_;
  QSpinBox* percent_;
};

}  // namespace mien
