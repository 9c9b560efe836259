#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace mien {

class FaceModel;

/// How do the scheme, the smoothing parameter a and the number of modes N shape the surface between its curves?
class SurfacePanel : public QWidget {
  Q_OBJECT
 public:
  SurfacePanel(FaceModel* model, QWidget* parent = nullptr);

 private:
  void addScheme(QFormLayout* form);
  void addSmoothing(QFormLayout* form);
  void addModes(QFormLayout* form);
  void addResolution(QFormLayout* form);
  void follow();

  FaceModel* model_;
  QComboBox* scheme_;
  QDoubleSpinBox* smoothing_;
  QSpinBox *modes_, *rows_, *columns_;
  QCheckBox* remainder_;
};

}  // namespace mien
