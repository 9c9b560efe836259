#pragma once

#include <QHash>
#include <vector>

#include "RowScroll.h"

class QLabel;

namespace mien {

class FAPRow;
class FAPSection;

/// Every low-level FAP in one list, a section for each feature, from the top of the face down.
class FAPList : public RowScroll {
  Q_OBJECT
 public:
  explicit FAPList(QWidget* parent = nullptr);

  /// Takes all these rows, by number.
  void take(const QHash<int, FAPRow*>& rows);

  /// Shows only FAPs that these words name: of the number, the name in the standard or here, or the feature point.
  void filter(const QString& words);

 private:
  std::vector<FAPSection*> sections_;
  QLabel* nothing_;
};

}  // namespace mien
