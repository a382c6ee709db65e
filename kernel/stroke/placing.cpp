#include "placing.h"

#include <burin/base/catalogue.h>
#include <burin/stroke/marks.h>

#include "level_phase.h"
#include "points.h"

#include <utility>

namespace burin::detail {
namespace {

Placing::Load even_load(const Picture& picture, double ink) {
  return {.length = 1 / picture.spacing(ink)};
}

// Long lines come from the phase of the whole picture and not from points.
std::vector<Family> place_lines(const Picture& picture, const ViewRaster& raster,
                                const std::vector<Seed>& /*seeds*/, int families,
                                const RunContext& context,
                                const std::function<void(double)>& progress) {
  return place_families(picture, raster, families, context, progress);
}

// Lines of all steps of a level, whatever the tone wants of them.
std::vector<Family> place_levels(const Picture& picture, const ViewRaster& raster,
                                 const std::vector<Seed>& /*seeds*/, int /*families*/,
                                 const RunContext& context,
                                 const std::function<void(double)>& progress) {
  Picture stepped = picture.following(picture.field);
  stepped.level_step = level_step(picture, raster, context);
  if (stepped.level_step > 0) return place_families(stepped, raster, 1, context, progress);
  std::vector<Family> none;
  none.push_back({{}, SampleGrid({0, 0}, {0, 0}, 1)});
  return none;
}

GrowingCatalogue<Placing>& all() {
  static GrowingCatalogue<Placing> placings({
      {"even", "long lines at even distances", cover_cells, place_lines, even_load},
      {"points", "a short stroke on each of many independent random points", cover_points,
       place_on_points, points_load, Picture::PlacementKind::Points},
      {"discs", "the same, on points that keep clear of each other", cover_discs, place_on_points,
       points_load, Picture::PlacementKind::Discs},
      {"dots", "a dot on each of points that keep clear of each other", cover_discs, place_dots,
       dots_load, Picture::PlacementKind::Dots},
      {"levels", "a line wherever what the field keeps is a whole number of hatch.level_step",
       cover_cells, place_levels, even_load, Picture::PlacementKind::Levels},
  });
  return placings;
}

GrowingCatalogue<MarkKind>& all_marks() {
  static GrowingCatalogue<MarkKind> kinds({});
  return kinds;
}

}  // namespace

std::span<const Placing> placings() { return all().rows(); }

const MarkKind* find_mark(std::string_view name) {
  const auto found = std::ranges::find(mark_kinds(), name, &MarkKind::name);
  return found == mark_kinds().end() ? nullptr : &*found;
}

const Placing& find_placing(std::string_view name) {
  return find_row(placings(), name, "hatch.placing");
}

}  // namespace burin::detail

namespace burin {

std::span<const MarkKind> mark_kinds() { return detail::all_marks().rows(); }

void add(MarkKind kind) {
  detail::all().add({kind.name, kind.meaning, detail::cover_discs, detail::place_on_points,
                     detail::points_load, detail::Picture::PlacementKind::Discs});
  detail::all_marks().add(std::move(kind));
}

bool follows_field(const HatchOptions& options) {
  return detail::find_placing(options.placing).placement_kind !=
         detail::Picture::PlacementKind::Dots;
}

bool uses_level_lines(const HatchOptions& options) {
  return detail::find_placing(options.placing).placement_kind ==
         detail::Picture::PlacementKind::Levels;
}

bool takes_motif(const HatchOptions& options) {
  using enum detail::Picture::PlacementKind;
  const auto placement_kind = detail::find_placing(options.placing).placement_kind;
  return (placement_kind == Points || placement_kind == Discs) &&
         !detail::find_mark(options.placing);
}

}  // namespace burin
