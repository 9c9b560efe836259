#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

namespace mien {

/// Remembers what profiles were settled to. One face is bound by several pipelines of a program (the face, its reach,
/// one that is compared with it), and settling is most of what binding takes; the same question has the same answer,
/// bit for bit. May be used by several threads.
class SettlementMemo {
 public:
  using Question = std::vector<double>;  ///< all that an answer follows from
  using Answer = std::vector<Eigen::VectorXd>;

  static SettlementMemo& shared();

  /// @return whether it is known
  bool find(const Question& question, Answer& answer) const;

  /// Forgets all else once there are more than `mostNumbers` in questions and answers.
  void keep(const Question& question, const Answer& answer);

  static constexpr std::size_t mostNumbers = 1 << 20;  ///< 8 MB

 private:
  mutable std::mutex mutex_;
  std::map<Question, Answer> answers_;
  std::size_t numbers_ = 0;
};

}  // namespace mien
