#include <burin/base/catalogue.h>
#include <burin/field/catalogue.h>
#include <burin/field/options.h>

namespace burin::field {
namespace {

std::vector<OptionRow<FacePolicy>> face_rows() {
  using options::word;
  return {
      word("plane", &FacePolicy::plane, {"differ", "direction"},
           "strokes on plane faces of CAD parts: neighbours differ, or all follow hatch.direction"),
      word("cylinder", &FacePolicy::cylinder, {"circles", "rulings"},
           "the first strokes on cylinders of CAD parts go round or along"),
      word("cone", &FacePolicy::cone, {"circles", "rulings"},
           "the first strokes on cones of CAD parts go round or along"),
      word("sphere", &FacePolicy::sphere, {"axis", "view"},
           "balls of CAD parts: circles about hatch.direction or about the line of view"),
  };
}

std::vector<OptionRow<FieldOptions>> rows() {
  std::vector<OptionRow<FieldOptions>> rows = {
      options::word("field", &FieldOptions::name, names_of(catalogue()),
                    "what strokes follow: the smoothed or raw principal directions, lines of "
                    "constant angle to the view or the light, or across them, parameter lines, "
                    "planes across hatch.direction, up on the sheet, one direction, across the "
                    "gradient of a picture, or formulas in u and v"),
      options::direction(
          "direction", &FieldOptions::direction,
          "the fixed direction, in model space, also where a surface has none of its own"),
      options::number("alignment", &FieldOptions::alignment, {0, 100},
                      "how closely the smoothed field keeps to the curvature"),
      options::number(
          "image_blur", &FieldOptions::image_blur, {0, 0.2},
          "share of its sides by which hatch.image is blurred before strokes run across "
          "its gradient (hatch.field texture-image)"),
      options::text("along_u", &FieldOptions::along_u,
                    "how far strokes go along u (hatch.field texture-vector), over u v x y z",
                    "a formula"),
      options::text("along_v", &FieldOptions::along_v, "how far they go along v meanwhile",
                    "a formula"),
  };
  options::append(rows, "", &FieldOptions::faces, face_rows());
  options::append_declared(rows, &FieldOptions::declared, catalogue());
  return rows;
}

}  // namespace

const std::vector<OptionRow<FieldOptions>>& field_option_rows() {
  static MadeOfCatalogues<std::vector<OptionRow<FieldOptions>>> all;
  return all.get(rows);
}

}  // namespace burin::field
