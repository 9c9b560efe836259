#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "MienAnimationModule.h"

namespace mien {

class StudyTable;

MIENANIMATION_EXPORT std::string partName(const std::string& output);                ///< OUTPUT.part
MIENANIMATION_EXPORT std::string rankPartName(const std::string& output, int rank);  ///< OUTPUT.rank2.part

/// Which rows of a study's table there are, and where: in the finished table, and in the parts beside it. Memory: 16
/// bytes for each case.
class MIENANIMATION_EXPORT StudyRows {
 public:
  StudyRows(const StudyTable& table, std::int64_t cases);

  bool has(std::int64_t number) const { return places_[number].file >= 0; }
  std::int64_t missing() const { return missing_; }
  bool isComplete() const { return missing_ == 0; }

  /// Reads the table of that name and all parts beside it. A table of another study does not count; a part of another
  /// study is a StudyFailure. Lines that are no complete row, as the end of a file may be after a crash, do not count.
  void readAll(const std::string& output);

  /// The rows of these cases, which must be there, without the ends of their lines.
  std::vector<std::string> lines(const std::vector<std::int64_t>& numbers) const;

  /// Writes the table, which must be complete: all rows by their number; then takes the parts away.
  void writeTable(const std::string& output) const;

 private:
  struct Place {
    std::int32_t file = -1;  ///< in files_
    std::int64_t offset = 0;
  };
  void read(const std::string& name, bool mayBeOther);
  void lineAt(const Place& place, std::vector<std::ifstream>& files, std::string& line) const;

  const StudyTable& table_;
  std::vector<Place> places_;
  std::int64_t missing_;
  std::vector<std::string> files_;
};

/// Where rows go as they are computed: each is one write at the end, so that a kill tears at most the last.
class MIENANIMATION_EXPORT PartFile {
 public:
  /// Makes the file, or cuts a torn row off the one that is there. A StudyFailure when it cannot be written, or another
  /// program is writing it.
  PartFile(const std::string& name, const StudyTable& table);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::string& name() const { return name_; }

  /// A StudyFailure when the disk is full.
  void append(const std::string& line);

 private:
  void cutTornLine(const std::string& head);

  std::string name_;
  int file_ = -1;
};

}  // namespace mien
