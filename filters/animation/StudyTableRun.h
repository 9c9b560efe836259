#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "MienAnimationModule.h"
#include "StudyParts.h"
#include "StudyRun.h"
#include "StudyTable.h"

namespace mien {

/// A study's file on its way to its table: what earlier runs and other ranks have done is read from the table and the
/// parts beside it, the rest of a share is computed and appended. StudyTable says what a table is.
class MIENANIMATION_EXPORT StudyTableRun {
 public:
  /// Reads the study, its faces and its frames. A StudyFailure says what is wrong.
  /// @param goOn  asked before each face; when it says no, this is not complete and must not be used
  explicit StudyTableRun(
      const std::string& study, const std::function<bool()>& goOn = [] { return true; });

  std::int64_t caseCount() const { return run_.cases().count(); }
  const Study& study() const { return run_.study(); }
  StudyRun& run() { return run_; }

  /// Looks for what is done: in the table of this name and all parts beside it. Empty: nowhere.
  void readDone(const std::string& table);
  std::int64_t missing() const { return done_->missing(); }
  bool isComplete() const { return done_->isComplete(); }

  /// How many cases of a share are not done.
  std::int64_t leftOf(const StudyRun::Share& share) const;

  /// What a computation tells and asks, on the calling thread, now and then.
  using Progress = std::function<bool(double share)>;  ///< 0 .. 1; when it says no, no case is begun

  /// How a computation ended.
  struct Outcome {
    std::int64_t computed = 0, left = 0;  ///< now; of those that were to do
    bool isComplete() const { return computed == left; }
  };

  /// Computes what is missing of a share, and appends it to TABLE.part or, for one rank of several, TABLE.rank2.part.
  /// A StudyFailure when that cannot be written.
  Outcome compute(const std::string& table, const StudyRun::Share& share, const Progress& progress);
  static std::string partOf(const std::string& table, const StudyRun::Share& share);

  using Rows = std::vector<std::vector<std::string>>;  ///< cells

  /// What was found done of a share, in its order.
  Rows doneRowsOf(const StudyRun::Share& share) const;

  /// Computes a share without any file. @return its rows so far, in their order
  Rows computedRows(const StudyRun::Share& share, const Progress& progress);

  /// Writes the finished table and takes the parts away.
  void writeTable(const std::string& table) const { done_->writeTable(table); }

 private:
  void visitCases(const StudyRun::Share& share, const std::function<void(std::int64_t)>& visit) const;
  using Append = std::function<void(std::int64_t number, const std::string& row)>;
  Outcome computeMissing(const StudyRun::Share& share, const Append& append, const Progress& progress);

  StudyRun run_;
  std::unique_ptr<StudyTable> table_;
  std::unique_ptr<StudyRows> done_;
};

}  // namespace mien
