#include "TableTitle.h"

#include <algorithm>

namespace mien {

bool isInlineTable(const std::string& text) {
  return text.find('\n') != std::string::npos;
}

std::string tableTitle(const std::string& text) {
  if (!isInlineTable(text)) return text;
  const std::string comment = "# ";
  if (text.rfind(comment, 0) != 0) return "own table";
  return text.substr(comment.size(), std::min(text.find('\n'), text.find(':')) - comment.size());
}

}  // namespace mien
