#include "PolygonFile.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "NumberText.h"

namespace mien {

namespace {

constexpr std::int64_t mostCorners = 1 << 20;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool isCornerList(const std::string& name) {
  return name == "vertex_indices" || name == "vertex_index";
}

template <class Number>
double numberFrom(const unsigned char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

}  // namespace

PolygonFile::Type PolygonFile::typeOf(std::string_view name) {
  if (name == "char" || name == "int8") return {1, true, false};
  if (name == "uchar" || name == "uint8") return {1, false, false};
  if (name == "short" || name == "int16") return {2, true, false};
  if (name == "ushort" || name == "uint16") return {2, false, false};
  if (name == "int" || name == "int32") return {4, true, false};
  if (name == "uint" || name == "uint32") return {4, false, false};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  return {};
}

bool PolygonFile::readHeaderLine(const std::vector<std::string_view>& words) {
  if (words[0] == "format" && words.size() > 1) {
    if (words[1] == "binary_little_endian") encoding_ = Encoding::LittleEndian;
    if (words[1] == "binary_big_endian") encoding_ = Encoding::BigEndian;
  } else if (words[0] == "element" && words.size() > 2) {
    elements_.push_back({std::string(words[1]), parseWholeNumber(words[2]).value_or(-1), {}});
    return elements_.back().count >= 0;
  } else if (words[0] == "property" && words.size() > 2) {
    const bool isList = words[1] == "list";
    if (elements_.empty() || (isList && words.size() < 5)) return false;
    const Property property{std::string(words[isList ? 4 : 2]), typeOf(words[isList ? 3 : 1]),
                            isList ? typeOf(words[2]) : Type(), isList};
    if (property.type.bytes == 0 || (isList && property.countType.bytes == 0)) return false;
    elements_.back().properties.push_back(property);
  }
  return true;
}

bool PolygonFile::readHeader() {
  std::vector<std::string_view> words;
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = std::min(end + 1, text_.size());
    ++line_;
    words.clear();
    splitAtBlanks(line, words);
    if (words.empty()) continue;
    if (words[0] == "end_header") return true;
    if (!readHeaderLine(words)) return false;
  }
  return false;
}

bool PolygonFile::openPly(std::string_view text) {
  text_ = text;
  if (text.substr(0, 3) != "ply" || !readHeader()) return false;
  for (const Element& element : elements_) {
    if (element.name == "vertex") vertices_ = element.count;
    if (element.name == "face") faces_ = element.count;
  }
  return vertices_ > 0;
}

/// "OFF" as text, with the letters ST, C and N before it for what else stands in the line of a vertex, or as binary, in
/// little endian numbers and without more than places and corners.
bool PolygonFile::openOff(std::string_view text) {
  text_ = text;
  const std::string_view first = text.substr(0, text.find('\n'));
  for (const char* more : {"ST", "C", "N"})
    if (text.substr(at_, std::strlen(more)) == more) at_ += std::strlen(more);
  restOfLine_ = at_ > 0;
  if (text.substr(at_, 3) != "OFF") return false;
  at_ += 3;
  const bool isBinary = first.find("BINARY") != std::string_view::npos;
  if (isBinary && (restOfLine_ || first.size() == text.size())) return false;
  if (isBinary) {
    encoding_ = Encoding::LittleEndian;
    at_ = first.size() + 1;
  }
  const Type real{isBinary ? 4 : 8, true, true}, whole{4, !isBinary, false};
  double counts[3];
  for (double& count : counts)
    if (!next(whole, count) || !(count >= 0.0 && count < 1e15)) return false;
  vertices_ = static_cast<std::int64_t>(counts[0]);
  faces_ = static_cast<std::int64_t>(counts[1]);
  elements_ = {{"vertex", vertices_, {{"x", real, {}, false}, {"y", real, {}, false}, {"z", real, {}, false}}},
               {"face", faces_, {{"vertex_indices", whole, whole, true}}}};
  return vertices_ > 0;
}

/// The next number of the text. Comments reach to the end of their line.
bool PolygonFile::nextWord(double& value) {
  while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '#')) {
    if (text_[at_] == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    else
      line_ += text_[at_++] == '\n';
  }
  if (at_ < text_.size() && text_[at_] == '+') ++at_;
  const char* const end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  if (error == std::errc::invalid_argument) return false;
  at_ = static_cast<std::size_t>(stop - text_.data());
  return true;
}

