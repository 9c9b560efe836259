#include "ComparisonBar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "Comparison.h"
#include "FaceScheme.h"
#include "FileDialog.h"
#include "SessionPart.h"

namespace mien {

namespace {

enum Entry { Nothing, Keep, OpenMesh, Commands };

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
  label->setToolTip(choice_->toolTip());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(label);
  row->addWidget(choice_);
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this, &ComparisonBar::choose);
  connect(comparison_, &Comparison::changed, this, &ComparisonBar::follow);
}

void ComparisonBar::list() {
  choice_->addItems({tr("Nothing"), tr("Keep this state"), tr("Mesh or scan...")});
  choice_->setItemData(Keep, tr("Keeps A as it is now; chosen again, A as it is then"), Qt::ToolTipRole);
  for (const FaceScheme& scheme : faceSchemes()) {
    const QString name = QString::fromStdString(scheme.name);
    choice_->addItem(tr("Scheme %1").arg(name), name);
    choice_->setItemData(choice_->count() - 1, QString::fromStdString(scheme.description), Qt::ToolTipRole);
  }
  choice_->insertSeparator(Commands);
}

void ComparisonBar::choose(int index) {
  const QString scheme = choice_->itemData(index).toString();
  if (!scheme.isEmpty()) return comparison_->compareScheme(scheme);
  if (index == Nothing) return comparison_->clear();
  if (index == Keep) return comparison_->pin();
  if (index == OpenMesh) chooseMesh();
  follow();  // nothing may have been chosen
}

void ComparisonBar::chooseMesh() {
  const QString name =
      FileDialog::open(window(), tr("Compare with a mesh or scan"),
                       tr("Surfaces (*.vts *.vtp *.ply *.obj *.stl *.off *.PLY *.OBJ *.STL *.OFF);;All files (*)"));
  if (!name.isEmpty()) comparison_->openMesh(name);
}

/// A scheme is an entry of the list. A kept state and a mesh get one while they are shown: what was chosen for them is
/// a command, and says nothing of them.
void ComparisonBar::follow() {
  const QSignalBlocker quiet(choice_);
  const Comparison::Kind kind = comparison_->kind();
  if (hasShown_) choice_->removeItem(Commands);
  hasShown_ = kind == Comparison::Kind::State || kind == Comparison::Kind::Mesh;
  if (hasShown_) choice_->insertItem(Commands, shownText());
  choice_->setCurrentIndex(hasShown_                          ? Commands
                           : kind == Comparison::Kind::Scheme ? choice_->findData(comparison_->scheme())
                                                              : Nothing);
}

QString ComparisonBar::shownText() const {
  const bool kept = comparison_->kind() == Comparison::Kind::State;
  return kept ? tr("Kept: %1").arg(comparison_->name()) : comparison_->name();
}

}  // namespace mien
