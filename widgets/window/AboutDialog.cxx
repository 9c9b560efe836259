#include "AboutDialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "Citations.h"
#include "LibraryVersions.h"
#include "LicenceText.h"
#include "SessionPart.h"

namespace mien {

namespace {

constexpr int aboutWidth = 620, aboutHeight = 460;  // pixels

QPlainTextEdit* readOnly(const QString& name, const std::string& text, QWidget* parent) {
  auto* made = new QPlainTextEdit(QString::fromStdString(text), parent);
  made->setObjectName(name);
  made->setReadOnly(true);
  made->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return made;
}

}  // namespace

AboutDialog::AboutDialog(QWidget* parent)
    : QDialog(parent), pages_(new QTabWidget(this)), buttons_(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
  setObjectName("aboutDialog");
  setWindowTitle(tr("About Mien Studio"));
  resize(aboutWidth, aboutHeight);
  pages_->setObjectName("aboutPages");
  pages_->setProperty(notInSession, true);
  auto* title = new QLabel(tr("<h2>Mien Studio</h2><p>A face of nine PDE surface patches between 29 boundary curves, "
                              "animated by MPEG-4 FAPs "
                              "and deformed by facial deformation tables.</p>"),
                           this);
  title->setWordWrap(true);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(title);
  column->addWidget(pages_, 1);
  column->addWidget(buttons_);
  addVersions();
  addCitation();
  addLicence();
  connect(pages_, &QTabWidget::currentChanged, this, &AboutDialog::showButton);
  showButton();
}

/// Once all are there: each that is added shows those before it.
void AboutDialog::showButton() {
  for (size_t i = 0; i < copies_.size(); ++i) copies_[i]->setVisible(pages_->currentIndex() == static_cast<int>(i));
}

void AboutDialog::addVersions() {
  auto* box = new QWidget(pages_);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(4, 10, 4, 4);
  form->setHorizontalSpacing(18);
  QStringList lines;
  for (const auto& [library, version] : libraryVersions()) {
    auto* value = new QLabel(version, box);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    form->addRow(library, value);
    lines << library + ' ' + version;
  }
  addPage(box, tr("&Versions"), "aboutCopyVersions", tr("&Copy"), lines.join('\n'));
}

void AboutDialog::addCitation() {
  addPage(readOnly("aboutCitations", Citations(), pages_), tr("C&itation"), "aboutCopyCitations", tr("&Copy as BibTeX"),
          QString::fromStdString(Citations()));
}

void AboutDialog::addLicence() {
  addPage(readOnly("aboutLicence", LicenceText(), pages_), tr("&Licence"), "aboutCopyLicence", tr("&Copy"),
          QString::fromStdString(LicenceText()));
}

/// Its button stands in the dialog's row while the page is seen.
void AboutDialog::addPage(QWidget* content, const QString& title, const QString& copyName, const QString& copyText,
                          const QString& copied) {
  auto* copy = buttons_->addButton(copyText, QDialogButtonBox::ActionRole);
  copy->setObjectName(copyName);
  copy->setToolTip(tr("Takes this page's text to the clipboard"));
  copy->setAutoDefault(false);
  connect(copy, &QPushButton::clicked, this, [copied] { QGuiApplication::clipboard()->setText(copied); });
  copies_.push_back(copy);
  pages_->addTab(content, title);
}

}  // namespace mien
