#pragma once
// From the bytes of a file to samples.

#include "bytes.h"
#include "layout.h"

#include <vector>

namespace burin::volume {

// The samples that `layout` says, out of `packed`: the whole file of the header where the data
// stands there too.
// Reports the share of them that is there.
std::vector<float> load_samples(Layout& layout, const Source& file, bool packed,
                                RunContext& context);

// Counts what is no finite number (or so large that its square's square is none), and sets it to
// the value that lies farthest outside. Throws where nothing else is left.
struct Finite {
  std::int64_t bad = 0;
  double min = 0, max = 0;
};
Finite make_finite(std::vector<float>& samples, bool inside_above, const std::string& file,
                   const RunContext& context);

// Shares of the samples and a level that parts them in two (Otsu 1979).
void describe(const std::vector<float>& samples, VolumeInfo& info, const RunContext& context);

}  // namespace burin::volume
