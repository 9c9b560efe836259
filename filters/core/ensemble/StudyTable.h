#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "CaseMeasures.h"
#include "StudyCases.h"

namespace mien {

/// The table of a study as text: a comment with format, version, study and number of cases; the names of the columns,
/// which end in their units; one row per case: `case` (from 0), `id`, `face`, `scheme`, `a`, `harmonics`, `expression`,
/// `frame`, the measures, `reason` (why there is no surface). Numbers are the shortest that read back to the bit;
/// what is not there is an empty cell.
class StudyTable {
 public:
  static constexpr int version = 1;

  /// @param contents  of the files that the study names: with others it is another study
  StudyTable(const Study& study, const StudyCases& cases, std::string_view contents);

  /// The two lines before the rows, ended.
  const std::string& head() const { return head_; }

  /// A row, its line ended.
  std::string row(const StudyCase& one, const CaseValues& measured) const;

  /// The case whose complete row a line (without its end) is, or nothing.
  std::optional<std::int64_t> caseOf(std::string_view line) const;

  /// The cells of a complete row, as many as there are columns, without quotation marks.
  std::vector<std::string> cellsOf(std::string_view line) const;

 private:
  std::string prefixOf(const StudyCase& one) const;

  const Study& study_;
  const StudyCases& cases_;
  std::string head_;
};

}  // namespace mien
