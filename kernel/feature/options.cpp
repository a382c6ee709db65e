#include <burin/feature/options.h>

#include <cstdint>
#include <variant>

namespace burin {

namespace {

OptionRow<FeatureOptions> isophotes_row() {
  return {
      {"isophotes",
       "lines of equal light (isophotes) on each part, so many from the dark to the light",
       WholeRange{0, 50}},
      [](const FeatureOptions& s) { return OptionValue(std::uint64_t{s.isophotes}); },
      [](FeatureOptions& s, const OptionValue& v) { s.isophotes = std::get<std::uint64_t>(v); }};
}

}  // namespace

const std::vector<OptionRow<FeatureOptions>>& feature_option_rows() {
  using options::flag;
  static const std::vector<OptionRow<FeatureOptions>> rows = {
      flag("contours", &FeatureOptions::contours, "draw contours (silhouettes), outer and inner"),
      flag("creases", &FeatureOptions::creases, "draw sharp edges"),
      flag("boundaries", &FeatureOptions::boundaries, "draw the borders of open surfaces"),
      flag("smooth", &FeatureOptions::smooth,
           "draw the edges of CAD parts over which the surface goes on smoothly"),
      flag("seams", &FeatureOptions::seams,
           "draw the edges of CAD parts where a face meets itself"),
      isophotes_row(),
      flag("intersections", &FeatureOptions::intersections,
           "draw the lines where parts pass through each other"),
      flag("trails", &FeatureOptions::trails,
           "draw the lines on which parts of exploded views have come"),
      flag("centre_lines", &FeatureOptions::centre_lines,
           "draw the axes of round faces, and marks where they are seen along their axis"),
      flag("threads", &FeatureOptions::threads,
           "draw the threads that parts are known to have, as ISO 6410 has them"),
      options::number("crease_angle", &FeatureOptions::crease_angle, {0, 180, "degrees"},
                      "degrees between neighbouring triangles from which an edge is sharp"),
  };
  return rows;
}

}  // namespace burin
