#include "RecoveryBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "Autosave.h"
#include "FramedButton.h"
#include "SessionDocument.h"

namespace mien {

RecoveryBar::RecoveryBar(Autosave* autosave, SessionDocument* document, QWidget* next, QWidget* parent)
    : QFrame(parent), autosave_(autosave), document_(document), next_(next), sentence_(new QLabel(this)) {
  setObjectName("recoveryBar");
  sentence_->setObjectName("recoverySentence");
  sentence_->setWordWrap(true);
  auto *restored = new QToolButton(this), *discarded = new QToolButton(this);
  makeFramed(restored, "recoveryRestore", tr("Re&store"), tr("Shows it; undo takes it back no more"));
  makeFramed(discarded, "recoveryDiscard", tr("&Discard"), tr("Forgets it for good"));
  connect(restored, &QToolButton::clicked, this, &RecoveryBar::restore);
  connect(discarded, &QToolButton::clicked, this, &RecoveryBar::discard);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 6, 4);
  row->addWidget(sentence_, 1);
  row->addWidget(restored);
  row->addWidget(discarded);
  offer();
}

void RecoveryBar::offer() {
  if (autosave_->hasOrphan()) sentence_->setText(autosave_->orphanText());
  if (!autosave_->hasOrphan()) giveFocus();
  setVisible(autosave_->hasOrphan());
}

/// Before the bar goes: a button that is hidden loses the focus to whatever comes next in the window.
void RecoveryBar::giveFocus() {
  const QWidget* focus = window()->focusWidget();
  if (!focus || !focus->isVisible() || isAncestorOf(focus)) next_->setFocus();
}

/// What else was kept is offered at the next start: shown now, it would take the place of this. One that cannot be
/// shown is put aside, as a later version may.
void RecoveryBar::restore() {
  nlohmann::json session;
  const QString fault = autosave_->readOrphan(session);
  if (!document_->recover(session, fault)) {
    autosave_->putAside();
    return offer();
  }
  autosave_->discardOrphan();
  giveFocus();
  hide();
}

void RecoveryBar::discard() {
  autosave_->discardOrphan();
  offer();
}

}  // namespace mien
