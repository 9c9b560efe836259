#include "FramedButton.h"

#include <QToolButton>
#include <QVariant>

namespace mien {

void makeFramed(QToolButton* button, const QString& name, const QString& text, const QString& tip) {
  button->setObjectName(name);
  button->setText(text);
  button->setToolTip(tip);
  button->setProperty("framed", true);
  button->setFocusPolicy(Qt::TabFocus);
}

}  // namespace mien
