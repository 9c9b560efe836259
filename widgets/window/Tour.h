#pragma once

#include <QPointer>
#include <QRect>
#include <QString>
#include <QWidget>
#include <vector>

class QMainWindow;

namespace mien {

/// One screen over a window that says what its main parts are for, one after the other: the part that is spoken of is
/// seen as it is, the rest through a veil, and the text stands beside it. A click, Space or Right goes on, Left goes
/// back, Esc ends it.
class Tour : public QWidget {
  Q_OBJECT
 public:
  static Tour* begin(QMainWindow& window);

  /// Shows it once for a user; never in a program that remembers nothing, such as a test.
  static void showAtFirstStart(QMainWindow& window);

  int stopCount() const { return static_cast<int>(stops_.size()); }
  int current() const { return current_; }  ///< from 0
  void step(int by);                        ///< to the next part that is seen; beyond the last it ends

  /// Where the text of a stop stands, in pixels; empty for one whose part of the window is not to be seen.
  QRect calloutOf(int stop) const;
  QRect targetOf(int stop) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Stop {
    QPointer<QWidget> target;
    QString title, text;
  };
  explicit Tour(QMainWindow& window);
  void add(const QString& name, const QString& title, const QString& text);
  QString hint(int stop) const;
  QSize sizeOfText(int stop, int width) const;
  std::vector<QRect> placesBeside(const QRect& target, const QSize& size) const;
  void paintText(QPainter& painter, int stop) const;

  QMainWindow& window_;
  std::vector<Stop> stops_;
  int current_ = 0;
};

}  // namespace mien
