#include <burin/tone/options.h>

namespace burin::tone {

const std::vector<OptionRow<LambertOptions>>& lambert_option_rows() {
  using options::number;
  static const std::vector<OptionRow<LambertOptions>> rows = {
      options::direction("light", &LambertOptions::light,
                         "direction from the model to the light: right, up, towards the viewer"),
      number("ambient", &LambertOptions::ambient, {0, 1}, "lightness in full shade"),
      number("diffuse", &LambertOptions::diffuse, {0, 2}, "lightness that full light adds"),
      number("highlight", &LambertOptions::highlight, {0, 2},
             "lightness from which the paper stays white"),
      number("rim", &LambertOptions::rim, {0, 1},
             "darkness added where the surface turns away from the viewer"),
  };
  return rows;
}

}  // namespace burin::tone
