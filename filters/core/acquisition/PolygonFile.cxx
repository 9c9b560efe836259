#include "PolygonFile.h"

#include <algorithm>
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

bool PolygonFile::refuse(const std::string& why) {
  fault_ = why;
  return false;
}

bool PolygonFile::readProperty(const std::vector<std::string_view>& words) {
  const bool isList = words[1] == "list";
  if (elements_.empty() || (isList && words.size() < 5)) return refuse("has a property that is incomplete");
  const std::string_view type = words[isList ? 3 : 1];
  const Property property{std::string(words[isList ? 4 : 2]), typeOf(type), isList ? typeOf(words[2]) : Type(), isList};
  if (isList && property.countType.bytes == 0) return refuse("has the unknown type " + inQuotes(words[2]));
  if (property.type.bytes == 0) return refuse("has the unknown type " + inQuotes(type));
  elements_.back().properties.push_back(property);
  return true;
}

bool PolygonFile::readHeaderLine(const std::vector<std::string_view>& words) {
  if (words[0] == "format" && words.size() > 1) {
    if (words[1] == "binary_little_endian")
      encoding_ = Encoding::LittleEndian;
    else if (words[1] == "binary_big_endian")
      encoding_ = Encoding::BigEndian;
    else if (words[1] != "ascii")
      return refuse("has the unknown format " + inQuotes(words[1]));
  } else if (words[0] == "element" && words.size() > 2) {
    elements_.push_back({std::string(words[1]), parseWholeNumber(words[2]).value_or(-1), {}, line_});
    if (elements_.back().count < 0) return refuse("has " + inQuotes(words[2]) + " where a count belongs");
  } else if (words[0] == "property" && words.size() > 2) {
    return readProperty(words);
  }
  return true;
}

bool PolygonFile::readHeader() {
  std::vector<std::string_view> words;
  for (; at_ < text_.size(); ++line_) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = std::min(end + 1, text_.size());
    splitAtBlanks(line, words);
    if (words.empty()) continue;
    if (words[0] == "end_header") break;
    if (!readHeaderLine(words)) return false;
  }
  if (words.empty() || words[0] != "end_header") return refuse("has no end");
  ++line_;
  return true;
}

const PolygonFile::Element* PolygonFile::element(const std::string& name) const {
  for (const Element& element : elements_)
    if (element.name == name) return &element;
  return nullptr;
}

bool PolygonFile::refuseElement(const std::string& name, const std::string& why) {
  if (const Element* at = element(name)) line_ = at->line;
  return refuse(why);
}

/// Where vertices and faces are, and whether they hold what is needed.
bool PolygonFile::findElements() {
  const auto has = [](const Element& of, const auto& test) {
    return std::any_of(of.properties.begin(), of.properties.end(), test);
  };
  const Element* const vertex = element("vertex");
  if (!vertex || vertex->count == 0) return refuseElement("vertex", "gives no vertices");
  for (const char* axis : {"x", "y", "z"})
    if (!has(*vertex, [&](const Property& property) { return property.name == axis && !property.isList; }))
      return refuseElement("vertex", std::string("gives the vertices no property ") + axis);
  const Element* faces = element("face");
  if ((!faces || faces->count == 0) && element("tristrips")) facesAre_ = "tristrips";
  faces = element(facesAre_);
  const auto isCorners = [](const Property& property) { return property.isList && isCornerList(property.name); };
  if (faces && faces->count > 0 && !has(*faces, isCorners))
    return refuseElement(facesAre_, "gives the faces no list vertex_indices");
  vertices_ = vertex->count;
  faces_ = faces ? faces->count : 0;
  bodyAt_ = at_;
  bodyLine_ = line_;
  inHeader_ = false;
  return true;
}

bool PolygonFile::openPly(std::string_view text) {
  text_ = text;
  if (text.substr(0, 3) != "ply") return refuse("does not begin with \"ply\"");
  return readHeader() && findElements();
}

