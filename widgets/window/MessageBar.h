#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

#include "Message.h"

class QLabel;
class QLayout;
class QPlainTextEdit;
class QTimer;
class QToolButton;

namespace mien {

class MessageLog;

/// What went wrong, or is worth knowing: one sentence over the foot of the views, with details on request.
/// It never interrupts; the next message takes the place of the last. A note leaves by itself unless the mouse is over
/// it or its details are read; an error stays until something succeeds or it is closed. All of them stand in a log.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  QString sentence() const;

  static constexpr int mostKept = 500;   ///< messages, of which the oldest are forgotten
  static constexpr int noteTime = 3000;  ///< ms that a note of one line stays; one of two lines twice as long
  const std::vector<Message>& log() const { return log_; }

 public slots:
  void showError(const QString& sentence, const QString& details);
  void showNote(const QString& sentence, const QString& details);
  void clearError();  ///< hides an error; a note stays
  void showLog();

 protected:
  bool event(QEvent* event) override;

 private:
  void leaveLater();
  void fitWidth();
  void buildButtons(QLayout* row);
  void show(const char* severity, const QString& sentence, const QString& details);

  QLabel* sentence_;
  QPlainTextEdit* details_;
  QToolButton* more_;
  QTimer* leaving_;
  std::vector<Message> log_;
  QPointer<MessageLog> shownLog_;
};

}  // namespace mien
