#include <burin/base/catalogue.h>
#include <burin/field/catalogue.h>

#include <utility>

namespace burin::field {
namespace {

AngleOptions angle(const FieldRequest& r) {
  return {.fallback = r.options.direction, .flat = r.flat};
}

std::vector<FieldKind> own_kinds() {
  return {
      {"smoothed", "the principal directions, made smooth", true, "",
       [](const FieldRequest& r) {
         return smoothed(r.surfaces,
                         {.alignment = r.options.alignment,
                          .fallback = r.options.direction,
                          .policy = r.options.faces,
                          .view = r.camera.direction()},
                         r.context);
       }},
      {"principal", "the principal directions as they are", true,
       "planes and spheres have no principal directions",
       [](const FieldRequest&) { return principal(); }},
      {"isophote", "lines of constant angle to the view", true, "",
       [](const FieldRequest& r) { return isophote(r.camera, angle(r)); }, false, true},
      {"isophote-light", "lines of constant angle to the light", true, "",
       [](const FieldRequest& r) { return isophote(r.light, angle(r)); }, true, true},
      {"steepest", "across the lines of constant angle to the view", true, "",
       [](const FieldRequest& r) { return steepest(r.camera, angle(r)); }},
      {"silhouette", "along the silhouettes and what is beside them", false,
       "the surface is at a right angle to the line of sight there",
       [](const FieldRequest& r) { return silhouette(r.camera); }, false, true},
      {"silhouette-across", "to and from the silhouettes", false,
       "the surface is at a right angle to the line of sight there",
       [](const FieldRequest& r) { return silhouette_across(r.camera); }},
      {"isoparametric", "parameter lines", false, "meshes and functions have no parameter lines",
       [](const FieldRequest&) { return isoparametric(); }},
      {"planes", "cuts by planes at a right angle to hatch.direction", false,
       "hatch.direction is at a right angle to the surface there",
       [](const FieldRequest& r) { return planes(r.options.direction); }, false, true},
      {"screen-vertical", "upright on the sheet", false,
       "the surface is upright and seen edge-on there",
       [](const FieldRequest& r) { return screen_vertical(r.camera); }, false, true},
      {"fixed", "hatch.direction", false, "the surface is at a right angle to the direction there",
       [](const FieldRequest& r) { return fixed(r.options.direction); }},
      {"texture-image", "across the gradient of the picture hatch.image", false,
       "the surface has no u and v there, or the picture is even",
       [](const FieldRequest& r) {
         return texture_image(r.surfaces, r.image, r.options.image_blur);
       }},
      {"texture-vector", "the direction in u and v of hatch.along_u and hatch.along_v", false,
       "the surface has no u and v there, or hatch.along_u and along_v are 0",
       [](const FieldRequest& r) {
         return texture_vector(r.surfaces, r.options.along_u, r.options.along_v);
       }},
      {"fixed-auto", "a direction that is nowhere normal to the part's surface", false, "",
       [](const FieldRequest& r) {
         return fixed_auto(r.surfaces, r.options.direction, r.context);
       }},
  };
}

GrowingCatalogue<FieldKind>& all() {
  static GrowingCatalogue<FieldKind> kinds(own_kinds());
  return kinds;
}

}  // namespace

std::span<const FieldKind> catalogue() { return all().rows(); }

void add(FieldKind kind) { all().add(std::move(kind)); }

const FieldKind& find(std::string_view name) { return find_row(catalogue(), name, "hatch.field"); }

}  // namespace burin::field