double PolygonFile::binaryValue(const Type& type) const {
  unsigned char bytes[8] = {};
  for (int i = 0; i < type.bytes; ++i)
    bytes[encoding_ == Encoding::LittleEndian ? i : type.bytes - 1 - i] =
        static_cast<unsigned char>(text_[at_ + static_cast<std::size_t>(i)]);
  if (type.isReal) return type.bytes == 4 ? numberFrom<float>(bytes) : numberFrom<double>(bytes);
  if (type.bytes == 1) return type.isSigned ? numberFrom<std::int8_t>(bytes) : numberFrom<std::uint8_t>(bytes);
  if (type.bytes == 2) return type.isSigned ? numberFrom<std::int16_t>(bytes) : numberFrom<std::uint16_t>(bytes);
  return type.isSigned ? numberFrom<std::int32_t>(bytes) : numberFrom<std::uint32_t>(bytes);
}

bool PolygonFile::next(const Type& type, double& value) {
  if (encoding_ == Encoding::Text) return nextWord(value);
  if (text_.size() - at_ < static_cast<std::size_t>(type.bytes)) return false;
  value = binaryValue(type);
  at_ += static_cast<std::size_t>(type.bytes);
  return true;
}

bool PolygonFile::readList(const Property& property, std::vector<std::int64_t>* corners) {
  double count, value;
  if (!next(property.countType, count) || !(count >= 0.0 && count <= mostCorners)) return false;
  const bool kept = corners && isCornerList(property.name);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
    if (!next(property.type, value)) return false;
    if (kept) corners->push_back(std::abs(value) < 1e18 ? static_cast<std::int64_t>(value) : -1);
  }
  return true;
}

bool PolygonFile::readRow(const Element& element, double (*place)[3], std::vector<std::int64_t>* corners) {
  bool first = true;
  for (const Property& property : element.properties) {
    double value;
    if (property.isList ? !readList(property, corners) : !next(property.type, value)) return false;
    if (first) rowLine_ = line_;
    first = false;
    const bool isAxis = property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
    if (place && isAxis && !property.isList) (*place)[property.name[0] - 'x'] = value;
  }
  ++rowsRead_;
  // What else an .off file says of a face, such as its colour, stands in the rest of the line.
  const bool isFace = element.properties.back().name == "vertex_indices";
  if (encoding_ == Encoding::Text && (isFace || restOfLine_)) at_ = std::min(text_.find('\n', at_), text_.size());
  return true;
}

/// Passes over elements until the one that is wanted.
bool PolygonFile::skipTo(const char* element) {
  while (element_ < elements_.size() && elements_[element_].name != element) {
    const Element& skipped = elements_[element_];
    for (; rowsRead_ < skipped.count && !skipped.properties.empty();)
      if (!readRow(skipped, nullptr, nullptr)) return false;
    ++element_;
    rowsRead_ = 0;
  }
  return element_ < elements_.size() && !elements_[element_].properties.empty();
}

bool PolygonFile::readVertex(double (&place)[3]) {
  return skipTo("vertex") && rowsRead_ < vertices_ && readRow(elements_[element_], &place, nullptr);
}

bool PolygonFile::readFace(std::vector<std::int64_t>& corners) {
  corners.clear();
  return skipTo("face") && rowsRead_ < faces_ && readRow(elements_[element_], nullptr, &corners);
}

std::string PolygonFile::lineHere() const {
  return encoding_ == Encoding::Text ? "line " + std::to_string(line_) + ": " : std::string();
}

std::string PolygonFile::place(const std::string& what, std::int64_t number) const {
  return encoding_ == Encoding::Text ? "line " + std::to_string(rowLine_) : what + " " + std::to_string(number);
}

}  // namespace mien
