#include "SettlementMemo.h"

namespace mien {

SettlementMemo& SettlementMemo::shared() {
  static SettlementMemo memo;
  return memo;
}

bool SettlementMemo::find(const Question& question, Answer& answer) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = answers_.find(question);
  if (found == answers_.end()) return false;
  answer = found->second;
  return true;
}

void SettlementMemo::keep(const Question& question, const Answer& answer) {
  std::size_t numbers = question.size();
  for (const Eigen::VectorXd& weights : answer) numbers += static_cast<std::size_t>(weights.size());
  if (numbers > mostNumbers) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (numbers_ + numbers > mostNumbers) {
    answers_.clear();
    numbers_ = 0;
  }
  if (answers_.emplace(question, answer).second) numbers_ += numbers;
}

}  // namespace mien
