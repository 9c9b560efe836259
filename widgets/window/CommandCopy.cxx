#include "CommandCopy.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QStringList>

#include "Comparison.h"
#include "FaceColoring.h"
#include "FaceCommand.h"
#include "FaceModel.h"
#include "ViewArea.h"

namespace mien {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("CommandCopy", text);
}

/// What the face shows and no option of the command says.
QStringList leftOut(const ViewArea& views) {
  const FaceColoring& coloring = *views.coloring();
  QStringList all;
  if (views.comparison()->kind() != Comparison::Kind::None) all << tr("the comparison with B");
  if (!coloring.ofDock().isEmpty()) all << coloring.ofDock();
  if (coloring.isNumbers() && coloring.arrayName().empty()) all << tr("the colours");
  if (coloring.isNumbers() && !coloring.isAutomatic()) all << tr("the range of the colours");
  if (views.showsNames()) all << tr("the names of the curves");
  if (views.face()->mesh() == FaceView::Mesh::Points) all << tr("the drawing as points");
  if (views.face()->isMoved()) all << tr("the distance and place of the camera");
  return all;
}

}  // namespace

void copyCommand(FaceModel* model, const ViewArea& views) {
  const FaceLook look = {views.coloring()->arrayName(), views.showsCurves()};
  const QString command = renderCommand(*model, *views.face(), look);
  QGuiApplication::clipboard()->setText(command);
  const QStringList missing = leftOut(views);
  const QString rest = missing.isEmpty() ? QString() : tr(" It leaves out: %1.").arg(missing.join(", "));
  emit model->remarked(tr("The mien render command of this face was copied.") + rest, command);
}

}  // namespace mien
