#include "TableTitle.h"

#include <algorithm>

#include "InlineText.h"

namespace mien {

std::string tableTitle(const std::string& text) {
  if (!isInlineText(text)) return text;
  const std::string comment = "# ";
  if (text.rfind(comment, 0) != 0) return "own table";
  return text.substr(comment.size(), std::min(text.find('\n'), text.find(':')) - comment.size());
}

}  // namespace mien
