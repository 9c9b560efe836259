#include "ExportDialog.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "Exporter.h"
#include "FigureFile.h"
#include "FileDialog.h"
#include "Remembered.h"
#include "SessionPart.h"
#include "SignedBox.h"

namespace mien {

namespace {

constexpr int previewWidth = 440, previewHeight = 340, checker = 8, delay = 120;  // pixels, pixels, ms
constexpr double leastPrintedWidth = 40.0, mostWidth = 500.0;                     // mm
constexpr const char *formatKey = "export/format", *themeKey = "export/theme", *dotsKey = "export/dotsPerInch",
                     *transparentKey = "export/transparent";

struct Format {
  const char *ending, *text, *description;
};
constexpr Format formats[] = {{"svg", "SVG", "Scalable vector graphics"},
                              {"pdf", "PDF", "Portable document"},
                              {"png", "PNG", "Picture"},
                              {"csv", "CSV", "Numbers, separated by commas"}};

QSize pixelsOf(const QSizeF& size, double dotsPerInch) {
  return (size / figureUnitsPerMillimetre / 25.4 * dotsPerInch).toSize();
}

/// What shows where there is no background.
void paintChecker(QPainter& painter, const QSize& size) {
  painter.fillRect(QRect(QPoint(), size), Qt::white);
  for (int y = 0; y < size.height(); y += checker)
    for (int x = (y / checker % 2) * checker; x < size.width(); x += 2 * checker)
      painter.fillRect(x, y, checker, checker, QColor(222, 222, 222));
}

QImage paint(const ExportDrawing& drawing, const QSize& size, bool onChecker) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  if (onChecker) paintChecker(painter, size);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.scale(size.width() / drawing.size.width(), size.height() / drawing.size.height());
  drawing.paint(painter);
  return image;
}

}  // namespace

ExportDialog::ExportDialog(Exporter* exporter, QWidget* parent)
    : QDialog(parent),
      exporter_(exporter),
      format_(new QComboBox(this)),
      theme_(new QComboBox(this)),
      width_(new SignedNumberBox(this)),
      dots_(new SignedNumberBox(this)),
      transparent_(new QCheckBox(tr("&Transparent background"), this)),
      preview_(new QLabel(this)),
      size_(new QLabel(this)),
      later_(new QTimer(this)) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export"));
  buildControls();
  auto* form = new QFormLayout;
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&Width"), width_);
  form->addRow(tr("&Resolution"), dots_);
  form->addRow(tr("&Colours"), theme_);
  form->addRow(QString(), transparent_);
  form->addRow(tr("Size"), size_);
  auto* upper = new QHBoxLayout;
  upper->addLayout(form);
  upper->addWidget(preview_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(upper, 1);
  column->addWidget(buttons());
  follow();
  showPreview();
}

