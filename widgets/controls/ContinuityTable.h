#pragma once

#include <QTableWidget>

class vtkTable;

namespace mien {

/// Summaries of seams, a row each: numbers of the eye's precision, a dash where nothing is defined.
class ContinuityTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit ContinuityTable(QWidget* parent = nullptr);

  void setRowNames(const QString& title, const QStringList& names);  ///< clears the table when the names are other ones

  /// @param sourceRow  of the summary
  void setSummary(int row, vtkTable* summary, int sourceRow, bool frontal);

  /// A row without numbers, whose tool tip says why.
  void setFault(int row, const QString& why);

  QSize sizeHint() const override;

  static constexpr int leastLine = 20, mostLine = 28;  ///< pixels of a row
};

}  // namespace mien
