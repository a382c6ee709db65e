// The main path by its stages, each a call: what `illustrate` does with one part and one style,
// without looks, haloes and the care that it takes of sheets. main_path MODEL OUT.svg
#include <burin/burin.h>
#include <burin/converters/read.h>

#include <cstdio>
#include <exception>
#include <fstream>

using namespace burin;

namespace {

// The visible stretches of curves as paths on paper, of one width where the curve has none.
Layer inked(const char* name, const std::vector<Curve3>& curves,
            const std::vector<std::vector<Span>>& spans, const Camera& eye, double width) {
  Layer layer{name, {}};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const Span& span : spans[i]) {
      if (!span.visible) continue;
      const Curve3 seen = slice(curves[i], span.begin, span.end);
      Path& path = layer.paths.emplace_back();
      path.kind = seen.kind;
      path.width = seen.widths.empty() ? std::vector{width} : seen.widths;
      path.points3 = seen.points;
      for (const Vec3& p : seen.points) path.points.push_back(eye.to_paper(p));
    }
  }
  return layer;
}

Drawing draw(const char* model, RunContext& run) {
  const Scene scene = read_scene({model}, {}, run);
  const Camera eye = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, {});
  std::vector<std::shared_ptr<const Surface>> owned;
  std::vector<const Surface*> surfaces;
  std::vector<const ProxyMesh*> proxies;
  for (const Part& part : scene.parts) {
    owned.push_back(part.form->realise({.tolerance = 0.05 / eye.scale(), .view = &eye}, run));
    surfaces.push_back(owned.back().get());
    proxies.push_back(&surfaces.back()->proxy());
  }
  Drawing sheet;
  const Occluder occluder(proxies, run);
  const field::FieldOptions choice;
  const Field field =
      field::find(choice.name)
          .make({.surfaces = surfaces, .camera = eye, .options = choice, .context = run});
  const std::vector<Curve3> strokes = trace_strokes(surfaces, eye, field, tone::make(eye, {}),
                                                    view_probe(occluder, eye), {}, 1, run)
                                          .strokes;
  const std::vector<Curve3> features = extract_features(proxies, eye, {}, sheet.diagnostics, run);
  const VisibilityMap map(occluder, proxies, eye, features, run);
  sheet.layers.push_back(inked("strokes", strokes, map.classify(strokes, {}, run), eye, 0.15));
  sheet.layers.push_back(inked("features", features, map.classify(features, {}, run), eye, 0.35));
  return sheet;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "main_path MODEL OUT.svg\n"), 2;
  try {
    RunContext run;
    std::ofstream out(argv[2], std::ios::binary);
    write_svg(draw(argv[1], run), {}, out, run);
    return out.flush() ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "main_path: %s\n", e.what());
    return 1;
  }
}
