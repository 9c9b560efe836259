#pragma once

#include <QDialog>
#include <vector>

class QDialogButtonBox;
class QPushButton;
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
  void showButton();
  void addPage(QWidget* content, const QString& title, const QString& copyName, const QString& copyText,
               const QString& copied);

  QTabWidget* pages_;
  QDialogButtonBox* buttons_;
  std::vector<QPushButton*> copies_;  ///< one for each page
};

}  // namespace mien