void ExportDialog::ask(Exporter* exporter, QWidget* parent) {
  auto* dialog = new ExportDialog(exporter, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void ExportDialog::buildControls() {
  for (const Format& format : formats) format_->addItem(format.text, format.ending);
  format_->setObjectName("exportFormat");
  format_->setCurrentIndex(std::max(0, format_->findData(Remembered::value(formatKey, "svg").toString())));
  format_->setToolTip(tr("SVG and PDF hold lines and true text, PNG a picture, CSV the numbers"));
  for (const FigureTheme& theme : FigureTheme::all()) theme_->addItem(QString::fromStdString(theme.name));
  theme_->setObjectName("exportTheme");
  theme_->setCurrentText(Remembered::value(themeKey, "light").toString());
  theme_->setToolTip(tr("Colours for a light page, a dark one, or for print"));
  width_->setObjectName("exportWidth");
  width_->setRange(leastPrintedWidth, mostWidth);
  width_->setSuffix(tr(" mm"));
  width_->setDecimals(0);
  width_->setToolTip(tr("Width of the figure in mm; text keeps its size. 85 mm is a column, 170 mm a page of A4"));
  const double usual = exporter_->drawing({}).size.width() / figureUnitsPerMillimetre;
  width_->setValue(usual > 0.0 ? usual : ExportDrawing::pageWidth);
  dots_->setObjectName("exportDots");
  dots_->setRange(FigureFile::leastDotsPerInch, FigureFile::mostDotsPerInch);
  dots_->setDecimals(0);
  dots_->setSuffix(tr(" dpi"));
  dots_->setValue(Remembered::value(dotsKey, 300.0).toDouble());
  dots_->setToolTip(tr("Dots per inch of a PNG file, and of pictures of the face within the others; 300 for print"));
  transparent_->setObjectName("exportTransparent");
  transparent_->setChecked(Remembered::value(transparentKey, false).toBool());
  transparent_->setToolTip(tr("The page shows through, instead of the colours' own background"));
  preview_->setObjectName("exportPreview");
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setMinimumSize(previewWidth, previewHeight);
  size_->setObjectName("exportSize");
  size_->setProperty("faint", true);
  later_->setSingleShot(true);
  later_->setInterval(delay);
  connect(later_, &QTimer::timeout, this, &ExportDialog::showPreview);
  for (QComboBox* list : {format_, theme_})
    connect(list, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::follow);
  for (QDoubleSpinBox* number : {width_, dots_})
    connect(number, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &ExportDialog::follow);
  connect(transparent_, &QCheckBox::toggled, this, &ExportDialog::follow);
  for (QWidget* widget : std::initializer_list<QWidget*>{format_, theme_, width_, dots_, transparent_})
    widget->setProperty(notInSession, true);
}

QWidget* ExportDialog::buttons() {
  auto* box = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* save = box->addButton(tr("&Save as..."), QDialogButtonBox::AcceptRole);
  QPushButton* copied = box->addButton(tr("Copy &picture"), QDialogButtonBox::ActionRole);
  save->setObjectName("exportSave");
  save->setDefault(true);
  copied->setObjectName("exportCopy");
  copied->setToolTip(tr("Takes the figure to the clipboard as a picture of this resolution"));
  connect(save, &QPushButton::clicked, this, &ExportDialog::chooseFile);
  connect(copied, &QPushButton::clicked, this, &ExportDialog::copy);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return box;
}

ExportOptions ExportDialog::options() const {
  ExportOptions options;
  options.width = width_->value();
  options.dotsPerInch = dots_->value();
  options.theme = theme_->currentText().toStdString();
  options.transparent = transparent_->isChecked();
  return options;
}

QString ExportDialog::ending() const {
  return format_->currentData().toString();
}

void ExportDialog::follow() {
  const bool drawn = ending() != "csv";
  for (QWidget* widget : std::initializer_list<QWidget*>{theme_, width_, dots_, transparent_})
    widget->setEnabled(drawn);
  later_->start();
}

void ExportDialog::showPreview() {
  const ExportDrawing drawing = exporter_->drawing(options());
  if (!drawing.paint) {
    preview_->setText(tr("There is nothing to draw yet."));
    return size_->clear();
  }
  const QSize pixels = pixelsOf(drawing.size, dots_->value());
  const QSizeF millimetres = drawing.size / figureUnitsPerMillimetre;
  size_->setText(tr("%1 \u00d7 %2 mm\n%3 \u00d7 %4 pixels")
                     .arg(millimetres.width(), 0, 'f', 0)
                     .arg(millimetres.height(), 0, 'f', 0)
                     .arg(pixels.width())
                     .arg(pixels.height()));
  const double ratio = devicePixelRatioF();
  const QSize room = drawing.size.scaled(QSizeF(preview_->size()) * ratio, Qt::KeepAspectRatio).toSize();
  QPixmap picture = QPixmap::fromImage(paint(drawing, room, true));
  picture.setDevicePixelRatio(ratio);
  preview_->setPixmap(picture);
}

void ExportDialog::chooseFile() {
  const Format& format = formats[format_->currentIndex()];
  const QString name = FileDialog::save(this, tr("Export"), exporter_->suggestedName(ending()),
                                        QString("%1 (*.%2)").arg(tr(format.description), ending()), '.' + ending());
  if (!name.isEmpty()) save(name);
}

bool ExportDialog::save(const QString& fileName) {
  remember();
  const bool written = exporter_->write(fileName, options());
  if (written) accept();
  return written;
}

void ExportDialog::copy() {
  const ExportDrawing drawing = exporter_->drawing(options());
  if (!drawing.paint) return;
  QGuiApplication::clipboard()->setImage(paint(drawing, pixelsOf(drawing.size, dots_->value()), false));
  remember();
}

void ExportDialog::remember() const {
  Remembered::set(formatKey, ending());
  Remembered::set(themeKey, theme_->currentText());
  Remembered::set(dotsKey, dots_->value());
  Remembered::set(transparentKey, transparent_->isChecked());
}

}  // namespace mien
