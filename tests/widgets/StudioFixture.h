#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QString>
#include <QTest>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>

#include "StudioWindow.h"

class vtkPolyData;

/// A Studio window on the test's display; an unexpected VTK error or warning fails the test.
///
/// Its two views are drawn only when a test takes their picture, since without a graphics card drawing them is most of
/// the time; drawViews() has them drawn as on a user's screen.
class StudioFixture : public testing::Test {
 protected:
  StudioFixture();
  ~StudioFixture() override;
  void TearDown() override;

  /// The widget of that object name; the test ends when there is none.
  template <class Widget>
  Widget* find(const QString& name) {
    auto* widget = window->findChild<Widget*>(name);
    if (!widget) throw std::runtime_error("there is no widget named " + name.toStdString());
    return widget;
  }

  void settle();  ///< lets changes reach the pipeline and the screen
  void drawViews();
  bool waitUntil(const std::function<bool()>& condition, int milliseconds = 20000);

  /// Where a point of the curves is, in mm, to see whether it moves.
  double largestDisplacement();
  double largestMovement();  ///< the same, of the last update, without drawing
  vtkPolyData* surface();

  /// With the left button down. QTest::mouseMove cannot do that: it moves the pointer of the display, whose own events
  /// arrive when the server pleases, after the release on a busy computer.
  void dragTo(QWidget* widget, const QPoint& position);
  /// Presses, moves in four steps and releases.
  void drag(QWidget* widget, const QPoint& from, const QPoint& by);

  int colorsIn(const QString& viewName);  ///< how many different colours a view shows; a blank one few
  QString message();                      ///< what the message bar shows; empty when it is hidden

  /// A .fap of frames that close the left lid further and further, by 20 units a frame.
  QString writeLids(int frames, double framesPerSecond);

  std::unique_ptr<mien::StudioWindow> window;
};
