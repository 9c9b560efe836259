#pragma once

#include <QFrame>

namespace mien {

class Autosave;
class SessionDocument;

/// Offers what a process that ended without leave had not saved, below the face until it is answered.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  RecoveryBar(Autosave* autosave, SessionDocument* document, QWidget* parent = nullptr);

 private:
  void restore();
  void discard();

  Autosave* autosave_;
  SessionDocument* document_;
};

}  // namespace mien
