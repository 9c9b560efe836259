#include "PolygonFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "LineCutter.h"
#include "NumberText.h"
#include "OffLayout.h"

namespace mien {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool isLineEnd(char c) {
  return c == '\r' || c == '\n';
}

bool isAxis(const std::string& name) {
  return name.size() == 1 && name[0] >= 'x' && name[0] <= 'z';
}

template <class Properties, class Test>
bool has(const Properties& properties, const Test& test) {
  return std::any_of(properties.begin(), properties.end(), test);
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
  if (name == "int64") return {8, true, false};
  if (name == "uint64") return {8, false, false};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  return {};
}

bool PolygonFile::refuse(const std::string& why) {
  fault_ = why;
  return false;
}

bool PolygonFile::readProperty(const std::vector<std::string_view>& words) {
  const bool isList = words.size() > 1 && words[1] == "list";
  if (elements_.empty() || words.size() < (isList ? 5 : 3)) return refuse("has a property that is incomplete");
  const std::string_view type = words[isList ? 3 : 1];
  const Property property{std::string(words[isList ? 4 : 2]), typeOf(type), isList ? typeOf(words[2]) : Type(), isList};
  if (isList && property.countType.bytes == 0) return refuse("has the unknown type " + inQuotes(words[2]));
  const bool canBeSkipped = encoding_ == Encoding::Text && !isList && !isAxis(property.name);
  if (property.type.bytes == 0 && !canBeSkipped) return refuse("has the unknown type " + inQuotes(type));
  elements_.back().properties.push_back(property);
  return true;
}

bool PolygonFile::readHeaderLine(const std::vector<std::string_view>& words) {
  if (words[0] == "format") {
    if (words.size() > 1 && words[1] == "binary_little_endian")
      encoding_ = Encoding::LittleEndian;
    else if (words.size() > 1 && words[1] == "binary_big_endian")
      encoding_ = Encoding::BigEndian;
    else if (words.size() < 2 || words[1] != "ascii")
      return refuse("has the unknown format " + inQuotes(words.size() > 1 ? words[1] : std::string_view()));
  } else if (words[0] == "element") {
    if (words.size() < 3) return refuse("has an element that is incomplete");
    elements_.push_back({std::string(words[1]), parseWholeNumber(words[2]).value_or(-1), {}, line_});
    if (elements_.back().count < 0) return refuse("has " + inQuotes(words[2]) + " where a count belongs");
  } else if (words[0] == "property") {
    return readProperty(words);
  }
  return true;
}

std::string_view PolygonFile::cutHeaderLine(char end) {
  const std::size_t stop = std::min(text_.find(end, at_), text_.size());
  std::string_view line = text_.substr(at_, stop - at_);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  at_ = std::min(stop + 1, text_.size());
  return line;
}

/// The first line tells what ends the others: behind the last the bytes of a binary file begin.
bool PolygonFile::readHeader() {
  const std::size_t first = lineEnd();
  const char end = first < text_.size() && text_.substr(first, 2) != "\r\n" ? text_[first] : '\n';
  std::vector<std::string_view> words;
  for (; at_ < text_.size(); ++line_) {
    splitAtBlanks(cutHeaderLine(end), words);
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

/// Where vertices and faces are, and whether they hold what is needed. Every vertex and face takes at least a byte.
bool PolygonFile::findElements() {
  const Element* const vertex = element("vertex");
  if (!vertex || vertex->count == 0) return refuseElement("vertex", "gives no vertices");
  for (const char* axis : {"x", "y", "z"})
    if (!has(vertex->properties, [&](const auto& property) { return property.name == axis && !property.isList; }))
      return refuseElement("vertex", std::string("gives the vertices no property ") + axis);
  if (!findFaces()) return false;
  for (const Element& each : elements_)
    if ((each.name == "vertex" || each.name == facesAre_) &&
        static_cast<std::uint64_t>(each.count) > text_.size() - at_)
      return refuseElement(each.name, "promises more vertices or faces than the file holds");
  vertices_ = vertex->count;
  verticesAt_ = static_cast<std::size_t>(vertex - elements_.data());
  bodyAt_ = at_;
  bodyLine_ = line_;
  inHeader_ = false;
  return true;
}

bool PolygonFile::findFaces() {
  const Element* faces = element("face");
  if ((!faces || faces->count == 0) && element("tristrips")) facesAre_ = "tristrips";
  faces = element(facesAre_);
  if (!faces) return true;
  const auto isCorners = [](const auto& property) { return property.isList && isCornerList(property.name); };
  if (faces->count > 0 && !has(faces->properties, isCorners))
    return refuseElement(facesAre_, "gives the faces no list vertex_indices");
  faces_ = faces->count;
  facesAt_ = static_cast<std::size_t>(faces - elements_.data());
  return true;
}

/// A byte order mark, which no line ends, is passed over.
void PolygonFile::begin(std::string_view text) {
  text_ = text;
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark) at_ = byteOrderMark.size();
}

bool PolygonFile::isPly(std::string_view text) {
  PolygonFile file;
  file.begin(text);
  return file.skipCommentsAndBlanks() && text.substr(file.at_, 3) == "ply";
}

bool PolygonFile::openPly(std::string_view text) {
  begin(text);
  if (!skipCommentsAndBlanks() || !isPly(text)) return refuse("does not begin with \"ply\"");
  return readHeader() && findElements();
}

/// "OFF" as text or binary, with the letters ST, C and N before it for what else is told of a vertex. Text may begin
/// with the counts at once.
bool PolygonFile::openOff(std::string_view text) {
  begin(text);
  if (!skipCommentsAndBlanks()) return refuse("is cut off, the file ends");
  const std::string_view first = text.substr(at_, lineEnd() - at_);
  if (parseWholeNumber(first.substr(0, first.find_first_of(" \t")))) return openOffText(false);
  int moreWords = 0;
  bool hasColours = false;
  for (const auto& [letters, words] : {std::pair<std::string_view, int>{"ST", 2}, {"C", 0}, {"N", 3}}) {
    if (text.substr(at_, letters.size()) != letters) continue;
    at_ += letters.size();
    moreWords += words;
    hasColours = hasColours || letters == "C";
  }
  const std::string_view magic = text.substr(at_, 3);
  if (magic != "OFF" && magic != "off")
    return refuse("begins with " + inQuotes(first) + " where OFF, COFF, NOFF or STOFF belongs");
  at_ += 3;
  const bool isBinary = first.substr(0, first.find('#')).find("BINARY") != std::string_view::npos;
  return isBinary ? openOffBytes(moreWords, hasColours) : openOffText(moreWords > 0 || hasColours);
}

bool PolygonFile::openOffText(bool hasMore) {
  const Type real{8, true, true}, whole{4, true, false};
  double counts[3] = {};
  for (double& count : counts) {
    if (&count == counts + 2 && endsLine()) break;  // some leave out the number of edges
    if (!nextWord(count)) return false;
    if (count < 0.0) return refuse("promises fewer vertices or faces than none");
    if (!(count < 1e15 && count == std::floor(count))) return refuse("has a count that is none");
  }
  const auto vertices = static_cast<std::int64_t>(counts[0]), faces = static_cast<std::int64_t>(counts[1]);
  elements_ = {{"vertex", vertices, {{"x", real, {}}, {"y", real, {}}, {"z", real, {}}}, line_},
               {"face", faces, {{"vertex_indices", whole, whole, true}}, line_}};
  skipsRestOfVertex_ = hasMore || hasLinePerRow(vertices + faces);
  skipsRestOfFace_ = true;  // its colour
  return findElements();
}

/// Whether there are lines enough for every vertex and face to have its own; then colours may stand behind a place,
/// whatever the header says.
bool PolygonFile::hasLinePerRow(std::int64_t rows) const {
  LineCutter lines(text_.substr(at_));
  for (std::string_view line; rows > 0 && lines.next(line);) {
    const auto first = std::find_if_not(line.begin(), line.end(), isBlank);
    if (first != line.end() && *first != '#') --rows;
  }
  return rows == 0;
}

bool PolygonFile::openOffBytes(int moreWords, bool hasColours) {
  at_ = std::min(text_.find('\n', at_), text_.size());
  const std::string_view body = text_.substr(std::min(at_ + 1, text_.size()));
  const auto layout = offLayoutOf(body, moreWords, hasColours);
  if (!layout)
    return refuse(
        "promises more vertices or faces, or fewer, than lie between it and the file's end (in neither order "
        "of bytes)");
  at_ += 1 + OffLayout::headerBytes;
  encoding_ = layout->isBigEndian ? Encoding::BigEndian : Encoding::LittleEndian;
  const Type real{4, true, true}, whole{4, false, false};
  elements_ = {{"vertex", layout->vertices, {{"x", real, {}}, {"y", real, {}}, {"z", real, {}}}, line_},
               {"face", layout->faces, {{"vertex_indices", whole, whole, true}}, line_}};
  for (int i = 0; i < layout->moreVertexWords; ++i) elements_[0].properties.push_back({"more", real, {}});
  if (layout->hasColourCounts) elements_[1].properties.push_back({"colour", real, whole, true});
  for (int i = 0; i < layout->colourWords; ++i) elements_[1].properties.push_back({"colour", real, {}});
  return findElements();
}

bool PolygonFile::endsLine() const {
  const std::size_t next = text_.find_first_not_of(" \t", at_);
  return next == std::string_view::npos || isLineEnd(text_[next]) || text_[next] == '#';
}

std::size_t PolygonFile::lineEnd() const {
  return static_cast<std::size_t>(std::find_if(text_.begin() + at_, text_.end(), isLineEnd) - text_.begin());
}

/// Comments reach to the end of their line. @return whether something follows
bool PolygonFile::skipCommentsAndBlanks() {
  for (; at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '#'); ++at_) {
    if (text_[at_] == '#') at_ = lineEnd();
    if (at_ == text_.size()) break;
    line_ += text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_ + 1, 1) != "\n");
  }
  return at_ < text_.size();
}

