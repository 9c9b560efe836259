#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mien {

class StudyTable;

std::string partName(const std::string& output);                ///< OUTPUT.part
std::string rankPartName(const std::string& output, int rank);  ///< OUTPUT.rank2.part

/// Which rows of a study's table there are, and where: in the finished table, and in the parts beside it. Memory: 16
/// bytes for each case.
class StudyRows {
 public:
  StudyRows(const StudyTable& table, std::int64_t cases);

  bool has(std::int64_t number) const { return places_[number].file >= 0; }
  std::int64_t missing() const { return missing_; }
  bool isComplete() const { return missing_ == 0; }

  /// Reads the table of that name and all parts beside it. A table of another study does not count; a part of another
  /// study is a FileFailure. Lines that are no complete row, as the end of a file may be after a crash, do not count.
  void readAll(const std::string& output);

  /// Writes the table: all rows by their number; then takes the parts away.
  void writeTable(const std::string& output, const std::string& head) const;

 private:
  struct Place {
    std::int32_t file = -1;  ///< in files_
    std::int64_t offset = 0;
  };
  void read(const std::string& name, bool mayBeOther);

  const StudyTable& table_;
  std::vector<Place> places_;
  std::int64_t missing_;
  std::vector<std::string> files_;
};

/// Where rows go as they are computed: each is one write at the end, so that a kill tears at most the last.
class PartFile {
 public:
  /// Makes the file, or cuts a torn row off the one that is there. A FileFailure when it cannot be written, or another
  /// program is writing it.
  PartFile(const std::string& name, const StudyTable& table);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::string& name() const { return name_; }

  /// A FileFailure when the disk is full.
  void append(const std::string& line);

 private:
  void cutTornLine(const std::string& head);

  std::string name_;
  int file_ = -1;
};

}  // namespace mien
