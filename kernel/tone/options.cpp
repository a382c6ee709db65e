#include <burin/base/catalogue.h>
#include <burin/tone/catalogue.h>
#include <burin/tone/options.h>

#include <string>

namespace burin::tone {
namespace {

std::vector<OptionRow<ToneOptions>> rows() {
  using options::number;
  std::string meaning;
  for (const Law& law : catalogue()) {
    meaning += (meaning.empty() ? "what makes a place light: " : "; ") + std::string(law.meaning);
  }
  std::vector<OptionRow<ToneOptions>> rows = {
      options::word("law", &ToneOptions::law, names_of(catalogue()), meaning),
      options::direction("light", &ToneOptions::light,
                         "direction from the model to the light: right, up, towards the viewer"),
      number("ambient", &ToneOptions::ambient, {0, 1}, "lightness in full shade"),
      number("diffuse", &ToneOptions::diffuse, {0, 2}, "lightness that full light adds"),
      number("reflected", &ToneOptions::reflected, {0, 1},
             "lightness that light thrown back from behind adds in the shade"),
      number("specular", &ToneOptions::specular, {0, 2},
             "lightness that the mirrored light adds (tone.law phong)"),
      number("shininess", &ToneOptions::shininess, {1, 1000},
             "how narrow the mirrored light is (tone.law phong)"),
      number("decay", &ToneOptions::decay, {0.1, 100},
             "how fast the dark falls off from the silhouettes (tone.law silhouette)"),
      number("shadow", &ToneOptions::shadow, {0, 1},
             "how much of a light is missing in the shadow that something casts (tone.law lambert, "
             "phong); 0 = no shadows"),
      number("shadow_width", &ToneOptions::shadow_width, {0, 90, "degrees"},
             "how wide a light is, in degrees: 0 casts shadows with sharp borders"),
      number("highlight", &ToneOptions::highlight, {0, 2},
             "lightness from which the paper stays white"),
      number("rim", &ToneOptions::rim, {0, 1},
             "darkness added where the surface turns away from the viewer"),
      options::word("ink", &ToneOptions::ink, {"shade", "light"},
                    "what ink represents: shade, or light, as on dark paper"),
      number("median_min", &ToneOptions::median_min, {0, 1},
             "least ink that half of the picture is to have; one exponent of all ink raises it to "
             "this",
             "median_max"),
      number("median_max", &ToneOptions::median_max, {0, 1},
             "most ink that half of the picture is to have"),
      number(
          "contrast", &ToneOptions::contrast, {0, 0.5},
          "ink by which planes differ from the faces that they meet, where 0.08 is enough for it"),
      number("gradient", &ToneOptions::gradient, {0, 0.5},
             "ink by which a slanted plane is darker at its near end than at its far one"),
  };
  options::append_declared(rows, &ToneOptions::declared, catalogue());
  return rows;
}

}  // namespace

const std::vector<OptionRow<ToneOptions>>& tone_option_rows() {
  static MadeOfCatalogues<std::vector<OptionRow<ToneOptions>>> all;
  return all.get(rows);
}

}  // namespace burin::tone
