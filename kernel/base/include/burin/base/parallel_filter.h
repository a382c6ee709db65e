#pragma once
/// Which of n things are wanted, asked on all cores.

#include <burin/base/parallel.h>

#include <cstddef>
#include <vector>

namespace burin {

/// The numbers below n for which `wanted(number)` holds, ascending, for any number of threads.
/// `grain`, `context` and what is thrown: as in parallel_for.
template <class Number, class Wanted>
std::vector<Number> parallel_filter(std::size_t n, std::size_t grain, const Wanted& wanted,
                                    const RunContext& context) {
  std::vector<std::vector<Number>> found((n + grain - 1) / grain);
  parallel_for(
      n, grain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Number>& out = found[begin / grain];
        for (std::size_t i = begin; i < end; ++i) {
          if (wanted(static_cast<Number>(i))) out.push_back(static_cast<Number>(i));
        }
      },
      &context);
  std::vector<Number> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace burin
