#include "RecoveryBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "Autosave.h"
#include "FramedButton.h"
#include "SessionDocument.h"

namespace mien {

RecoveryBar::RecoveryBar(Autosave* autosave, SessionDocument* document, QWidget* parent)
    : QFrame(parent), autosave_(autosave), document_(document) {
  setObjectName("recoveryBar");
  auto* sentence = new QLabel(
      tr("Mien Studio ended unexpectedly. What it showed last, %1, was kept.").arg(autosave->orphanText()), this);
  sentence->setObjectName("recoverySentence");
  sentence->setWordWrap(true);
  auto *restored = new QToolButton(this), *discarded = new QToolButton(this);
  makeFramed(restored, "recoveryRestore", tr("Re&store"), tr("Shows it; undo takes it back no more"));
  makeFramed(discarded, "recoveryDiscard", tr("&Discard"), tr("Forgets it for good"));
  connect(restored, &QToolButton::clicked, this, &RecoveryBar::restore);
  connect(discarded, &QToolButton::clicked, this, &RecoveryBar::discard);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 6, 4);
  row->addWidget(sentence, 1);
  row->addWidget(restored);
  row->addWidget(discarded);
  setVisible(autosave->hasOrphan());
}

/// It is kept where it cannot be read: a later version may.
void RecoveryBar::restore() {
  nlohmann::json session;
  const QString fault = autosave_->readOrphan(session);
  const bool shown = document_->recover(session, fault);
  shown ? discard() : hide();
}

void RecoveryBar::discard() {
  autosave_->discardOrphans();
  hide();
}

}  // namespace mien
