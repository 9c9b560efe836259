#pragma once

#include <QPoint>
#include <QtGlobal>

struct _XDisplay;

/// The window of another program on the test's display, under the hands of its user.
class OtherWindow {
 public:
  explicit OtherWindow(qint64 process);
  ~OtherWindow();

  bool isVisible();  ///< looked for again while it is not

  void click(const QPoint& place);  ///< from the window's upper left corner
  void pressAlt(char letter);

 private:
  bool isSought(unsigned long window) const;

  qint64 process_;
  _XDisplay* display_;
  unsigned long window_ = 0;
};
