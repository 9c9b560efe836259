#include "InlineText.h"

namespace mien {

bool isInlineText(const std::string& nameOrText) {
  return nameOrText.find('\n') != std::string::npos;
}

}  // namespace mien
