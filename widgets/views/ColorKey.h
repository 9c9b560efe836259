#pragma once

#include <QVector>
#include <QWidget>

#include "ColorLegend.h"

namespace mien {

/// What the colours of a view mean, in a strip below it: a bar with its title, unit and numbers, the nine patches by
/// name, or a scan and the face. Hidden while the colours mean nothing.
class ColorKey : public QWidget {
  Q_OBJECT
 public:
  explicit ColorKey(QWidget* parent = nullptr);

  void showScale(const ColorLegend::Scale& scale);
  void showPatches();
  void showScan(const QColor& scan);  ///< the colours of two skins; that of the scan with its opacity
  /// Words in the place of a scale that the view beside has: why this one has none.
  void showWords(const QString& words);
  void clear();

  bool isOfScan() const { return shown_ == Shown::Skins; }
  QString shownTitle() const;  ///< of a scale, as far as there is room for it

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintScale(QPainter& painter) const;
  int paintUnknown(QPainter& painter, int most) const;
  int halfWidth(double number) const;
  int behindBar() const;
  int roomForWords() const;
  void paintPatches(QPainter& painter) const;
  void paintSkins(QPainter& painter) const;
  void paintSwatch(QPainter& painter, double left, const QColor& color, const QString& text,
                   double room = 1000.0) const;
  void paintWords(QPainter& painter) const;

  enum class Shown { Nothing, Scale, Patches, Skins, Words } shown_ = Shown::Nothing;
  ColorLegend::Scale scale_;
  QString words_;
  QColor scan_;
};

}  // namespace mien
