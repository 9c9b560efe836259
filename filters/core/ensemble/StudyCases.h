#pragma once

#include "Study.h"

namespace mien {

/// One case of a study: a face state and how a table names it.
struct StudyCase {
  std::int64_t number = 0;  ///< from 0
  std::string id;           ///< 16 hexadecimal digits, the same wherever the same parameters stand in a study
  std::size_t face = 0, pose = 0;
  FaceState state;
};

/// Cases that differ in a alone, first .. last - 1: what they are compared with is made once.
struct StudyBlock {
  std::int64_t first = 0, last = 0;
};

/// The product of a study's lists, by number: a changes fastest, then scheme, N, pose, face. No list of it is ever
/// made.
class StudyCases {
 public:
  static constexpr std::int64_t longestBlock = 16;

  /// The study must have no more than Study::mostCases and outlive this.
  explicit StudyCases(const Study& study);

  std::int64_t count() const { return count_; }
  StudyCase at(std::int64_t number) const;

  std::int64_t blockCount() const { return count_ / smoothingCount_ * blocksPerScheme_; }
  StudyBlock block(std::int64_t number) const;

 private:
  std::string idOf(const StudyCase& one) const;

  const Study& study_;
  std::int64_t smoothingCount_, blocksPerScheme_, count_;
};

}  // namespace mien
