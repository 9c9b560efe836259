#include "ExportButton.h"

#include "ExportDialog.h"

namespace mien {

ExportButton::ExportButton(const QString& objectName, FaceModel* model, Exporter::Drawing drawing,
                           std::function<std::string()> numbers, QWidget* parent)
    : QToolButton(parent), exporter_(new Exporter(model, std::move(drawing), std::move(numbers), this)) {
  setObjectName(objectName);
  setText(tr("Export..."));
  setToolTip(tr("Write this figure (SVG, PDF, PNG; width in mm, dots per inch) or its numbers (CSV)"));
  setFocusPolicy(Qt::TabFocus);
  connect(this, &QToolButton::clicked, this, [this] { ExportDialog::ask(exporter_, window()); });
}

}  // namespace mien
