// burin_mesh_to_svg MESH STYLE OUT...: what the libraries draw without the command. The preset
// kernel_only builds nothing else; .ci/run compares its drawings with those of the whole build.
#include <burin/base/error.h>
#include <burin/converters/read.h>
#include <burin/converters/write.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "burin_mesh_to_svg MESH STYLE OUT...\n"), 2;
  try {
    burin::RunContext run;
    const std::string mesh = argv[1];
    burin::check_inputs({mesh});
    const burin::Scene scene = burin::read_scene({mesh}, {}, run);
    const burin::Style style = burin::builtin_style(argv[2]);
    const auto bounds = [&](const burin::Mat3& axes) { return scene.bounds(axes); };
    const burin::Drawing sheet =
        burin::illustrate(scene, burin::Camera::fit(bounds, {}), style, {}, run);
    for (int i = 3; i < argc; ++i) {
      burin::write_file(sheet, argv[i], burin::write_options(style), run);
    }
    return 0;
  } catch (const burin::InputError& e) {
    std::fprintf(stderr, "%s: %s\n", argv[1], e.what());
    return 3;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
