#include "StudyParts.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "StudyFailure.h"
#include "StudyTable.h"
#include "WholeFile.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestLine = std::size_t{1} << 20;

/// OUTPUT.part and OUTPUT.rank<number>.part, those that are there, by name.
std::vector<std::string> partsOf(const std::string& output) {
  const fs::path folder = fs::path(output).has_parent_path() ? fs::path(output).parent_path() : fs::path(".");
  const std::string begin = fs::path(output).filename().string() + ".rank", end = ".part";
  std::vector<std::string> parts;
  std::error_code error;
  if (fs::exists(partName(output), error)) parts.push_back(partName(output));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool fits = name.size() > begin.size() + end.size() && name.compare(0, begin.size(), begin) == 0 &&
                      name.compare(name.size() - end.size(), end.size(), end) == 0;
    const std::string rank = fits ? name.substr(begin.size(), name.size() - begin.size() - end.size()) : "x";
    if (rank.find_first_not_of("0123456789") == std::string::npos) parts.push_back(output + ".rank" + rank + end);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// A line without its end; false for one that has none, or at the end.
bool getWholeLine(std::istream& stream, std::string& line) {
  return static_cast<bool>(std::getline(stream, line)) && !stream.eof();
}

bool startsWith(std::istream& stream, const std::string& head) {
  std::string begin(head.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return stream && begin == head;
}

}  // namespace

std::string partName(const std::string& output) {
  return output + ".part";
}

std::string rankPartName(const std::string& output, int rank) {
  return output + ".rank" + std::to_string(rank) + ".part";
}

StudyRows::StudyRows(const StudyTable& table, std::int64_t cases)
    : table_(table), places_(static_cast<std::size_t>(cases)), missing_(cases) {}

void StudyRows::readAll(const std::string& output) {
  std::error_code error;
  if (fs::is_regular_file(output, error)) read(output, true);
  for (const std::string& part : partsOf(output)) read(part, false);
}

void StudyRows::read(const std::string& name, bool mayBeOther) {
  std::ifstream stream(name, std::ios::binary);
  if (!stream) throw StudyFailure(name + ": it cannot be read (" + std::strerror(errno) + ")");
  if (!startsWith(stream, table_.head())) {
    std::error_code error;
    if (mayBeOther || fs::file_size(name, error) < table_.head().size()) return;  // torn within its head: no rows
    throw StudyFailure(
        name + ": it holds rows of another study, or of other faces; take it away, or give the table another name");
  }
  files_.push_back(name);
  std::int64_t offset = static_cast<std::int64_t>(table_.head().size());
  for (std::string line; getWholeLine(stream, line); offset += static_cast<std::int64_t>(line.size()) + 1) {
    const auto number = line.size() < longestLine ? table_.caseOf(line) : std::nullopt;
    if (!number || has(*number)) continue;
    places_[*number] = {static_cast<std::int32_t>(files_.size() - 1), offset};
    --missing_;
  }
}

std::vector<std::string> StudyRows::lines(const std::vector<std::int64_t>& numbers) const {
  std::vector<std::ifstream> files;
  for (const std::string& name : files_) files.emplace_back(name, std::ios::binary);
  std::vector<std::string> lines(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) lineAt(places_[numbers[i]], files, lines[i]);
  return lines;
}

void StudyRows::lineAt(const Place& place, std::vector<std::ifstream>& files, std::string& line) const {
  std::ifstream& source = files[place.file];
  source.seekg(place.offset);
  if (!getWholeLine(source, line)) throw StudyFailure(files_[place.file] + ": it changed while it was read");
}

void StudyRows::writeTable(const std::string& output) const {
  std::vector<std::ifstream> files;
  for (const std::string& name : files_) files.emplace_back(name, std::ios::binary);
  WholeFile file(output);
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  stream << table_.head();
  std::string line;
  for (const Place& place : places_) {
    lineAt(place, files, line);
    stream << line << "\n";
  }
  stream.close();
  if (!stream || !file.commit()) throw StudyFailure(output + ": " + WholeFile::unwritable);
  std::error_code ignored;
  for (const std::string& part : partsOf(output)) fs::remove(part, ignored);
}

PartFile::PartFile(const std::string& name, const StudyTable& table) : name_(name) {
  file_ = open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) throw StudyFailure(name + ": cannot be written (" + std::strerror(errno) + ")");
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(file_);
    throw StudyFailure(name + ": another mien is computing this study; wait for it, or give the table another name");
  }
  cutTornLine(table.head());
}

PartFile::~PartFile() {
  close(file_);
}

/// What is left ends with a whole line; an empty file begins with the head.
void PartFile::cutTornLine(const std::string& head) {
  const auto size = static_cast<std::int64_t>(lseek(file_, 0, SEEK_END));
  std::int64_t end = size;
  char last = '\0';
  while (end > 0 && pread(file_, &last, 1, end - 1) == 1 && last != '\n') --end;
  if (end < static_cast<std::int64_t>(head.size())) end = 0;
  if (end < size && ftruncate(file_, end) != 0)
    throw StudyFailure(name_ + ": cannot be written (" + std::strerror(errno) + ")");
  if (end == 0) append(head);
}

void PartFile::append(const std::string& line) {
  const ssize_t written = write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  throw StudyFailure(name_ + ": a row could not be written (" + (written < 0 ? std::strerror(errno) : "disk full") +
                     "); make room, and the same command goes on from there");
}

}  // namespace mien
