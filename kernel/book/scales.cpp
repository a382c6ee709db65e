#include "scales.h"

#include <burin/camera/view_grid.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace burin::detail {
namespace {

/// A page is drawn no smaller than one over this of what would fit: below, new parts are lost in
/// it.
constexpr double kMostShrunk = 2;

}  // namespace

std::vector<PageScale> common_scales(const std::vector<FittedPage>& pages,
                                     const AskedScale& asked) {
  std::map<std::string, std::vector<std::size_t>> by_assembly;
  for (std::size_t i = 0; i < pages.size(); ++i) by_assembly[pages[i].assembly].push_back(i);
  std::vector<PageScale> scales(pages.size());
  for (const auto& [name, of_one] : by_assembly) {
    // From the last, largest state of an assembly backwards.
    for (std::size_t end = of_one.size(), begin = end; end > 0; end = begin) {
      double least = pages[of_one[end - 1]].scale, largest = least;
      for (begin = end - 1; begin > 0; --begin) {
        const double before = pages[of_one[begin - 1]].scale;
        const double small = std::min(least, before), large = std::max(largest, before);
        if (large > kMostShrunk * small) break;
        least = small, largest = large;
      }
      const double most = asked.given ? std::min(least, *asked.given) : least;
      const double value = asked.iso ? standard_scale(most) : most;
      for (std::size_t i = begin; i < end; ++i) scales[of_one[i]].value = value;
    }
  }
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const bool same = i > 0 && scales[i].value == scales[i - 1].value;
    if (!same) scales[i].told = scale_text(scales[i].value);
  }
  return scales;
}

}  // namespace burin::detail
