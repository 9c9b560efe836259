#include "ComparisonBar.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "Comparison.h"
#include "FaceScheme.h"
#include "SessionPart.h"

namespace mien {

namespace {

enum Entry { Nothing, Pinned, Mesh, FirstScheme };

}  // namespace

ComparisonBar::ComparisonBar(Comparison* comparison, QWidget* parent)
    : QWidget(parent), comparison_(comparison), choice_(new QComboBox(this)) {
  setObjectName("comparisonBar");
  choice_->setObjectName("compareWith");
  choice_->setProperty(notInSession, true);  // the comparison itself is
  choice_->setToolTip(
      tr("Shows a second face B beside A, and how far they lie apart (mm): A as it is now, which stays while A goes "
         "on; A in another scheme, which moves along; or a mesh or scan in mm and in the pose of the face. In any "
         "other unit or pose a scan is placed by the dock Curves and scan"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(13);
  list();
  auto* label = new QLabel(tr("Compare &with"), this);
  label->setBuddy(choice_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(label);
  row->addWidget(choice_);
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this, &ComparisonBar::choose);
  connect(comparison_, &Comparison::changed, this, &ComparisonBar::follow);
}

void ComparisonBar::list() {
  choice_->addItems({tr("nothing"), tr("This state"), tr("Mesh or scan...")});
  choice_->setItemData(Pinned, tr("Keeps A as it is now; chosen again, A as it is then"), Qt::ToolTipRole);
  for (const FaceScheme& scheme : faceSchemes()) {
    const QString name = QString::fromStdString(scheme.name);
    choice_->addItem(tr("Scheme %1").arg(name), name);
    choice_->setItemData(choice_->count() - 1, QString::fromStdString(scheme.description), Qt::ToolTipRole);
  }
  choice_->insertSeparator(FirstScheme);
}

void ComparisonBar::choose(int index) {
  const QString scheme = choice_->itemData(index).toString();
  if (!scheme.isEmpty()) return comparison_->compareScheme(scheme);
  if (index == Nothing) return comparison_->clear();
  if (index == Pinned) return comparison_->pin();
  chooseMesh();
  follow();  // nothing may have been chosen
}

void ComparisonBar::chooseMesh() {
  const QString name = QFileDialog::getOpenFileName(
      window(), tr("Compare with a mesh or scan"), QString(),
      tr("Surfaces (*.vts *.vtp *.ply *.obj *.stl *.off *.PLY *.OBJ *.STL *.OFF);;All files (*)"));
  if (!name.isEmpty()) comparison_->openMesh(name);
}

void ComparisonBar::follow() {
  const QSignalBlocker quiet(choice_);
  const Comparison::Kind kind = comparison_->kind();
  const int index = kind == Comparison::Kind::Scheme  ? choice_->findData(comparison_->scheme())
                    : kind == Comparison::Kind::State ? Pinned
                    : kind == Comparison::Kind::Mesh  ? Mesh
                                                      : Nothing;
  choice_->setCurrentIndex(index);
}

}  // namespace mien
