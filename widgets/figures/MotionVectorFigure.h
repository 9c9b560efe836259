#pragma once

#include <QSizeF>
#include <optional>
#include <string>
#include <vector>

#include "FigureWords.h"
#include "MotionField.h"
#include "MotionVectorOptions.h"
#include "VectorKeyPainter.h"
#include "VectorPanelPainter.h"
#include "VectorStyle.h"

class QPainter;

namespace mien {

/// One field of a figure.
struct MotionVectorPanel {
  MotionField field;
  std::string heading;  ///< above it, such as "frame 100"; may be empty
};

/// Motion vector fields side by side with one scale of arrows and one range of colours for all: the face's outline and
/// its seams, arrows, a reference arrow, a colour bar.
///
/// Everything is in hundredths of a millimetre, to be painted on paper or on a widget; type keeps its size. Needs a
/// FigureApplication, for its fonts. A panel in which nothing moves has no arrows and says so.
class MotionVectorFigure {
 public:
  MotionVectorFigure(const std::vector<MotionVectorPanel>& panels, const MotionVectorOptions& options);

  /// One of several panels alone, with scale, range and size of the face as if all were shown: one file of a series.
  MotionVectorFigure(const std::vector<MotionVectorPanel>& panels, size_t only, const MotionVectorOptions& options);

  /// Width and height in figure units.
  const QSizeF& size() const { return size_; }

  void paint(QPainter& painter) const;

  double scale() const { return style_.scale; }  ///< mm of motion per mm of arrow
  /// The scale that would be chosen for vectors of this length (mm) in the same figure.
  double scaleFor(double longest) const;
  double rangeBegin() const { return style_.rangeBegin; }
  double rangeEnd() const { return style_.rangeEnd; }
  double reference() const { return reference_; }  ///< motion of the reference arrow, mm; 0: there is none

  /// Whether the colours tell motion towards the viewer, of which there is none: the key says so instead of a range.
  bool lacksTowards() const { return style_.lacksTowards; }

  /// Least range of motion towards the viewer over the longest vector.
  static constexpr double leastTowards = 0.1;

  /// Which vectors have arrows; never automatic.
  const VectorSampling& sampling() const { return options_.picture.sampling; }

  /// Where the key stands, figure units; empty: there is none.
  QRectF keyPlace() const { return key_ ? QRectF(QPointF(keyLeft_, keyTop_), key_->size()) : QRectF(); }

  static constexpr double keyBesideRoom = 38.0;  ///< mm, that a key beside the panels takes of their width

  /// The panels in their places: what each shows, and the face under a pointer.
  const std::vector<VectorPanelPainter>& panels() const { return panels_; }

 private:
  void prepare(const std::vector<MotionVectorPanel>& panels, int shown);
  void addPicture(const MotionField& field);
  void leaveOutRipple();
  void chooseRange();
  void chooseScale(double room);
  void chooseReference();
  void layOut();
  double drawnWidth(double cellWidth, double height) const;
  double placePanels(double top, const QSizeF& free, int columns);
  double faceScaleWithin(const QSizeF& cell);
  VectorPanelPainter::Margins overhang(double faceScale) const;
  void addKey();
  double panelsWidth() const;
  int columnCount(int panels) const;
  double cellWidth(int columns) const;
  double headingHeight() const;

  MotionVectorOptions options_;
  VectorStyle style_;
  std::vector<VectorPicture> all_;  ///< of the series, whether shown or not
  std::vector<VectorPanelPainter> panels_;
  std::vector<QPointF> headingPlaces_;
  std::optional<VectorKeyPainter> key_;
  std::optional<FigureWords> words_;
  Eigen::AlignedBox2d frame_;
  QSizeF size_;
  double inner_;          ///< width without the border
  double longest_ = 0.0;  ///< of all arrows, as their length is measured, mm
  double reference_ = 0.0;
  std::pair<bool, bool> beyond_ = {false, false};
  double arrowRoom_ = 0.0;  ///< figure units
  double keyLeft_ = 0.0, keyTop_ = 0.0, wordsTop_ = 0.0;
};

}  // namespace mien
