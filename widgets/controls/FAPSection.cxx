#include "FAPSection.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "FAPRow.h"
#include "FAPText.h"

namespace mien {

FAPSection::FAPSection(int group, QWidget* parent)
    : QWidget(parent), group_(group), column_(new QVBoxLayout), missing_(new QLabel(this)) {
  auto* heading = new QLabel(fapGroupTitle(group), this);
  heading->setObjectName(QString("fapHeading%1").arg(group));
  heading->setProperty("heading", true);
  column_->setSpacing(5);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(2, 8, 2, 2);
  all->setSpacing(7);
  all->addWidget(heading);
  all->addLayout(column_);
  all->addWidget(missing_);
  nameMissing();
}

void FAPSection::nameMissing() {
  QStringList numbers, names;
  for (const FAPDefinition& fap : fapTable)
    if (fap.group == group_ && !fap.hasSurface) {
      numbers << QString::number(fap.number);
      names << QString("%1 %2").arg(fap.number).arg(fapLabel(fap));
    }
  missing_->setObjectName(QString("fapWithoutSurface%1").arg(group_));
  missing_->setProperty("faint", true);
  missing_->setWordWrap(true);
  missing_->setText(tr("No surface on this face: FAP %1").arg(numbers.join(", ")));
  missing_->setToolTip(
      tr("The PDE face has no eyeballs, tongue or ears, so these FAPs move nothing:<br>%1").arg(names.join("<br>")));
  missing_->setVisible(!numbers.isEmpty());
}

void FAPSection::take(const std::vector<FAPRow*>& rows) {
  rows_ = rows;
  for (FAPRow* row : rows_) {
    column_->addWidget(row);
    row->show();
  }
}

int FAPSection::filter(const QString& words) {
  int left = 0;
  for (FAPRow* row : rows_) {
    const bool named = fapMatches(fapDefinition(row->fap()), words);
    row->setVisible(named);
    left += named;
  }
  bool missing = false;
  for (const FAPDefinition& fap : fapTable)
    missing = missing || (fap.group == group_ && !fap.hasSurface && fapMatches(fap, words));
  missing_->setVisible(missing);
  setVisible(left > 0 || missing);
  return left + missing;
}

}  // namespace mien
