#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace mien {

class FaceModel;
class FacePhotograph;
class FaceView;
class PictureLabel;
class WarpMeshView;

/// How does a photograph come onto the face? The photograph with its mesh, to be moved to where the features lie; the
/// texture that it is warped to; and the face with it, at once.
class TexturePanel : public QWidget {
  Q_OBJECT
 public:
  TexturePanel(FaceModel* model, FaceView* view, QWidget* parent = nullptr);
  ~TexturePanel() override;

  void open(const QString& fileName);  ///< a photograph, a mesh or a list of landmarks
  bool save(const QString& fileName);
  QString fileName() const;  ///< of the photograph that is shown; empty without

 signals:
  void opened();  ///< another photograph is shown, or none, or the one before stays

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* controls();
  QWidget* statusRow();
  QWidget* emptyState();
  void describeButtons();
  void describeChoices();
  void describeViews();
  void connectControls();
  void openPainted();
  void chooseImage();
  void chooseMesh();
  void chooseSaved();
  void showPhotograph();
  void showChosen();
  bool isUnsaved() const;
  QString unsavedText() const;

  FaceModel* model_;
  FacePhotograph* photograph_;
  WarpMeshView* mesh_;
  PictureLabel* warped_;
  QStackedWidget* pages_;
  QWidget* controls_ = nullptr;
  QLabel* status_;
  QToolButton *open_, *painted_, *openMesh_, *undo_, *reset_, *save_, *cancel_;
  QCheckBox *on_, *fine_, *mirror_;
  QProgressBar* progress_;
  QString fault_;
};

}  // namespace mien
