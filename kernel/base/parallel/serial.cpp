#include <burin/base/parallel.h>

#include <algorithm>

namespace burin {

// The same ranges as with many threads, in order: what each of them sums is the same.
void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body,
                  const RunContext* context) {
  grain = std::max<std::size_t>(grain, 1);
  for (std::size_t begin = 0; begin < n; begin += std::min(grain, n - begin)) {
    if (context) context->check();
    body(begin, begin + std::min(grain, n - begin));
  }
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
  a();
  b();
}

int thread_limit() { return 1; }

struct ThreadLimit::Impl {};

ThreadLimit::ThreadLimit(int /*threads*/) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace burin
