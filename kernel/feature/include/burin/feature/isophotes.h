#pragma once
/// Lines of equal light on a surface.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace burin {

/// A light and the cosines to it at which tone changes.
struct Isophotes {
  /// From the model to the light, in model space, of any length but zero.
  Vec3 light{0, 0, 1};
  /// Ascending, between -1 and 1; each parts what is lit more from the rest.
  std::vector<double> levels;

  bool operator==(const Isophotes&) const = default;
};

/// A place of a surface over a triangle of its proxy, and its unit normal there, where these are
/// known better than from the triangles; empty: they are not. Called often.
struct ExactPlace {
  Vec3 position{0}, normal{0};
};
using ExactAt = std::function<ExactPlace(std::uint32_t face, Vec3 bary)>;

/// Levels that part the light from 0 (edge-on and turned away) to 1 into `steps` of one height,
/// each by 1e-4 too high, so that planes which meet a level exactly are on one side of it.
std::vector<double> even_levels(std::size_t steps);

/// The step of tone of a place, from 0, the darkest: how many levels its light is over. `normal` is
/// that of the side which is looked at.
std::int32_t step_of(const Isophotes& isophotes, Vec3 normal);

struct IsophoteOptions {
  ExactAt exact{};
  /// For borders of areas: without what faces away on closed components, not faired, and found in
  /// fewer steps.
  bool border = false;
  /// `light_normals` of the proxy.
  std::span<const Vec3> normals{};
};

/// Curves of a proxy on which normal . light is one of the levels, hidden ones too: of kind
/// Isophote, chained, with ends on creases and boundaries. They lie on the exact surface where
/// `exact` of the options knows it. Elsewhere normals are those between the wedges', at unit
/// length, so that circles on spheres are circles, and lines follow the rounded surface and are
/// faired as contours are. On open sheets normals count as seen. `self_hidden`: what faces away.
/// `source.face`: as of contours. Closed ones shorter than kSpeckLength are left out as noise.
/// Throws Cancelled. Cost: a pass over the triangles a level, 10 ms per million of them, and the
/// lines.
std::vector<Curve3> trace_isophotes(const ProxyMesh& proxy, std::int32_t part,
                                    const Isophotes& isophotes, const Camera& camera,
                                    const RunContext& context, const IsophoteOptions& options = {});

}  // namespace burin
