#pragma once

#include <QFrame>

class QLabel;
class QPlainTextEdit;
class QTimer;
class QToolButton;

namespace mien {

/// What went wrong, or is worth knowing: one sentence at the foot of the window, with details on request.
/// It never interrupts; the next message takes the place of the last. A note without details leaves after some seconds,
/// an error when what failed has succeeded.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  QString sentence() const;

 public slots:
  void showError(const QString& sentence, const QString& details);
  void showNote(const QString& sentence, const QString& details);
  void clearError();  ///< hides an error; a note stays

 private:
  void show(const char* severity, const QString& sentence, const QString& details);

  QLabel* sentence_;
  QPlainTextEdit* details_;
  QToolButton* more_;
  QTimer* leaving_;
};

}  // namespace mien
