#pragma once

#include <QDialog>
#include <vector>

#include "Message.h"

class QPlainTextEdit;
class QTreeWidget;

namespace mien {

/// What the message bar has said since the start, the newest first, with details and a button that copies all of it.
class MessageLog : public QDialog {
  Q_OBJECT
 public:
  MessageLog(const std::vector<Message>& messages, QWidget* parent);

  void add(const Message& message);

 private:
  void copy() const;

  QTreeWidget* list_;
  QPlainTextEdit* details_;
};

}  // namespace mien
