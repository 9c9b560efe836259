#include "XMLCounts.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace mien {

namespace {

/// The best that deflate can do is 1032 to 1; LZ4 and the 32 kB blocks of LZMA stay below.
constexpr double bestCompression = 1100.0;

constexpr std::size_t longestTag = 1 << 16;

std::istringstream classicStream(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return stream;
}

/// Points that an extent "0 40 0 55 0 0" spans; a negative number when it is none.
double pointsOfExtent(const std::string& text) {
  std::istringstream stream = classicStream(text);
  double points = 1.0, begin = 0.0, end = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(stream >> begin >> end)) return -1.0;
    points *= std::max(0.0, end - begin + 1.0);
  }
  return points;
}

double countOf(const std::string& text) {
  std::istringstream stream = classicStream(text);
  double count = 0.0;
  return stream >> count ? count : -1.0;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

struct Attribute {
  std::string name, value;

  bool isExtent() const { return endsWith(name, "Extent"); }
  bool isCount() const { return name.rfind("NumberOf", 0) == 0; }
  double count() const { return isExtent() ? pointsOfExtent(value) : countOf(value); }
};

/// The next name="value" of a tag from `at` on; false after the last.
bool nextAttribute(const std::string& tag, std::size_t& at, Attribute& attribute) {
  const std::size_t equals = tag.find('=', at);
  const std::size_t open = tag.find_first_of("\"'", equals);
  const std::size_t close = open == std::string::npos ? open : tag.find(tag[open], open + 1);
  if (equals == std::string::npos || close == std::string::npos) return false;
  const std::size_t last = tag.find_last_not_of(" \t\r\n", equals - (equals > 0));
  const std::size_t before = last == std::string::npos ? last : tag.find_last_of(" \t\r\n", last);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  attribute = {tag.substr(begin, last + 1 - begin), tag.substr(open + 1, close - open - 1)};
  at = close + 1;
  return true;
}

/// What the tags read so far promise.
class Promise {
 public:
  explicit Promise(double size) : Most(size) {}

  /// One sentence, or nothing.
  std::string read(const std::string& tag) {
    const bool isArray = tag.rfind("DataArray", 0) == 0 || tag.rfind("Array", 0) == 0;
    Attribute attribute;
    double tuples = isArray ? this->Largest : 0.0, components = 1.0;
    for (std::size_t at = 0; nextAttribute(tag, at, attribute);) {
      if (attribute.name == "compressor") this->Most *= bestCompression;
      if (!attribute.isCount() && !attribute.isExtent()) continue;
      const double count = attribute.count();
      if (!(count >= 0.0 && count <= this->Most)) return this->describe(attribute);
      if (attribute.name == "NumberOfComponents")
        components = count;
      else
        tuples = std::max(tuples, count);
      if (tuples * components > this->Most) return this->describe(attribute);
    }
    if (!isArray) this->Largest = std::max(this->Largest, tuples);
    return {};
  }

 private:
  static std::string describe(const Attribute& attribute) {
    return attribute.name + "=\"" + attribute.value.substr(0, 80) +
           "\" is more than the file holds, or no count; it is damaged, "
           "write it again";
  }

  double Most;
  double Largest = 0.0;  ///< points or cells of a piece
};

}  // namespace

std::string describeCountFault(std::istream& file, std::uintmax_t size) {
  Promise promise(static_cast<double>(size));
  for (std::string tag; std::getline(file, tag, '<') && tag.rfind("AppendedData", 0) != 0;) {
    tag.resize(std::min({tag.size(), tag.find('>'), longestTag}));  // what follows is data
    const std::string fault = promise.read(tag);
    if (!fault.empty()) return fault;
  }
  return {};
}

}  // namespace mien
