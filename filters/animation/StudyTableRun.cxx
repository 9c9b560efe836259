#include "StudyTableRun.h"

#include <atomic>
#include <filesystem>
#include <map>

#include "StudyFailure.h"
#include "StudyText.h"
#include "TextFileReader.h"

namespace mien {

namespace {

Study readStudyFile(const std::string& name) {
  std::string text;
  std::string fault = readTextFile(name, largestStudyText, text, "study");
  if (!fault.empty()) throw StudyFailure(name + ":" + fault);
  Study study;
  int line = 0;
  fault = readStudy(text, study, line);
  if (!fault.empty()) throw StudyFailure(name + ":" + (line > 0 ? std::to_string(line) + ": " : " ") + fault);
  study.folder = std::filesystem::path(name).parent_path().string();
  return study;
}

}  // namespace

StudyTableRun::StudyTableRun(const std::string& study, const std::function<bool()>& goOn) : run_(readStudyFile(study)) {
  const std::string fault = run_.open(goOn);
  if (!goOn()) return;
  if (!fault.empty()) throw StudyFailure(run_.faultIsOfValue() ? study + ": " + fault : fault);
  table_ = std::make_unique<StudyTable>(run_.study(), run_.cases(), run_.contents());
  readDone({});
}

void StudyTableRun::readDone(const std::string& table) {
  done_ = std::make_unique<StudyRows>(*table_, caseCount());
  if (!table.empty()) done_->readAll(table);
}

StudyTableRun::Rows StudyTableRun::doneRowsOf(const StudyRun::Share& share) const {
  std::vector<std::int64_t> cases;
  visitCases(share, [&](std::int64_t number) {
    if (done_->has(number)) cases.push_back(number);
  });
  Rows rows;
  for (const std::string& line : done_->lines(cases)) rows.push_back(table_->cellsOf(line));
  return rows;
}

std::int64_t StudyTableRun::leftOf(const StudyRun::Share& share) const {
  std::int64_t left = 0;
  visitCases(share, [&](std::int64_t number) { left += !done_->has(number); });
  return left;
}

void StudyTableRun::visitCases(const StudyRun::Share& share, const std::function<void(std::int64_t)>& visit) const {
  for (std::int64_t i = share.first; i < run_.cases().blockCount(); i += share.step) {
    const StudyBlock block = run_.cases().block(i);
    for (std::int64_t number = block.first; number < block.last; ++number) visit(number);
  }
}

std::string StudyTableRun::partOf(const std::string& table, const StudyRun::Share& share) {
  return share.step > 1 ? rankPartName(table, static_cast<int>(share.first)) : partName(table);
}

StudyTableRun::Outcome StudyTableRun::computeMissing(const StudyRun::Share& share, const Append& append,
                                                     const Progress& progress) {
  const std::int64_t left = leftOf(share);
  if (left == 0) return {};
  std::atomic<std::int64_t> computed{0};
  StudyRun::Calls calls;
  calls.isDone = [this](std::int64_t number) { return done_->has(number); };
  calls.append = [&](const StudyCase& one, const CaseValues& measured) {
    append(one.number, table_->row(one, measured));
    ++computed;
  };
  calls.goOn = [&] { return progress(static_cast<double>(computed) / static_cast<double>(left)); };
  run_.run(share, calls);
  return {computed, left};
}

StudyTableRun::Outcome StudyTableRun::compute(const std::string& table, const StudyRun::Share& share,
                                              const Progress& progress) {
  PartFile part(partOf(table, share), *table_);
  readDone(table);  // again: what came before the part was ours alone
  const auto append = [&part](std::int64_t, const std::string& row) { part.append(row); };
  const Outcome outcome = computeMissing(share, append, progress);
  readDone(table);
  return outcome;
}

StudyTableRun::Rows StudyTableRun::computedRows(const StudyRun::Share& share, const Progress& progress) {
  std::map<std::int64_t, std::vector<std::string>> sorted;
  readDone({});
  const auto keep = [&](std::int64_t number, const std::string& row) {
    sorted[number] = table_->cellsOf(row.substr(0, row.size() - 1));
  };
  computeMissing(share, keep, progress);
  Rows rows;
  for (auto& [number, cells] : sorted) rows.push_back(std::move(cells));
  return rows;
}

}  // namespace mien
