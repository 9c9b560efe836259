#include "ExportButton.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QRegularExpression>
#include <QSaveFile>

#include "FaceModel.h"
#include "FaceStateText.h"
#include "FigureFile.h"

namespace mien {

namespace {

constexpr int longestName = 60;  // characters of a name that is suggested

}  // namespace

ExportButton::ExportButton(const QString& objectName, FaceModel* model, std::function<ExportDrawing()> figure,
                           std::function<std::string()> numbers, QWidget* parent)
    : QToolButton(parent), model_(model), figure_(std::move(figure)), numbers_(std::move(numbers)) {
  setObjectName(objectName);
  setText(tr("Export"));
  setToolTip(tr("Write this figure (SVG, PDF, PNG) or its numbers (CSV)"));
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(this);
  const auto add = [&](const QString& ending, const QString& text, const QString& description) {
    menu->addAction(text, this, [this, ending, description] { ask(ending, description); })
        ->setObjectName(objectName + ending.toUpper());
  };
  add("svg", tr("&SVG..."), tr("Scalable vector graphics"));
  add("pdf", tr("&PDF..."), tr("Portable document"));
  add("png", tr("P&NG..."), tr("Picture of 300 dots per inch"));
  add("csv", tr("&CSV..."), tr("Numbers, separated by commas"));
  setMenu(menu);
}

void ExportButton::ask(const QString& ending, const QString& description) {
  QString name = QFileDialog::getSaveFileName(window(), tr("Export"), suggestedName(ending),
                                              QString("%1 (*.%2)").arg(description, ending));
  if (name.isEmpty()) return;
  if (QFileInfo(name).suffix().isEmpty()) name += '.' + ending;
  write(name);
}

QString ExportButton::suggestedName(const QString& ending) const {
  QString name = QString::fromStdString(figure_().title).toLower();
  name.replace(QRegularExpression("[^\\w.=-]+"), "_");
  name = name.left(longestName);
  return name.isEmpty() ? QString() : name + '.' + ending;
}

std::string ExportButton::writeFigure(const std::string& fileName) const {
  const ExportDrawing drawing = figure_();
  if (!drawing.paint) return fileName + ": there is no figure yet to write; wait until it is shown";
  FigureFile file(fileName);
  file.setTitle(drawing.title);
  file.setDescription(writeFaceState(model_->lastingState()) + drawing.description);
  return file.write(drawing.size, drawing.paint);
}

std::string ExportButton::writeNumbers(const QString& fileName) const {
  const std::string text = numbers_();
  if (text.empty()) return fileName.toStdString() + ": there are no numbers yet to write; wait until they are shown";
  QSaveFile file(fileName);
  const bool written =
      file.open(QIODevice::WriteOnly) && file.write(text.data(), text.size()) == qint64(text.size()) && file.commit();
  return written ? std::string() : fileName.toStdString() + ": cannot be written: " + file.errorString().toStdString();
}

bool ExportButton::write(const QString& fileName) {
  const bool numbers = fileName.endsWith(".csv", Qt::CaseInsensitive);
  const std::string fault = numbers ? writeNumbers(fileName) : writeFigure(fileName.toStdString());
  if (fault.empty())
    emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  else
    emit model_->failed(QString::fromStdString(fault), QString());
  return fault.empty();
}

}  // namespace mien
