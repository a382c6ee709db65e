#pragma once
/// Work over all faces at once, and which of them make it fail.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace burin {

struct Isolated {
  /// For each face nonzero where it was left out.
  std::vector<std::uint8_t> out;
  /// What the first failure said; empty where there was none.
  std::string reason;
};

/// Calls `work(out)` with a mark for every face that it shall leave out, none at first. Where it
/// throws, finds the last face of the shortest list 0, 1, 2 ... that fails, by halves, marks it and
/// tries again: that face fails by itself or together with one before it. After kMostIsolated faces
/// all are marked, and `work` is called once more with nothing left to do. The last call of `work`
/// is one with the marks that are returned. Cancelled passes through. Cost where nothing
/// fails: that of `work`; else log2(faces) times that for each face found.
Isolated isolate(std::size_t faces,
                 const std::function<void(const std::vector<std::uint8_t>&)>& work);

/// More broken faces than that, and the exact form of the part is not worth the time.
inline constexpr int kMostIsolated = 16;

}  // namespace burin
