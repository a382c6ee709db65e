#include <burin/base/parallel.h>

#include "task_order.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace burin {

void parallel_for(std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body,
                  const RunContext* context) {
  if (n == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (n + grain - 1) / grain;
  const auto range = [&](std::size_t chunk) {
    if (context) context->check();
    body(chunk * grain, std::min(n, (chunk + 1) * grain));
  };
  if (chunks == 1) return range(0);
  detail::TaskOrder order;
  // By itself: where a loop beside this one throws, TBB would end this one too, without a word to
  // who called it and believes that all ranges are done.
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_for(
      std::size_t{0}, chunks,
      [&](std::size_t chunk) {
        [[maybe_unused]] const detail::TaskOrder::Task task(order);
        range(chunk);
      },
      alone);
}

void parallel_invoke(const std::function<void()>& a, const std::function<void()>& b) {
  detail::TaskOrder order;
  const auto task_of = [&order](const std::function<void()>& body) {
    return [&order, &body] {
      [[maybe_unused]] const detail::TaskOrder::Task task(order);
      body();
    };
  };
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_invoke(task_of(a), task_of(b), alone);
}

int thread_limit() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

struct ThreadLimit::Impl {
  explicit Impl(std::size_t threads)
      : control(tbb::global_control::max_allowed_parallelism, threads) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : impl_(threads > 0 ? std::make_unique<Impl>(static_cast<std::size_t>(threads)) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace burin
