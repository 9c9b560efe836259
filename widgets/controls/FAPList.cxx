#include "FAPList.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "FAPRow.h"
#include "FAPSection.h"
#include "FAPText.h"

namespace mien {

FAPList::FAPList(QWidget* parent)
    : RowScroll(parent), nothing_(new QLabel(tr("No FAP has this name, number or feature point."))) {
  setObjectName("fapList");
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 6, 0);
  column->setSpacing(4);
  nothing_->setObjectName("fapNothingFound");
  nothing_->setProperty("faint", true);
  nothing_->setWordWrap(true);
  nothing_->hide();
  column->addWidget(nothing_);
  for (int group : fapGroups()) {
    sections_.push_back(new FAPSection(group, page));
    column->addWidget(sections_.back());
  }
  column->addStretch();
  setWidget(page);
}

void FAPList::take(const QHash<int, FAPRow*>& rows) {
  for (FAPSection* section : sections_) {
    std::vector<FAPRow*> ofGroup;
    for (const FAPDefinition& fap : fapTable)
      if (fap.group == section->group() && rows.contains(fap.number)) ofGroup.push_back(rows.value(fap.number));
    section->take(ofGroup);
  }
}

void FAPList::filter(const QString& words) {
  int left = 0;
  for (FAPSection* section : sections_) left += section->filter(words);
  nothing_->setVisible(left == 0);
  widget()->updateGeometry();
}

}  // namespace mien
