#include "DeformationText.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "FaceState.h"
#include "TableTitle.h"

namespace mien {

QString shortTableText(const std::string& table) {
  const QString title = QString::fromStdString(tableTitle(table));
  return QFileInfo::exists(title) ? QFileInfo(title).completeBaseName() : title;
}

QString deformationText(const FaceDeformation& deformation) {
  if (deformation.table.empty()) return {};
  const QString text = QCoreApplication::translate("mien::DeformationText", "%1 at %2 %")
                           .arg(shortTableText(deformation.table))
                           .arg(100.0 * deformation.strength, 0, 'f', 0);
  return deformation.smooth ? text : QCoreApplication::translate("mien::DeformationText", "%1, hard").arg(text);
}

}  // namespace mien
