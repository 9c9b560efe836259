#include "VertexWords.h"

#include "NumberText.h"

namespace mien {

std::string readVertexWords(const std::vector<std::string_view>& words, double (&place)[3]) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (i + 1 == words.size())
      return "a vertex has " + (i == 1 ? std::string("1 number") : std::to_string(i) + " numbers") + ", not three";
    const auto number = parseNumber(words[i + 1]);
    if (!number) return "a vertex has " + inQuotes(words[i + 1]) + " where a finite number belongs";
    place[i] = *number;
  }
  return {};
}

}  // namespace mien
