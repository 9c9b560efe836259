#pragma once

#include <QWidget>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace mien {

class FAPRow;

/// All FAPs of one feature below each other, with a heading; those that this face has no surface for are named below.
/// The heading and the names are fapHeading8 and fapWithoutSurface8 for group 8.
class FAPSection : public QWidget {
  Q_OBJECT
 public:
  FAPSection(int group, QWidget* parent = nullptr);

  int group() const { return group_; }

  /// Takes these rows in place of those it had, in their order.
  void take(const std::vector<FAPRow*>& rows);

  /// Shows only FAPs that these words name; all when there are none. @return how many are left
  int filter(const QString& words);

 private:
  void nameMissing();

  int group_;
  QVBoxLayout* column_;
  std::vector<FAPRow*> rows_;
  QLabel* missing_;
};

}  // namespace mien
