#pragma once

#include <QHash>
#include <QWidget>

namespace mien {

class ExpressionRow;
class FaceModel;

/// What do expressions look like, alone and mixed? The six of MPEG-4, each as strong as wanted, and below them what the
/// mouth says.
class ExpressionPanel : public QWidget {
  Q_OBJECT
 public:
  ExpressionPanel(FaceModel* model, QWidget* parent = nullptr);

 private:
  void addRow(const QString& name);
  void follow();

  FaceModel* model_;
  QHash<QString, ExpressionRow*> rows_;
};

}  // namespace mien
