#pragma once
/// Loops over all cores, on TBB, whose results do not depend on the number of threads.

#include <burin/base/run_context.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace burin {

/// Calls `body(begin, end)` for the ranges [0,grain), [grain,2*grain), ... of [0,n), from several
/// threads. The ranges depend on `n` and `grain` alone, so that the sum of each range is the same
/// for any number of threads. The body writes to its own slots only. Polls `context` once per range
/// and throws Cancelled; exceptions of the body are passed on. A grain should hold 10 us to 10 ms
/// of work.
void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body,
                  const RunContext* context = nullptr);

/// Runs both functions, at the same time where a second core is free.
void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b);

/// How many threads loops may use at the most, as the system and ThreadLimit say: for programs that
/// are started to keep to it too.
int thread_limit();

/// Limits the worker threads of the process as long as it lives; 0 = no limit of its own.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
