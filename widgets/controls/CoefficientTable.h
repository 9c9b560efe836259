#pragma once

#include <QTableWidget>
#include <string>

#include "DeformationTable.h"
#include "PresentTable.h"

namespace mien {

/// A table's 16 x 12 coefficients, each with the range mean +- sd of an expression. Numbers that lie
/// outside by one or more of the last decimal shown, so that they read so, are red and bold, and off the range on their
/// scale. Ctrl+C copies all of it as CSV.
class CoefficientTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit CoefficientTable(QWidget* parent = nullptr);

  /// @param mean  with deviations; nullptr: none is near, so nothing is marked
  /// @param fit   how well the table was fitted; nullptr: it was not
  void show(const DeformationTable& table, const std::string& meanName, const DeformationTable* mean,
            const PresentTable::Fit* fit);

  int chosenRegion() const { return currentRow() + 1; }  ///< 1 .. 16; 0: none

  /// The chosen coefficient in words, with all digits.
  QString detail() const;

  /// CSV: region, name, coefficient, value and, with a mean, mean, sd, range (inside, above, below); empty before the
  /// first show().
  std::string text() const;

  QSize sizeHint() const override;

  static constexpr int leastLine = 18, mostLine = 40;  ///< pixels of a row: number and scale, and a loose one

 private:
  void addHeaders();
  void addCells();
  void fillCoefficient(int region, int coefficient);
  QString legend() const;
  QString wordsOf(int region, int coefficient) const;
  QString rangeWords(int region, int coefficient, bool standsOut) const;  ///< with all digits, and the limits
  void fillFit(int region, const PresentTable::Fit* fit);

  DeformationTable table_, mean_;
  std::string meanName_;
  bool hasMean_ = false, shown_ = false;
};

}  // namespace mien
