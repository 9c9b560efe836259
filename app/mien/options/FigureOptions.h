#pragma once

#include <QSizeF>
#include <functional>
#include <string>

namespace CLI {
class App;
}

class QPainter;

namespace mien {

/// The options of drawn figures, the same for all commands that make one: --width, --theme, --font,
/// --dpi.
class FigureOptions {
 public:
  /// @param width  of the figure when none is given, mm
  explicit FigureOptions(const std::string& width) : width_(width) {}

  void addTo(CLI::App& command, const std::string& group);

  /// Before anything is computed: throws a ValueFailure for a wrong value. Figures have the font from then on.
  void check() const;

  double width() const;  ///< mm
  double dotsPerInch() const;
  const std::string& theme() const { return theme_; }

  /// Whether the file's ending is that of a figure.
  static bool isFigure(const std::string& name);

  /// Title and description are kept in the file. Throws a FileFailure when it cannot be written.
  void write(const std::string& name, const QSizeF& size, const std::function<void(QPainter&)>& draw,
             const std::string& title, const std::string& description) const;

 private:
  std::string width_, theme_ = "light", font_, dotsPerInch_ = "300";
};

/// Throws a ValueFailure when an option's value is outside the whole numbers least .. most.
void requireRange(const std::string& option, double value, double least, double most, const std::string& unit = {});

}  // namespace mien
