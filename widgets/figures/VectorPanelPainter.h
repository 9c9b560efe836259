#pragma once

#include <QRectF>
#include <QString>

#include "VectorPicture.h"
#include "VectorStyle.h"

class QPainter;

namespace mien {

/// Draws one motion field into a cell of a figure: heading, outline, seams, arrows.
///
/// Layout goes in two steps, so that the panels of a figure share one frame and one size of the face: ask how far
/// arrows reach beyond the frame, then place.
class VectorPanelPainter {
 public:
  struct Margins {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  };

  VectorPanelPainter(const VectorPicture& picture, const QString& heading) : picture_(picture), heading_(heading) {}

  /// How far arrows reach beyond the frame, in figure units, when a mm of the face is that many figure units.
  Margins overhang(const VectorStyle& style, const Eigen::AlignedBox2d& frame, double faceScale) const;

  /// @param topLeft  of the frame, below heading and margin
  void place(const QPointF& topLeft, const Eigen::AlignedBox2d& frame, double faceScale);

  double headingHeight(const VectorStyle& style) const;

  /// @param headingPlace  upper left corner of the heading
  void paint(QPainter& painter, const VectorStyle& style, const QPointF& headingPlace) const;

  /// The frame in the figure, once placed.
  QRectF plot() const;

  /// From mm on the face, right and up in the picture, to the figure, and back.
  QPointF toFigure(const Eigen::Vector2d& place) const;
  Eigen::Vector2d toFace(const QPointF& place) const;

  const VectorPicture& picture() const { return picture_; }

 private:
  void paintLines(QPainter& painter, const std::vector<VectorPicture::Line>& lines) const;
  void paintArrows(QPainter& painter, const VectorStyle& style) const;
  void paintArrow(QPainter& painter, const VectorStyle& style, const PictureArrow& arrow) const;
  void paintRemark(QPainter& painter, const VectorStyle& style) const;

  VectorPicture picture_;
  QString heading_;
  Eigen::AlignedBox2d frame_;
  QPointF topLeft_;
  double faceScale_ = 1.0;
};

}  // namespace mien
