#include "stroke_kinds.h"

#include <burin/base/error.h>
#include <burin/options/meant.h>

#include "style_table.h"

#include <fmt/format.h>

#include <array>

namespace burin {
namespace detail {

void dotted(HatchStyle& hatch) {
  hatch.placing = "dots";
  hatch.spacing_min = 0.3;
  hatch.width_min = 0.16;
  hatch.width_max = 0.4;
  hatch.tone_min = 0.02;
  hatch.length_min = 0;
}

void pencilled(HatchStyle& hatch) {
  hatch.placing = "discs";
  hatch.length = 5;
  hatch.taper = 2;
  hatch.width_min = 0.09;
  hatch.width_max = 0.2;
  hatch.tone_min = 0.02;
}

}  // namespace detail

namespace {

using detail::dotted;
using detail::pencilled;

struct Kind {
  std::string_view name, meaning;
  void (*make)(StrokeKind&);
};

constexpr std::array kKinds{
    Kind{"hatching", "long lines at even distances",
         [](StrokeKind& k) {
           k.hatch.placing = "even";
           k.hatch.cross_from = 2;
         }},
    Kind{"pencil", "short, thin strokes on points that keep clear of each other",
         [](StrokeKind& k) {
           pencilled(k.hatch);
           k.hatch.cross_from = 2;
         }},
    Kind{"dots", "dots on points that keep clear of each other",
         [](StrokeKind& k) { dotted(k.hatch); }},
    Kind{"silhouette", "short strokes along the silhouettes, dense beside them",
         [](StrokeKind& k) {
           pencilled(k.hatch);
           k.hatch.cross_from = 2;
           k.hatch.field.name = "silhouette";
           k.tone.law = "silhouette";
         }},
};

}  // namespace

std::vector<StyleInfo> stroke_kinds() {
  std::vector<StyleInfo> kinds;
  for (const Kind& k : kKinds) kinds.push_back({std::string(k.name), std::string(k.meaning)});
  return kinds;
}

void detail::become(std::string_view kind, StrokeKind& strokes) {
  std::vector<std::string> names;
  for (const Kind& k : kKinds) {
    if (k.name == kind) return k.make(strokes);
    names.emplace_back(k.name);
  }
  throw UsageError(fmt::format("unknown kind of strokes '{}'{} (all: {})", kind,
                               hint(kind, known_words(names)), fmt::join(names, ", ")));
}

}  // namespace burin
