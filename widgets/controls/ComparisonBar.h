#pragma once

#include <QWidget>

class QComboBox;
class QToolButton;

namespace mien {

class Comparison;

/// With what the face is compared: nothing, a state that was pinned, another scheme, or a mesh.
/// Its widget is compareWith.
class ComparisonBar : public QWidget {
  Q_OBJECT
 public:
  ComparisonBar(Comparison* comparison, QWidget* parent = nullptr);

 private:
  void list();
  void choose(int index);
  void chooseMesh();
  void follow();
  QString shownText() const;

  Comparison* comparison_;
  QComboBox* choice_;
  bool hasShown_ = false;  ///< whether the list has an entry for the kept state or the mesh
};

}  // namespace mien
