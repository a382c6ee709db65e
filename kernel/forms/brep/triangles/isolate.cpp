#include "isolate.h"

#include <burin/base/error.h>

#include <algorithm>
#include <exception>
#include <numeric>

namespace burin {
namespace {

using Marks = std::vector<std::uint8_t>;
using Work = std::function<void(const Marks&)>;

/// Whether `work` is done; what it threw otherwise. Being cancelled and being out of memory are not
/// the fault of a face.
bool done(const Work& work, const Marks& out, std::string& reason) {
  try {
    work(out);
    return true;
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    if (reason.empty()) reason = e.what();
    return false;
  }
}

/// `out`, and all faces from `end` on.
Marks marks_before(const Marks& out, std::size_t end) {
  Marks marks = out;
  std::fill(marks.begin() + static_cast<std::ptrdiff_t>(end), marks.end(), std::uint8_t{1});
  return marks;
}

/// The face without which the faces before it work, and with which they fail.
std::size_t culprit(const Work& work, const Marks& out, std::string& reason) {
  std::size_t works = 0, fails = out.size();
  while (fails - works > 1) {
    const std::size_t middle = std::midpoint(works, fails);
    (done(work, marks_before(out, middle), reason) ? works : fails) = middle;
  }
  return works;
}

}  // namespace

Isolated isolate(std::size_t faces, const Work& work) {
  Isolated result{Marks(faces, 0), {}};
  for (int found = 0; !done(work, result.out, result.reason); ++found) {
    if (found == kMostIsolated) {
      std::ranges::fill(result.out, std::uint8_t{1});
      work(result.out);
      break;
    }
    result.out[culprit(work, result.out, result.reason)] = 1;
  }
  return result;
}

}  // namespace burin
