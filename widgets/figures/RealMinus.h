#pragma once

#include <QString>

namespace mien {

/// A number as people read it: with the minus sign U+2212, which is as wide as a plus, in place of each hyphen. Not for
/// files.
inline QString withRealMinus(QString number) {
  return number.replace('-', QChar(0x2212));
}

}  // namespace mien
