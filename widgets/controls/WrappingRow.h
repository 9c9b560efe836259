#pragma once

#include <QLayout>
#include <vector>

namespace mien {

/// Controls in a row, which goes on in the next line where there is no room: nothing is cut off however narrow it gets.
/// What is left of a line goes to its items that expand, such as a title or a spacer.
class WrappingRow : public QLayout {
  Q_OBJECT
 public:
  explicit WrappingRow(QWidget* parent = nullptr);
  ~WrappingRow() override;

  void addSpacing(int pixels);  ///< not seen where a line begins or ends with it
  void addStretch();

  /// Rows side by side can be of one height: that of the one with the most lines.
  void setLeastHeight(int pixels);
  int ownHeight(int width) const;  ///< of all lines at that width

  void addItem(QLayoutItem* item) override;
  int count() const override;
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  void setGeometry(const QRect& rect) override;

 private:
  using Line = std::vector<QLayoutItem*>;
  std::vector<Line> lines(int width) const;
  void place(const Line& line, const QRect& rect) const;
  int widthOf(const Line& line) const;

  QList<QLayoutItem*> items_;
  int leastHeight_ = 0;
};

}  // namespace mien
