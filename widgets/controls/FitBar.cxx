#include "FitBar.h"

#include <vtkFDTWriter.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVariant>
#include <algorithm>

#include "DeformationText.h"
#include "ElidedLabel.h"
#include "FDTData.h"
#include "FaceModel.h"
#include "FileDialog.h"
#include "FramedButton.h"
#include "PipelineErrors.h"
#include "PresentTable.h"
#include "SessionPart.h"
#include "TableText.h"
#include "WholeFile.h"

namespace mien {

namespace {

/// @return nothing, or what is wrong
QString writeFit(const DeformationTable& table, const std::string& comment, const QString& fileName) {
  vtkNew<vtkTable> data;
  vtkNew<vtkFDTWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  const std::string excess = table.describeExcess();
  if (!excess.empty()) return FitBar::tr("%1 is not written: %2").arg(fileName, QString::fromStdString(excess));
  writeFDT(table, data);
  writer->SetInputData(data);
  writer->SetFileName(fileName.toStdString().c_str());
  writer->SetComment(comment);
  writer->Write();
  return errors.first().empty() ? QString() : fileName + ": " + WholeFile::unwritable;
}

}  // namespace

FitBar::FitBar(FaceModel* model, PresentTable* present, QWidget* parent)
    : QWidget(parent),
      model_(model),
      present_(present),
      pin_(new QToolButton(this)),
      use_(new QToolButton(this)),
      save_(new QToolButton(this)),
      status_(new ElidedLabel(this)) {
  describeControls();
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(pin_);
  row->addWidget(use_);
  row->addWidget(save_);
  row->addWidget(status_, 1);
  connect(pin_, &QToolButton::toggled, present_, [this](bool on) { on ? present_->pin() : present_->unpin(); });
  connect(use_, &QToolButton::clicked, this, &FitBar::use);
  connect(save_, &QToolButton::clicked, this, &FitBar::ask);
  connect(present_, &PresentTable::changed, this, &FitBar::showFit);
  showFit();
}

void FitBar::describeControls() {
  makeFramed(pin_, "deformationPin", tr("Pin as A"),
             tr("The neutral face A that tables are fitted from: pressed, the face as it stands now, its FAPs and its "
                "table; else the face at rest"));
  pin_->setCheckable(true);
  pin_->setProperty(notInSession, true);  // the table knows its A
  makeFramed(use_, "deformationUse", tr("Use fit"),
             tr("The face goes back to A, and the table fitted from A to the present face bends it; the session keeps "
                "it. Not where A has a table of its own, as one table bends a face at a time"));
  makeFramed(save_, "deformationSave", tr("Save..."),
             tr("Writes the table fitted from A to the present face as .csv, in pupil units"));
  status_->setObjectName("deformationStatus");
  status_->setProperty("faint", true);
}

void FitBar::showFit() {
  {
    const QSignalBlocker quiet(pin_);
    pin_->setChecked(present_->isPinned());
  }
  const auto& fit = present_->fit();
  const bool moves = fit && fit->fault.isEmpty() && fit->moves();
  const bool plain = present_->neutralState().deformation.table.empty();
  use_->setEnabled(moves && plain && fit->table.describeExcess().empty());
  save_->setEnabled(moves);
  status_->setToolTip(tr(
      "How well 16 quadratic maps from A to the present face fit: the root mean square of what is left, in pupil units "
      "(pu, half the distance of the pupils)"));
  if (!fit) return status_->setText(tr("The fit is being computed."));
  if (!fit->fault.isEmpty()) return status_->setText(fit->fault);
  if (!moves) return status_->setText(tr("A: %1. The present face is A; move it.").arg(present_->neutralText()));
  const auto worst = std::max_element(fit->rms.begin(), fit->rms.end());
  status_->setText(tr("RMS %1 pu, up to %2 pu (region %3)")
                       .arg(fit->totalRms, 0, 'f', 3)
                       .arg(*worst, 0, 'f', 3)
                       .arg(worst - fit->rms.begin() + 1));
  if (!fit->warning.isEmpty()) status_->setToolTip(fit->warning);
}

void FitBar::ask() {
  const QString name = FileDialog::save(window(), tr("Save the fitted table"), QString(),
                                        tr("Facial deformation table (*.csv)"), ".csv");
  if (!name.isEmpty()) save(name);
}

/// One line, without paths: what the table was fitted to.
std::string FitBar::comment(const std::string& name) const {
  const QString table = deformationText(model_->state().deformation);
  return name + ": fitted by Mien Studio from A (" + present_->neutralText().toStdString() + ") to the present face" +
         (table.isEmpty() ? "" : " with " + table.toStdString()) + ", RMS " +
         QString::number(present_->fit()->totalRms, 'g', 3).toStdString() + "; pupil units";
}

bool FitBar::save(const QString& fileName) {
  const auto& fit = present_->fit();
  if (!fit || !fit->fault.isEmpty()) return false;
  const QString fault = writeFit(fit->table, comment("Facial deformation table"), fileName);
  if (!fault.isEmpty()) {
    emit model_->failed(fault, QString());
    return false;
  }
  emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  return true;
}

/// On top of what it was fitted to the table would move the face twice. The state keeps the table itself.
void FitBar::use() {
  const auto& fit = present_->fit();
  if (!fit || !fit->fault.isEmpty()) return;
  const std::string table = writeTable(fit->table, comment("Fit " + std::to_string(++used_)));
  model_->change([&](FaceState& state) {
    state = present_->neutralState();
    state.deformation = {};
    state.deformation.table = table;
  });
}

}  // namespace mien
