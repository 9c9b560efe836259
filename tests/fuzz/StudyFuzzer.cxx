#include <cstdint>
#include <string>

#include "Require.h"
#include "StudyTable.h"
#include "StudyText.h"

using namespace mien;

/// What is read can be written and read again; its cases have rows that are told from any other line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Study study, again;
  int line = 0;
  const std::string fault = readStudy(text, study, line);
  if (!fault.empty()) {
    require(study == again && fault.find('\n') == std::string::npos);
    return 0;
  }
  require(readStudy(writeStudy(study), again, line).empty() && study == again);
  study.addAllFrames({1.0, 2.0, 2.0});
  const StudyCases cases(study);
  if (cases.count() > Study::mostCases) return 0;
  const StudyTable table(study, cases, "");
  const StudyCase last = cases.at(cases.count() - 1);
  std::string row = table.row(last, {std::vector<double>(study.measures.size(), 0.1), text});
  require(row.find('\n') == row.size() - 1);
  row.pop_back();
  require(table.caseOf(row) == cases.count() - 1);
  table.caseOf(text);
  return 0;
}
