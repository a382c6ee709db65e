#include "thread_sizes.h"

#include <burin/threads/metric.h>
#include <burin/threads/unified.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace burin::detail {
namespace {

// In the order of FreeCAD 0.20, which stores numbers.
constexpr auto kCoarse = std::to_array<std::string_view>(
    {"M1",   "M1.1", "M1.2", "M1.4", "M1.6", "M1.8", "M2",  "M2.2", "M2.5", "M3",
     "M3.5", "M4",   "M4.5", "M5",   "M6",   "M7",   "M8",  "M9",   "M10",  "M11",
     "M12",  "M14",  "M16",  "M18",  "M20",  "M22",  "M24", "M27",  "M30",  "M33",
     "M36",  "M39",  "M42",  "M45",  "M48",  "M52",  "M56", "M60",  "M64",  "M68"});
constexpr auto kFine = std::to_array<std::string_view>(
    {"M1x0.2",    "M1.1x0.2",  "M1.2x0.2", "M1.4x0.2",  "M1.6x0.2", "M1.8x0.2", "M2x0.25",
     "M2.2x0.25", "M2.5x0.35", "M3x0.35",  "M3.5x0.35", "M4x0.5",   "M4.5x0.5", "M5x0.5",
     "M5.5x0.5",  "M6x0.75",   "M7x0.75",  "M8x0.75",   "M8x1",     "M9x0.75",  "M9x1",
     "M10x0.75",  "M10x1",     "M10x1.25", "M11x0.75",  "M11x1",    "M12x1",    "M12x1.25",
     "M12x1.5",   "M14x1",     "M14x1.25", "M14x1.5",   "M15x1",    "M15x1.5",  "M16x1",
     "M16x1.5",   "M17x1",     "M17x1.5",  "M18x1",     "M18x1.5",  "M18x2",    "M20x1",
     "M20x1.5",   "M20x2",     "M22x1",    "M22x1.5",   "M22x2",    "M24x1",    "M24x1.5",
     "M24x2",     "M25x1",     "M25x1.5",  "M25x2",     "M27x1",    "M27x1.5",  "M27x2",
     "M28x1",     "M28x1.5",   "M28x2",    "M30x1",     "M30x1.5",  "M30x2",    "M30x3",
     "M32x1.5",   "M32x2",     "M33x1.5",  "M33x2",     "M33x3",    "M35x1.5",  "M35x2",
     "M36x1.5",   "M36x2",     "M36x3",    "M39x1.5",   "M39x2",    "M39x3",    "M40x1.5",
     "M40x2",     "M40x3",     "M42x1.5",  "M42x2",     "M42x3",    "M42x4",    "M45x1.5",
     "M45x2",     "M45x3",     "M45x4",    "M48x1.5",   "M48x2",    "M48x3",    "M48x4",
     "M50x1.5",   "M50x2",     "M50x3",    "M52x1.5",   "M52x2",    "M52x3",    "M52x4",
     "M55x1.5",   "M55x2",     "M55x3",    "M55x4",     "M56x1.5",  "M56x2",    "M56x3",
     "M56x4",     "M58x1.5",   "M58x2",    "M58x3",     "M58x4",    "M60x1.5",  "M60x2",
     "M60x3",     "M60x4",     "M62x1.5",  "M62x2",     "M62x3",    "M62x4",    "M64x1.5",
     "M64x2",     "M64x3",     "M64x4",    "M65x1.5",   "M65x2",    "M65x3",    "M65x4",
     "M68x1.5",   "M68x2",     "M68x3",    "M68x4",     "M70x1.5",  "M70x2",    "M70x3",
     "M70x4",     "M70x6",     "M72x1.5",  "M72x2",     "M72x3",    "M72x4",    "M72x6",
     "M75x1.5",   "M75x2",     "M75x3",    "M75x4",     "M75x6",    "M76x1.5",  "M76x2",
     "M76x3",     "M76x4",     "M76x6",    "M80x1.5",   "M80x2",    "M80x3",    "M80x4",
     "M80x6",     "M85x2",     "M85x3",    "M85x4",     "M85x6",    "M90x2",    "M90x3",
     "M90x4",     "M90x6",     "M95x2",    "M95x3",     "M95x4",    "M95x6",    "M100x2",
     "M100x3",    "M100x4",    "M100x6"});

std::optional<ThreadSize> unified(const char* series, std::int64_t number) {
  if (number < 0) return std::nullopt;
  const auto size = unified_size(series, static_cast<std::size_t>(number));
  if (!size) return std::nullopt;
  return ThreadSize{size->designation, size->diameter, size->pitch};
}

std::optional<ThreadSize> metric(std::string_view text) {
  const auto size = metric_size(text);
  if (!size) return std::nullopt;
  const auto pitch = size->pitch ? size->pitch : coarse_pitch(size->diameter);
  if (!pitch) return std::nullopt;
  return ThreadSize{std::string(text), size->diameter, *pitch};
}

}  // namespace

std::optional<ThreadSize> thread_size(std::int64_t type, std::int64_t number) {
  const auto at = [&](std::span<const std::string_view> list) {
    const bool there = number >= 0 && number < static_cast<std::int64_t>(list.size());
    return there ? list[static_cast<std::size_t>(number)] : std::string_view();
  };
  switch (type) {
    case 1:
      return metric(at(kCoarse));
    case 2:
      return metric(at(kFine));
    case 3:
      return unified("UNC", number);
    case 4:
      return unified("UNF", number);
    case 5:
      return unified("UNEF", number);
    default:
      return std::nullopt;
  }
}

}  // namespace burin::detail
