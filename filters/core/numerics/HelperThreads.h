#pragma once

#include <system_error>
#include <thread>
#include <vector>

namespace mien {

/// Threads that are joined whatever happens; where the system gives no more, fewer do the work.
class HelperThreads {
 public:
  HelperThreads() = default;
  ~HelperThreads() { join(); }
  HelperThreads(const HelperThreads&) = delete;
  HelperThreads& operator=(const HelperThreads&) = delete;

  /// @return whether there is a thread for it
  template <class Function>
  bool start(const Function& function) {
    try {
      threads_.emplace_back(function);
    } catch (const std::system_error&) {
      return false;
    }
    return true;
  }
  void join() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace mien
