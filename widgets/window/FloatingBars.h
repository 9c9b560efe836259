#pragma once

#include <QList>
#include <QObject>

class QWidget;

namespace mien {

class RenderView;

/// Bars that float over the foot of a view: nothing below or beside them moves when they come and go. The first is the
/// lowest. Whoever owns them shows and hides them.
class FloatingBars : public QObject {
  Q_OBJECT
 public:
  /// @param area  across which they lie, in the middle of it
  /// @param views  they stand on the lower edge of the one that ends highest of those seen, above its key
  /// @param bars  become children of `parent`, above all that lies in it
  FloatingBars(QWidget* area, const QList<RenderView*>& views, const QList<QWidget*>& bars, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QWidget *area_, *parent_;
  QList<RenderView*> views_;
  QList<QWidget*> bars_;
};

}  // namespace mien