/// The next number of the text.
bool PolygonFile::nextWord(double& value) {
  if (!skipCommentsAndBlanks()) return refuse("is cut off, the file ends");
  const char *const begin = text_.data() + at_, *const end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(begin + (*begin == '+'), end, value);
  if (error == std::errc::result_out_of_range)
    value = outOfRangeNumber(text_.substr(at_, static_cast<std::size_t>(stop - begin)));
  const bool isWhole = error != std::errc::invalid_argument && (stop == end || isBlank(*stop) || *stop == '#');
  if (!isWhole || !std::isfinite(value)) {
    const std::string_view rest = text_.substr(at_, 80);
    const std::string_view word = rest.substr(0, std::min(rest.find_first_of(" \t\r\n"), rest.size()));
    if (!isWhole) return refuse("has " + inQuotes(word) + " where a number belongs");
    infiniteWord_ = word;
  }
  at_ = static_cast<std::size_t>(stop - text_.data());
  return true;
}

/// A word of an unknown type, such as a name.
bool PolygonFile::skipWord() {
  if (!skipCommentsAndBlanks()) return refuse("is cut off, the file ends");
  while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
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
  if (type.bytes == 4) return type.isSigned ? numberFrom<std::int32_t>(bytes) : numberFrom<std::uint32_t>(bytes);
  return type.isSigned ? numberFrom<std::int64_t>(bytes) : numberFrom<std::uint64_t>(bytes);
}

