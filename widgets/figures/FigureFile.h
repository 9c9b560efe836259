#pragma once

#include <QByteArray>
#include <QSizeF>
#include <functional>
#include <string>
#include <vector>

class QPainter;

namespace mien {

/// Writes drawings as .svg, .pdf or .png: vectors with true text, fonts embedded in PDF.
///
/// A drawing is in hundredths of a millimetre. The file appears under its name when it is complete. The same drawing
/// makes the same bytes; the date inside PDF files is that of the environment variable SOURCE_DATE_EPOCH when it is
/// set.
class FigureFile {
 public:
  static constexpr double leastDotsPerInch = 30.0, mostDotsPerInch = 2400.0;
  static constexpr double mostPixels = 2.5e8;  ///< 1 GB

  /// "svg", "pdf", "png".
  static const std::vector<std::string>& endings();

  explicit FigureFile(const std::string& name) : name_(name) {}

  /// Of .png files. Default: 300.
  void setDotsPerInch(double dotsPerInch) { dotsPerInch_ = dotsPerInch; }

  /// Kept in the file: what it shows, and the command or parameters that made it.
  void setTitle(const std::string& title) { title_ = title; }
  void setDescription(const std::string& description) { description_ = description; }

  /// Calls `draw` once. @return what went wrong in one sentence, or nothing.
  std::string write(const QSizeF& size, const std::function<void(QPainter&)>& draw) const;

 private:
  using Draw = std::function<void(QPainter&)>;
  std::string describeFault(const QSizeF& size) const;
  QByteArray drawnSVG(const QSizeF& size, const Draw& draw) const;
  QByteArray drawnPDF(const QSizeF& size, const Draw& draw) const;
  QByteArray drawnPNG(const QSizeF& size, const Draw& draw) const;

  std::string name_, title_, description_;
  double dotsPerInch_ = 300.0;
};

}  // namespace mien
