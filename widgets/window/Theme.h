#pragma once

#include <QColor>

class QApplication;

namespace mien {

/// The colours of the application in one place: widgets take theirs from the palette and the style sheet, the
/// three-dimensional views from here.
struct Theme {
  enum class Kind { Light, Dark };

  Kind kind;
  QColor window, panel, text, faintText, line, accent, accentText, error, warning;
  QColor edge;                      ///< around check boxes, lists and fields, and the handles of scroll bars
  QColor viewTop, viewBottom;       ///< background of a view, from top to bottom
  QColor skin, skinInside, mesh;    ///< the face from outside and inside, and its mesh lines
  QColor meshAlone;                 ///< the same lines with no skin behind them
  QColor curve, curveMoved, ghost;  ///< boundary curves at rest, moved by 10 mm, and where they were

  static const Theme& of(Kind kind);

  /// The one that was applied last; light before that.
  static const Theme& current();

  /// The one that the user chose last; else the one that is nearer to the desktop's colours.
  static Kind preferred(const QApplication& application);

  /// Applies it, and remembers it for the next start.
  static void choose(Kind kind, QApplication& application);

  /// Gives the application this theme's style, palette and style sheet.
  static void apply(Kind kind, QApplication& application);
};

/// Theme::current() is another one as long as this lives, for pictures that are not of the screen. It must outlive
/// this.
class BorrowedTheme {
 public:
  explicit BorrowedTheme(const Theme& theme);
  ~BorrowedTheme();
  BorrowedTheme(const BorrowedTheme&) = delete;
  BorrowedTheme& operator=(const BorrowedTheme&) = delete;

 private:
  const Theme* before_;
};

}  // namespace mien
