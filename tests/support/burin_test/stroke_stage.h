#pragma once
/// One part seen through a camera, with everything that strokes need.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/view_probe.h>
#include <burin/stroke/stroke.h>
#include <burin/visibility/occluder.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace burin::test {

struct StrokeStage {
  using Wrap = std::function<std::shared_ptr<const Surface>(std::shared_ptr<const Surface>)>;

  /// On a sheet of 100 x 100 mm. `wrap` may put another surface in the place of the mesh's own.
  StrokeStage(TriMesh mesh, const char* view, std::optional<double> scale,
              std::optional<double> perspective = {}, const Wrap& wrap = {})
      : form(std::move(mesh)) {
    surface = form.realise({}, context);
    if (wrap) surface = wrap(surface);
    proxies = {&surface->proxy()};
    surfaces = {surface.get()};
    occluder = std::make_unique<Occluder>(proxies, context);
    const NamedView v = named_view(view);
    camera = Camera::fit([&](const Mat3& axes) { return form.bounds(axes); },
                         {.direction = v.direction,
                          .up = v.up,
                          .perspective = perspective,
                          .scale = scale,
                          .paper = {100, 100}});
    probe = view_probe(*occluder, camera);
  }
  StrokeResult strokes(const Field& field, double tone, const HatchOptions& options,
                       std::uint64_t seed = 1) {
    return strokes(
        field, [tone](Vec3, Vec3) { return tone; }, options, seed);
  }
  StrokeResult strokes(const Field& field, const Tone& tone, const HatchOptions& options,
                       std::uint64_t seed = 1, const tone::ToneOptions& balance = {}) {
    return trace_strokes(surfaces, camera, field, tone, probe, options, seed, context,
                         {.balance = balance});
  }

  RunContext context;
  MeshForm form;
  std::shared_ptr<const Surface> surface;
  std::vector<const ProxyMesh*> proxies;
  std::vector<const Surface*> surfaces;
  std::unique_ptr<Occluder> occluder;
  Camera camera = Camera::fit([](const Mat3&) { return Box3{Vec3(0), Vec3(1)}; }, {});
  ViewProbe probe;
};

}  // namespace burin::test
