#pragma once

#include <functional>
#include <memory>
#include <string>

#include "CaseMeasures.h"
#include "MienAnimationModule.h"
#include "StudyCases.h"

namespace mien {

/// Computes the cases of a study, all or every n-th block of them, in threads: for a program, or for each rank of many.
///
/// Cases of a block (StudyBlock) share what they are compared with; a thread takes one block after the other. The
/// number of threads and ranks does not change a bit of any row.
class MIENANIMATION_EXPORT StudyRun {
 public:
  explicit StudyRun(const Study& study);
  ~StudyRun();
  StudyRun(const StudyRun&) = delete;
  StudyRun& operator=(const StudyRun&) = delete;

  /// Reads every face, and the numbers of the frames; refuses what no case could be computed of.
  /// @param goOn  asked before each face; when it says no, the rest is not looked at
  /// @return nothing, or one sentence that says which file or value is wrong
  std::string open(const std::function<bool()>& goOn = [] { return true; });

  /// Whether open() found a value wrong and not a file.
  bool faultIsOfValue() const;

  /// After open().
  const Study& study() const;
  const StudyCases& cases() const;
  const std::string& contents() const;  ///< what tells the files that were read from others of the same names

  /// Which blocks are computed: first, first + step, ...
  struct Share {
    std::int64_t first = 0, step = 1;
    int threads = 1;
  };

  /// What a run asks and tells. The first is called from several threads at once, `append` from one at a time; an
  /// exception of either ends the run and reaches the caller.
  struct Calls {
    std::function<bool(std::int64_t number)> isDone;  ///< else the case is computed
    std::function<void(const StudyCase& one, const CaseValues& measured)> append;
    std::function<bool()> goOn;  ///< asked now and then on the calling thread; when it says no, no case is begun
  };

  /// @return whether all cases of the share are done
  bool run(const Share& share, const Calls& calls);

 private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

}  // namespace mien
