#include "placing.h"

#include <burin/base/catalogue.h>

#include "points.h"

#include <array>

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

constexpr std::array kPlacings{
    Placing{"even", "long lines at even distances", cover_cells, place_lines, even_load},
    Placing{"points", "a short stroke on each of many independent random points", cover_points,
            place_on_points, points_load, Picture::Standing::Points},
    Placing{"discs", "the same, on points that keep clear of each other", cover_discs,
            place_on_points, points_load, Picture::Standing::Points},
    Placing{"dots", "a dot on each of points that keep clear of each other", cover_discs,
            place_dots, dots_load, Picture::Standing::Dots},
};

}  // namespace

std::span<const Placing> placings() { return kPlacings; }

const Placing& find_placing(std::string_view name) {
  return find_row(placings(), name, "hatch.placing");
}

}  // namespace burin::detail

namespace burin {

bool follows_field(const HatchOptions& options) {
  return detail::find_placing(options.placing).standing != detail::Picture::Standing::Dots;
}

}  // namespace burin
