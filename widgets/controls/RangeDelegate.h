#pragma once

#include <QStyledItemDelegate>

namespace mien {

/// A cell with a number, and below it a small scale: the range mean +- sd, and where the number lies.
class RangeDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// Data of a cell: the place of the number from the mean, in standard deviations; invalid: no scale.
  static constexpr int placeRole = Qt::UserRole;
  static constexpr int outsideRole = Qt::UserRole + 1;  ///< bool: number and place stand out

  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace mien
