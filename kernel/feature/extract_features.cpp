#include <burin/feature/feature.h>
#include <burin/feature/source_faces.h>

#include "contours.h"
#include "edge_chains.h"
#include "edge_lines.h"
#include "facing.h"
#include "fairing.h"
#include "intersections.h"
#include "tidy.h"

#include <iterator>
#include <limits>
#include <utility>

namespace burin {

namespace {

void append(std::vector<Curve3>&& from, std::vector<Curve3>& to) {
  to.insert(to.end(), std::move_iterator(from.begin()), std::move_iterator(from.end()));
}

}  // namespace

std::vector<Curve3> extract_features(std::span<const ProxyMesh* const> proxies,
                                     const Camera& camera, const FeatureOptions& options,
                                     Diagnostics& diagnostics, const RunContext& context,
                                     const MeetingParts& meeting) {
  std::vector<Curve3> curves;
  std::int64_t noise = 0;
  const bool edges =
      options.contours || options.creases || options.boundaries || options.smooth || options.seams;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    const ProxyMesh& proxy = *proxies[i];
    const Facing facing(proxy, camera, context);
    std::vector<Curve3> lines;
    if (options.contours) {
      Contours contours = trace_contours(facing, part, context);
      lines = std::move(contours.curves);
      noise += contours.noise;
    }
    if (edges) {
      const std::vector<EdgeChain> chains = chain_edges(proxy, options, context);
      append(edge_lines(facing, chains, part, options, context), lines);
    }
    join_contours(lines);
    if (proxy.source_edge.empty()) drop_specks(lines, camera);
    for (Curve3& line : lines) {
      if (line.source.edge >= 0 && !proxy.source_edge.empty()) {
        // The points of a model edge lie on a smooth curve, a chord error apart from its chords.
        constexpr double kUnknown = std::numeric_limits<double>::infinity();
        fair(line, camera, proxy.tolerance > 0 ? proxy.tolerance : kUnknown);
      }
      if (line.kind != LineClass::Contour || line.source.edge >= 0) continue;
      // Those of a cut proxy are samples of the exact line, near enough to one another.
      if (proxy.on_contour.empty()) fair(line, camera, proxy);
      if (!proxy.source_face.empty()) {
        line.source.face = main_face(source_faces(line, proxy, camera));
      }
    }
    // Straight as the facets are: they are not rounded off.
    const std::vector<EdgeChain> folds =
        options.contours ? chain_folds(proxy, facing.folds()) : std::vector<EdgeChain>();
    if (!folds.empty()) {
      append(edge_lines(facing, folds, part, options, context), lines);
      join_contours(lines);
    }
    append(std::move(lines), curves);
  }
  if (options.intersections) {
    std::vector<Curve3> lines = intersection_curves(proxies, camera, meeting, diagnostics, context);
    for (Curve3& line : lines) {
      const ProxyMesh& proxy = *proxies[static_cast<std::size_t>(line.source.part)];
      if (proxy.source_face.empty()) continue;
      line.source.face = main_face(source_faces(line, proxy, camera));
    }
    append(std::move(lines), curves);
  }
  if (noise > 0) {
    diagnostics.add(Severity::Info, "feature.noise_loops", noise,
                    "closed contours that are noise, not shape, were left out");
  }
  return curves;
}

}  // namespace burin
