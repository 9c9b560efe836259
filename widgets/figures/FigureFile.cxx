#include "FigureFile.h"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QHash>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <algorithm>
#include <cstdlib>

#include "FigureMetadata.h"
#include "FigureTheme.h"
#include "WholeFile.h"

namespace mien {

namespace {

constexpr double unitsPerInch = 25.4 * figureUnitsPerMillimetre;

std::string endingOf(const std::string& name) {
  return QFileInfo(QString::fromStdString(name)).suffix().toLower().toStdString();
}

/// Viewers without the font take one whose letters are as wide, or at least one of the same kind.
void nameOtherFonts(QByteArray& svg) {
  svg.replace("font-family=\"DejaVu Sans\"", "font-family=\"DejaVu Sans, Bitstream Vera Sans, Verdana, sans-serif\"");
  static const QRegularExpression lonely(QStringLiteral("font-family=\"([^\",]+)\""));
  svg = QString::fromUtf8(svg).replace(lonely, QStringLiteral("font-family=\"\\1, sans-serif\"")).toUtf8();
}

/// Qt writes the clock's date. Places in the file must stay where they are, so that the new date is as long.
void setDate(QByteArray& pdf, qint64 secondsSinceEpoch) {
  const QByteArray key = "/CreationDate (D:";
  const int begin = pdf.indexOf(key), end = begin < 0 ? -1 : pdf.indexOf(')', begin);
  if (end < 0) return;
  const QString date = QDateTime::fromSecsSinceEpoch(secondsSinceEpoch, Qt::UTC).toString("yyyyMMddHHmmss");
  pdf.replace(begin, end + 1 - begin, (key + date.toLatin1() + "Z)").leftJustified(end + 1 - begin));
}

void setDateFromEnvironment(QByteArray& pdf) {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  bool valid = false;
  const qint64 seconds = QByteArray(text).toLongLong(&valid);
  if (text && valid && seconds >= 0) setDate(pdf, seconds);
}

/// Qt embeds fonts in the order of a hash with a random seed: without one the same drawing has the same bytes.
class FixedHashSeed {
 public:
#if QT_VERSION < QT_VERSION_CHECK(6, 2, 0)
  FixedHashSeed() {
    qSetGlobalQHashSeed(0);
  }
  ~FixedHashSeed() {
    qSetGlobalQHashSeed(-1);
  }
#else
  FixedHashSeed() {
    QHashSeed::setDeterministicGlobalSeed();
  }
  ~FixedHashSeed() {
    QHashSeed::resetRandomGlobalSeed();
  }
#endif
  FixedHashSeed(const FixedHashSeed&) = delete;
  FixedHashSeed& operator=(const FixedHashSeed&) = delete;
};

void draw(QPaintDevice& device, double scale, const std::function<void(QPainter&)>& content) {
  QPainter painter(&device);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  painter.scale(scale, scale);
  content(painter);
}

constexpr double mostFinePixels = 5e7;
constexpr int fineness = 2;

/// Lines below one pixel are drawn unevenly by Qt, with dots where their segments meet: where there is memory for it
/// the drawing is made twice as fine and reduced.
QImage drawnImage(const QSize& pixels, const QSizeF& size, const std::function<void(QPainter&)>& content) {
  const bool isFine = fineness * fineness * double(pixels.width()) * pixels.height() <= mostFinePixels;
  QImage image(isFine ? fineness * pixels : pixels, QImage::Format_ARGB32_Premultiplied);
  if (image.isNull()) return image;
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.scale(image.width() / size.width(), image.height() / size.height());
  content(painter);
  painter.end();
  return isFine ? image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : image;
}

}  // namespace

const std::vector<std::string>& FigureFile::endings() {
  static const std::vector<std::string> endings = {"svg", "pdf", "png"};
  return endings;
}

std::string FigureFile::describeFault(const QSizeF& size) const {
  const std::string ending = endingOf(name_);
  if (std::find(endings().begin(), endings().end(), ending) == endings().end())
    return name_ + ": a figure is written as .svg, .pdf or .png; give the file one of these endings";
  if (!size.isValid() || size.isEmpty()) return name_ + ": the figure has no size";
  if (!(dotsPerInch_ >= leastDotsPerInch && dotsPerInch_ <= mostDotsPerInch))
    return "dots per inch are outside 30 .. 2400; choose 300 for print";
  const double pixels = size.width() * size.height() * dotsPerInch_ * dotsPerInch_ / (unitsPerInch * unitsPerInch);
  if (ending == "png" && pixels > mostPixels)
    return name_ + ": the picture would have too many pixels; choose fewer dots per inch";
  return {};
}

std::string FigureFile::write(const QSizeF& size, const Draw& draw) const {
  const std::string fault = describeFault(size);
  if (!fault.empty()) return fault;
  const std::string ending = endingOf(name_);
  const QByteArray bytes = ending == "svg"   ? drawnSVG(size, draw)
                           : ending == "pdf" ? drawnPDF(size, draw)
                                             : drawnPNG(size, draw);
  if (bytes.isEmpty()) return name_ + ": there is no memory for the figure; choose fewer dots per inch";
  const std::string unwritten = WholeFile::write(name_, bytes.toStdString());
  return unwritten.empty() ? unwritten : name_ + ": " + unwritten;
}

QByteArray FigureFile::drawnSVG(const QSizeF& size, const Draw& content) const {
  QBuffer buffer;
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setResolution(qRound(unitsPerInch));
  svg.setSize(size.toSize());
  svg.setViewBox(QRectF(QPointF(), size));
  svg.setTitle(QString::fromStdString(title_).toHtmlEscaped());  // Qt writes them as they are
  svg.setDescription(QString::fromStdString(description_).toHtmlEscaped());
  draw(svg, 1.0, content);
  QByteArray bytes = buffer.data();
  nameOtherFonts(bytes);
  return bytes;
}

QByteArray FigureFile::drawnPDF(const QSizeF& size, const Draw& content) const {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const FixedHashSeed seed;
  {
    QPdfWriter pdf(&buffer);
    pdf.setResolution(qRound(unitsPerInch));
    pdf.setPageSize(
        QPageSize(size / figureUnitsPerMillimetre, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
    pdf.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
    pdf.setTitle(QString::fromStdString(title_));
    pdf.setCreator(QStringLiteral("Mien"));
    pdf.setDocumentXmpMetadata(FigureMetadata{title_, description_}.xmp());
    draw(pdf, 1.0, content);
  }
  QByteArray bytes = buffer.data();
  setDateFromEnvironment(bytes);
  return bytes;
}

QByteArray FigureFile::drawnPNG(const QSizeF& size, const Draw& content) const {
  const QSize pixels = (size * (dotsPerInch_ / unitsPerInch)).toSize();
  QImage image = drawnImage(pixels, size, content);
  if (image.isNull()) return {};
  image.setDotsPerMeterX(qRound(dotsPerInch_ / 0.0254));
  image.setDotsPerMeterY(qRound(dotsPerInch_ / 0.0254));
  image.setText("Title", FigureMetadata::oneLine(title_));
  image.setText("Description", FigureMetadata::oneLine(description_));
  image.setText("Software", "Mien");
  QBuffer buffer;
  return image.save(&buffer, "PNG") ? buffer.data() : QByteArray();
}

}  // namespace mien
