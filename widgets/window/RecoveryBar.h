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
  /// @param next  has the focus when there is nothing more to answer, unless it is elsewhere by then
  RecoveryBar(Autosave* autosave, SessionDocument* document, QWidget* next, QWidget* parent = nullptr);

 private:
  void restore();
  void discard();

  void offer();
  void giveFocus();

  Autosave* autosave_;
  SessionDocument* document_;
  QWidget* next_;
  QLabel* sentence_;
};

}  // namespace mien
