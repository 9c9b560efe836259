#include "PanelLabel.h"

namespace mien {

QString panelLabel(size_t index, size_t count) {
  if (count < 2) return {};
  const QChar letter('a' + static_cast<char>(index % 26));
  return '(' + (index < 26 ? QString() : QString::number(index / 26)) + letter + ')';
}

}  // namespace mien
