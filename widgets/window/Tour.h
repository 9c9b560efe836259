#pragma once

#include <QPointer>
#include <QRect>
#include <QString>
#include <QWidget>
#include <vector>

class QMainWindow;

namespace mien {

/// One screen over a window that says what its main parts are for. Any key or click ends it.
class Tour : public QWidget {
  Q_OBJECT
 public:
  static Tour* begin(QMainWindow& window);

  /// Shows it once for a user; never in a program that remembers nothing, such as a test.
  static void showAtFirstStart(QMainWindow& window);

  int stopCount() const { return static_cast<int>(stops_.size()); }

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
  int textHeight(const Stop& stop, int width) const;
  void paintStop(QPainter& painter, int stop) const;
  void paintHint(QPainter& painter) const;

  QMainWindow& window_;
  std::vector<Stop> stops_;
};

}  // namespace mien
