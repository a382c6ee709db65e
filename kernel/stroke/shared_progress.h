#pragma once
// Progress of work that many threads share.

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

namespace burin::detail {

/// Counts what is done, and tells the share of `all` from the thread that made this: the others
/// must not call back.
class SharedProgress {
 public:
  SharedProgress(double all, const std::function<void(double)>& report)
      : all_(all), report_(report) {}

  void add(std::size_t count) {
    const std::size_t sum = done_ += count;
    if (std::this_thread::get_id() == caller_) report_(static_cast<double>(sum) / all_);
  }

 private:
  double all_;
  const std::function<void(double)>& report_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<std::size_t> done_{0};
};

}  // namespace burin::detail
