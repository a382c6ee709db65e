#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin::volume {
namespace {

constexpr std::size_t kGrain = std::size_t{1} << 20;
// Values beyond this are taken for marks of "no data"; sums of their squares would overflow floats.
constexpr float kLargest = 1e18F;
constexpr std::size_t kBins = 4096;

bool good(float v) { return std::abs(v) <= kLargest; }

struct Part {
  std::int64_t bad = 0;
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
};

Part part_of(const float* begin, const float* end) {
  Part part;
  for (const float* p = begin; p < end; ++p) {
    if (!good(*p)) {
      ++part.bad;
      continue;
    }
    part.min = std::min(part.min, *p);
    part.max = std::max(part.max, *p);
  }
  return part;
}

using Histogram = std::vector<std::int64_t>;

// The first bin of the upper class of the two whose means differ most, weighed by their sizes.
std::size_t otsu(const Histogram& bins) {
  double all = 0, sum = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    all += static_cast<double>(bins[i]);
    sum += static_cast<double>(bins[i]) * static_cast<double>(i);
  }
  double low = 0, low_sum = 0, best = -1;
  // Of a whole gap between the classes its middle is taken.
  std::size_t first = 1, last = 1;
  for (std::size_t i = 0; i + 1 < bins.size(); ++i) {
    low += static_cast<double>(bins[i]);
    low_sum += static_cast<double>(bins[i]) * static_cast<double>(i);
    if (low == 0 || low == all) continue;
    const double apart = low_sum / low - (sum - low_sum) / (all - low);
    const double between = low * (all - low) * apart * apart;
    if (between > best) {
      best = between;
      first = last = i + 1;
    } else if (bins[i] == 0 && last == i) {
      last = i + 1;
    }
  }
  return (first + last) / 2;
}

}  // namespace

Finite make_finite(std::vector<float>& samples, bool inside_above, const std::string& file,
                   const RunContext& context) {
  std::vector<Part> parts((samples.size() + kGrain - 1) / kGrain);
  parallel_for(
      samples.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        parts[begin / kGrain] = part_of(samples.data() + begin, samples.data() + end);
      },
      &context);
  Part all;
  for (const Part& p : parts) {
    all.bad += p.bad;
    all.min = std::min(all.min, p.min);
    all.max = std::max(all.max, p.max);
  }
  if (all.bad == static_cast<std::int64_t>(samples.size())) {
    throw InputError("holds no finite number; are its type and byte order right?", file);
  }
  if (all.bad > 0) {
    const float outside = inside_above ? all.min : all.max;
    std::ranges::replace_if(
        samples, [](float v) { return !good(v); }, outside);
  }
  return {all.bad, all.min, all.max};
}

void describe(const std::vector<float>& samples, VolumeInfo& info, const RunContext& context) {
  const double range = info.max - info.min;
  // Whole numbers have bins of whole numbers.
  const bool whole = info.type[0] != 'f' && info.whole;
  const double width =
      whole ? std::max(1.0, std::ceil((range + 1) / static_cast<double>(kBins)))
            : std::max(range / static_cast<double>(kBins), std::numeric_limits<double>::min());
  std::vector<Histogram> parts((samples.size() + kGrain - 1) / kGrain);
  parallel_for(
      samples.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        Histogram& bins = parts[begin / kGrain];
        bins.assign(kBins, 0);
        for (std::size_t i = begin; i < end; ++i) {
          const auto bin = static_cast<std::size_t>((samples[i] - info.min) / width);
          ++bins[std::min(bin, kBins - 1)];
        }
      },
      &context);
  Histogram bins(kBins, 0);
  for (const Histogram& part : parts) {
    for (std::size_t i = 0; i < kBins; ++i) bins[i] += part[i];
  }
  const auto total = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < info.percentiles.size(); ++k) {
    const double wanted = total * VolumeInfo::kPercents[k] / 100;
    double below = 0;
    std::size_t i = 0;
    while (i + 1 < kBins && below + static_cast<double>(bins[i]) < wanted) {
      below += static_cast<double>(bins[i++]);
    }
    info.percentiles[k] =
        std::min(info.min + width * (static_cast<double>(i) + (whole ? 0 : 0.5)), info.max);
  }
  // Between two whole numbers: through none of the samples.
  info.level = info.min + width * static_cast<double>(otsu(bins)) - (whole ? 0.5 : 0);
  if (whole || !(range > 0)) return;
  // Three digits are enough where they stay among the values.
  const double step = std::pow(10.0, std::floor(std::log10(range)) - 2);
  const double rounded = std::round(info.level / step) * step;
  if (rounded > info.min && rounded < info.max) info.level = rounded;
}

}  // namespace burin::volume
