#pragma once

#include <QWidget>

class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace mien {

/// The manual in a window of its own: contents, search and one page that needs no network.
///
/// Its sections are anchors, those of docks and views with the object name of what they describe.
class ManualWindow : public QWidget {
  Q_OBJECT
 public:
  explicit ManualWindow(QWidget* parent);

  /// The anchor of the dock or view that a widget is in; that of the first section for any other.
  QString sectionOf(const QWidget* widget) const;

  void showSection(const QString& anchor);
  QString section() const;  ///< the anchor that is chosen in the contents

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void dress();
  void listSections();
  QWidget* side();
  void find(bool backward);

  QTextBrowser* page_;
  QListWidget* contents_;
  QLineEdit* search_;
};

}  // namespace mien