bool PolygonFile::next(const Type& type, double& value) {
  if (encoding_ == Encoding::Text) return type.bytes == 0 ? skipWord() : nextWord(value);
  if (text_.size() - at_ < static_cast<std::size_t>(type.bytes)) return refuse("is cut off, the file ends");
  value = binaryValue(type);
  at_ += static_cast<std::size_t>(type.bytes);
  return true;
}

/// No list has more numbers than the bytes behind it can hold, and a text needs a byte between two.
bool PolygonFile::readList(const Property& property, std::vector<std::int64_t>* corners) {
  double count, value;
  if (!next(property.countType, count)) return false;
  const bool isText = encoding_ == Encoding::Text;
  const std::size_t left = text_.size() - at_;
  const std::size_t most = isText ? (left + 1) / 2 : left / static_cast<std::size_t>(property.type.bytes);
  if (!(count >= 0.0 && count <= static_cast<double>(most) && count == std::floor(count)))
    return refuse("is a list of " + numberText(count) + " numbers, for which the file has no room");
  const bool kept = corners && isCornerList(property.name);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
    if (!next(property.type, value)) return false;
    if (kept) corners->push_back(std::abs(value) < 1e18 ? static_cast<std::int64_t>(value) : -1);
  }
  return true;
}

bool PolygonFile::readRow(const Element& element, double (*place)[3], std::vector<std::int64_t>* corners) {
  if (encoding_ == Encoding::Text && !element.properties.empty()) skipCommentsAndBlanks();
  rowLine_ = line_;
  for (const Property& property : element.properties) {
    double value;
    if (property.isList ? !readList(property, corners) : !next(property.type, value)) return false;
    if (!place || !isAxis(property.name) || property.isList) continue;
    (*place)[property.name[0] - 'x'] = value;
    if (!std::isfinite(value)) infinitePlace_ = infiniteWord_;
  }
  ++rowsRead_;
  if (corners ? skipsRestOfFace_ : skipsRestOfVertex_) at_ = lineEnd();
  return true;
}

/// Passes over elements until the one that is wanted, from the first again where it lies behind.
bool PolygonFile::skipTo(std::size_t wanted) {
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
  return skipTo(verticesAt_) && readRow(elements_[element_], &place, nullptr);
}

bool PolygonFile::readFace(std::vector<std::int64_t>& corners) {
  corners.clear();
  return skipTo(facesAt_) && readRow(elements_[element_], nullptr, &corners);
}

}  // namespace mien
