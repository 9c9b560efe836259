#include "StudioStyle.h"

#include <QPainter>
#include <QStyleOptionComboBox>

#include "Icons.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double cornerRadius = 3.5, arrowHalf = 3.5, arrowDepth = 3.5, arrowWidth = 1.5;  // pixels
constexpr int iconGap = 4;                                                                 // pixels, of Fusion
constexpr int fusionDarker = 140;                                                          // per cent
constexpr double ringWidth = 2.0;                                                          // pixels, with the focus

QColor mixedColor(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(a.redF() + share * (b.redF() - a.redF()), a.greenF() + share * (b.greenF() - a.greenF()),
                          a.blueF() + share * (b.blueF() - a.blueF()));
}

/// The frame of a list that shows its choice; its text is drawn by itself.
void drawListFrame(const QStyleOptionComboBox& option, const QRect& arrowArea, QPainter& painter) {
  const bool isEnabled = option.state & QStyle::State_Enabled, hasFocus = option.state & QStyle::State_HasFocus;
  const bool isUnder = isEnabled && (option.state & QStyle::State_MouseOver);
  const QPalette& colors = option.palette;
  const QColor accent = colors.color(QPalette::Highlight), line = Theme::current().edge;
  const double width = hasFocus ? ringWidth : 1.0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(hasFocus  ? mixedColor(accent, colors.color(QPalette::Text), 0.5)
                      : isUnder ? accent
                                : line,
                      width));
  painter.setBrush(colors.color(isEnabled ? QPalette::Base : QPalette::Window));
  const double inset = 0.5 * width;
  painter.drawRoundedRect(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), cornerRadius, cornerRadius);
  const QPointF middle = QRectF(arrowArea).center();
  QPolygonF arrow;
  arrow << middle + QPointF(-arrowHalf, -0.5 * arrowDepth) << middle + QPointF(0.0, 0.5 * arrowDepth)
        << middle + QPointF(arrowHalf, -0.5 * arrowDepth);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.color(isEnabled ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText), arrowWidth,
                      Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(arrow);
  painter.restore();
}

/// Fusion takes the edge of fields and check boxes from the window's colour, by darkening it: in the dark nothing is
/// left to be seen of it.
void setEdge(QPalette& colors) {
  colors.setColor(QPalette::Window, Theme::current().edge.lighter(fusionDarker));
}

}  // namespace

StudioStyle::StudioStyle() : QProxyStyle("Fusion") {}

void StudioStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                     const QWidget* widget) const {
  const auto* list = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (control == CC_ComboBox && list && !list->editable)
    return drawListFrame(*list, subControlRect(control, option, SC_ComboBoxArrow, widget), *painter);
  const auto* number = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
  if (control != CC_SpinBox || !number) return QProxyStyle::drawComplexControl(control, option, painter, widget);
  QStyleOptionSpinBox edged = *number;
  setEdge(edged.palette);
  painter->save();
  painter->setClipRect(number->rect.adjusted(0, 1, 0, 0), Qt::IntersectClip);  // Fusion leaves a dot above the corner
  QProxyStyle::drawComplexControl(control, &edged, painter, widget);
  painter->restore();
}

/// The chosen entry of a list ends in dots where it has no room; Fusion cuts through a letter.
void StudioStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  const auto* list = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  if (element != CE_ComboBoxLabel || !list) return QProxyStyle::drawControl(element, option, painter, widget);
  QStyleOptionComboBox shortened = *list;
  const int icon = list->currentIcon.isNull() ? 0 : list->iconSize.width() + iconGap;
  const int room = subControlRect(CC_ComboBox, list, SC_ComboBoxEditField, widget).width() - 2 - icon;
  shortened.currentText = list->fontMetrics.elidedText(list->currentText, Qt::ElideRight, room);
  QProxyStyle::drawControl(element, &shortened, painter, widget);
}

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
  const auto* box = qstyleoption_cast<const QStyleOptionButton*>(option);
  if (element == PE_IndicatorCheckBox && box) {
    QStyleOptionButton edged = *box;
    setEdge(edged.palette);
    return QProxyStyle::drawPrimitive(element, &edged, painter, widget);
  }
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  if (element != PE_FrameLineEdit || !frame) return QProxyStyle::drawPrimitive(element, option, painter, widget);
  QStyleOptionFrame edged = *frame;
  setEdge(edged.palette);
  QProxyStyle::drawPrimitive(element, &edged, painter, widget);
}

QIcon StudioStyle::standardIcon(StandardPixmap pixmap, const QStyleOption* option, const QWidget* widget) const {
  if (pixmap == SP_TitleBarCloseButton) return icon(Symbol::Close);
  if (pixmap == SP_TitleBarNormalButton) return icon(Symbol::Detach);
  return QProxyStyle::standardIcon(pixmap, option, widget);
}

}  // namespace mien
