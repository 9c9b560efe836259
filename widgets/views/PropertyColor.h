#pragma once

#include <QColor>

#include "vtkProperty.h"

namespace mien {

inline void setColor(vtkProperty* property, const QColor& color) {
  property->SetColor(color.redF(), color.greenF(), color.blueF());
}

}  // namespace mien
