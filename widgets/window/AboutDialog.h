#pragma once

#include <QDialog>

class QDialogButtonBox;
class QTabWidget;

namespace mien {

/// What this program is, what it is made of, how to cite it and under which licence it comes.
class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent);

 private:
  void addVersions();
  void addCitation();
  void addLicence();
  void addPage(QWidget* content, const QString& title, const QString& copyName, const QString& copyText,
               const QString& copied);

  QTabWidget* pages_;
  QDialogButtonBox* buttons_;
};

}  // namespace mien
