#pragma once

#include <QFrame>

class QLabel;

namespace mien {

class Autosave;
class SessionDocument;

/// Offers what a process that ended without leave had not saved, over the foot of the views until it is answered; one
/// after the other where there were several.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  RecoveryBar(Autosave* autosave, SessionDocument* document, QWidget* parent = nullptr);

 private:
  void restore();
  void discard();

  void offer();

  Autosave* autosave_;
  SessionDocument* document_;
  QLabel* sentence_;
};

}  // namespace mien