/// "OFF" as text, with the letters ST, C and N before it for what else stands in the line of a vertex, or as binary, in
/// little endian numbers and without more than places and corners.
bool PolygonFile::openOff(std::string_view text) {
  text_ = text;
  if (!skipCommentsAndBlanks()) return refuse("is cut off, the file ends");
  const std::size_t begin = at_;
  const std::string_view first = text.substr(at_, text.find('\n', at_) - at_);
  for (const char* more : {"ST", "C", "N"})
    if (text.substr(at_, std::strlen(more)) == more) at_ += std::strlen(more);
  restOfLine_ = at_ > begin;
  const std::string_view magic = text.substr(at_, 3);
  if (magic != "OFF" && magic != "off")
    return refuse("begins with " + inQuotes(first) + " where OFF, COFF, NOFF or STOFF belongs");
  at_ += 3;
  const bool isBinary = first.substr(0, first.find('#')).find("BINARY") != std::string_view::npos;
  if (isBinary && restOfLine_) return refuse("is binary with more than places, which is not read");
  if (isBinary) {
    encoding_ = Encoding::LittleEndian;
    at_ = std::min(begin + first.size() + 1, text.size());
  }
  const Type real{isBinary ? 4 : 8, true, true}, whole{4, !isBinary, false};
  double counts[3] = {};
  for (double& count : counts) {
    const bool isEdges = &count == counts + 2;
    if (isEdges && encoding_ == Encoding::Text && endsLine()) break;  // some leave out the number of edges
    if (!next(whole, count)) return false;
    if (!(count >= 0.0 && count < 1e15)) return refuse("has a count that is none");
  }
  elements_ = {
      {"vertex", static_cast<std::int64_t>(counts[0]), {{"x", real, {}}, {"y", real, {}}, {"z", real, {}}}, line_},
      {"face", static_cast<std::int64_t>(counts[1]), {{"vertex_indices", whole, whole, true}}, line_}};
  return findElements();
}

bool PolygonFile::endsLine() const {
  const std::size_t next = text_.find_first_not_of(" \t\r", at_);
  return next == std::string_view::npos || text_[next] == '\n' || text_[next] == '#';
}

/// Comments reach to the end of their line. @return whether something follows
bool PolygonFile::skipCommentsAndBlanks() {
  while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '#')) {
    if (text_[at_] == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    else
      line_ += text_[at_++] == '\n';
  }
  return at_ < text_.size();
}

/// The next number of the text.
bool PolygonFile::nextWord(double& value) {
  if (!skipCommentsAndBlanks()) return refuse("is cut off, the file ends");
  const char* const begin = text_.data() + at_;
  const auto [stop, error] = std::from_chars(begin + (*begin == '+'), text_.data() + text_.size(), value);
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  const bool isWhole =
      error != std::errc::invalid_argument && (stop == text_.data() + text_.size() || isBlank(*stop) || *stop == '#');
  if (!isWhole || !std::isfinite(value)) {
    const std::string_view rest = text_.substr(at_, 80);
    const std::string_view word = rest.substr(0, std::min(rest.find_first_of(" \t\r\n"), rest.size()));
    if (!isWhole) return refuse("has " + inQuotes(word) + " where a number belongs");
    infiniteWord_ = word;
  }
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
  if (text_.size() - at_ < static_cast<std::size_t>(type.bytes)) return refuse("is cut off, the file ends");
  value = binaryValue(type);
  at_ += static_cast<std::size_t>(type.bytes);
  return true;
}

bool PolygonFile::readList(const Property& property, std::vector<std::int64_t>* corners) {
  double count, value;
  if (!next(property.countType, count)) return false;
  if (!(count >= 0.0 && count <= mostCorners)) return refuse("is a list of " + numberText(count) + " numbers");
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
    if (!place || !isAxis || property.isList) continue;
    (*place)[property.name[0] - 'x'] = value;
    if (!std::isfinite(value)) infinitePlace_ = infiniteWord_;
  }
  ++rowsRead_;
  // What else an .off file says of a face, such as its colour, stands in the rest of the line.
  const bool isFace = element.properties.back().name == "vertex_indices";
  if (encoding_ == Encoding::Text && (isFace || restOfLine_)) at_ = std::min(text_.find('\n', at_), text_.size());
  return true;
}

/// Passes over elements until the one that is wanted, from the first again where it lies behind.
bool PolygonFile::skipTo(const std::string& name) {
  const std::size_t wanted = static_cast<std::size_t>(element(name) - elements_.data());
  if (wanted < element_) {
    at_ = bodyAt_;
    line_ = bodyLine_;
    element_ = 0;
    rowsRead_ = 0;
  }
  for (; element_ < wanted; ++element_, rowsRead_ = 0) {
    const Element& skipped = elements_[element_];
    while (rowsRead_ < skipped.count && !skipped.properties.empty())
      if (!readRow(skipped, nullptr, nullptr)) return false;
  }
  return true;
}

bool PolygonFile::readVertex(double (&place)[3]) {
  return skipTo("vertex") && readRow(elements_[element_], &place, nullptr);
}

bool PolygonFile::readFace(std::vector<std::int64_t>& corners) {
  corners.clear();
  return skipTo(facesAre_) && readRow(elements_[element_], nullptr, &corners);
}

}  // namespace mien
