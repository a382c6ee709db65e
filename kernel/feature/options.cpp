#include <burin/feature/options.h>

namespace burin {

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
      flag("intersections", &FeatureOptions::intersections,
           "draw the lines where parts pass through each other"),
      flag("trails", &FeatureOptions::trails,
           "draw the lines on which parts of exploded views have come"),
      options::number("crease_angle", &FeatureOptions::crease_angle, {0, 180, "degrees"},
                      "degrees between neighbouring triangles from which an edge is sharp"),
  };
  return rows;
}

}  // namespace burin
