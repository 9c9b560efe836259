#include "FigureFont.h"

#include <QFontDatabase>
#include <QStringList>
#include <algorithm>
#include <numeric>

#include "Failure.h"
#include "FigureApplication.h"

namespace mien {

namespace {

constexpr int mostNamed = 5;
constexpr int nearShare = 3;  // a name is near when at most every third of its letters differs

/// Letters to insert, take away or replace (Levenshtein 1966).
int editDistance(const QString& from, const QString& to) {
  std::vector<int> row(to.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (int i = 1; i <= from.size(); ++i) {
    int diagonal = row[0];
    row[0] = i;
    for (int j = 1; j <= to.size(); ++j) {
      const int replaced = diagonal + (from[i - 1] != to[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j - 1] + 1, diagonal + 1, replaced});
    }
  }
  return row[to.size()];
}

bool isNear(const QString& wanted, const QString& family) {
  const QString a = wanted.toLower(), b = family.toLower();
  const QString word = a.section(' ', 0, 0);
  return (word.size() > 2 && b.contains(word)) || a.contains(b) || nearShare * editDistance(a, b) <= b.size();
}

}  // namespace

void requireFont(const std::string& option, const std::string& family) {
  const FigureApplication application;
  const QStringList families = QFontDatabase().families();
  const QString wanted = QString::fromStdString(family);
  if (families.contains(wanted, Qt::CaseInsensitive)) return;
  QStringList near;
  for (const QString& one : families)
    if (isNear(wanted, one)) near << one;
  const std::string known = near.isEmpty() ? "fc-list : family lists those that are"
                                           : "near ones are " + near.mid(0, mostNamed).join(", ").toStdString();
  throw ValueFailure(option + " '" + family + "' is not installed; " + known);
}

}  // namespace mien
