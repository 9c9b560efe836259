#include "Exporter.h"

#include <QFileInfo>
#include <QRegularExpression>

#include "FaceModel.h"
#include "FaceStateText.h"
#include "FigureFile.h"
#include "WholeFile.h"

namespace mien {

namespace {

constexpr int longestName = 60;  // characters of a name that is suggested

}  // namespace

Exporter::Exporter(FaceModel* model, Drawing drawing, std::function<std::string()> numbers, QObject* parent)
    : QObject(parent), model_(model), drawing_(std::move(drawing)), numbers_(std::move(numbers)) {}

QString Exporter::suggestedName(const QString& ending) const {
  QString name = QString::fromStdString(drawing_({}).title).toLower();
  name.replace(QRegularExpression("[^\\w.=-]+"), "_");
  name = name.left(longestName);
  return name.isEmpty() ? QString() : name + '.' + ending;
}

std::string Exporter::writeFigure(const std::string& fileName, const ExportOptions& options) const {
  const ExportDrawing drawing = drawing_(options);
  if (!drawing.paint) return fileName + ": there is no figure yet to write; wait until it is shown";
  FigureFile file(fileName);
  file.setDotsPerInch(options.dotsPerInch);
  file.setTitle(drawing.title);
  file.setDescription(writeFaceState(model_->lastingState()) + drawing.description);
  return file.write(drawing.size, drawing.paint);
}

std::string Exporter::writeNumbers(const QString& fileName) const {
  const std::string text = numbers_();
  if (text.empty()) return fileName.toStdString() + ": there are no numbers yet to write; wait until they are shown";
  const std::string fault = WholeFile::write(fileName.toStdString(), text);
  return fault.empty() ? fault : fileName.toStdString() + ": " + fault;
}

bool Exporter::write(const QString& fileName, const ExportOptions& options) const {
  const bool numbers = fileName.endsWith(".csv", Qt::CaseInsensitive);
  const std::string fault = numbers ? writeNumbers(fileName) : writeFigure(fileName.toStdString(), options);
  if (fault.empty())
    emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  else
    emit model_->failed(QString::fromStdString(fault), QString());
  return fault.empty();
}

}  // namespace mien
