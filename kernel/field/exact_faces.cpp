#include "exact_faces.h"

#include <burin/base/parallel.h>

#include "wedge_corners.h"

#include <algorithm>
#include <map>

namespace burin::field {
namespace {

constexpr std::size_t kGrain = 512;
// Radians between the normals of a face up to which it is flat whatever its equations are; over a
// sheet of 300 mm its strokes would bend by a tenth of a millimetre.
constexpr double kFlat = 1e-3;

/// Where a source face begins among the triangles sorted by it.
struct Face {
  std::size_t begin = 0, end = 0;
};

bool is_flat(const ProxyMesh& proxy, std::span<const std::uint32_t> triangles) {
  Vec3 mean(0);
  for (const std::uint32_t f : triangles) mean += proxy.mesh.area(f) * proxy.mesh.normal(f);
  mean = normalize_or(mean, Vec3(0));
  for (const std::uint32_t f : triangles) {
    if (glm::length(proxy.mesh.normal(f) - mean) > kFlat) return false;
  }
  return true;
}

}  // namespace

std::vector<FaceKind> find_face_kinds(const Surface& surface, const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  const auto& source = proxy.source_face;
  std::vector<FaceKind> kind(source.size(), FaceKind::Freeform);
  std::vector<std::uint32_t> order(source.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::ranges::stable_sort(order, {}, [&](std::uint32_t f) { return source[f]; });
  std::vector<Face> faces;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || source[order[i]] != source[order[i - 1]]) faces.push_back({i, i});
    faces.back().end = i + 1;
  }
  parallel_for(
      faces.size(), 64,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::span triangles(order.data() + faces[i].begin, order.data() + faces[i].end);
          const ProxyPoint middle{triangles.front(), Vec3(1.0 / 3)};
          FaceKind k = surface.frame(surface.lift(middle)).kind;
          // A chart may be flat whatever its equations look like; few triangles that happen to be
          // coplanar are no proof, their corners' normals are.
          if (k == FaceKind::Freeform && is_flat(proxy, triangles)) {
            const auto off = [&](std::uint32_t f) {
              const Frame at = surface.frame(surface.lift({f, Vec3(1.0 / 3)}));
              return glm::length(at.normal - proxy.mesh.normal(f)) > kFlat;
            };
            if (std::ranges::none_of(triangles, off)) k = FaceKind::Plane;
          }
          for (const std::uint32_t f : triangles) kind[f] = k;
        }
      },
      &context);
  return kind;
}

std::vector<std::uint8_t> find_balls(const ProxyMesh& proxy, const std::vector<FaceKind>& kinds) {
  std::vector<std::uint8_t> ball(static_cast<std::size_t>(proxy.region_count), 1);
  for (std::size_t f = 0; f < kinds.size(); ++f) {
    if (kinds[f] == FaceKind::Sphere || kinds[f] == FaceKind::Plane) continue;
    ball[static_cast<std::size_t>(proxy.face_region[f])] = 0;
  }
  return ball;
}

std::vector<Frame> curved_frames(const Surface& surface, const FlatPatches& flats,
                                 const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  const WedgeCorners corners(proxy);
  std::vector<Frame> frames(proxy.wedge_vertex.size());
  parallel_for(
      frames.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          Frame& best = frames[w];
          best.position = proxy.wedge_position(static_cast<std::uint32_t>(w));
          best.normal = proxy.wedge_normal[w];
          std::int32_t last = -1;
          for (const HalfEdge h : corners.of(w)) {
            const std::uint32_t f = face_of(h);
            if (flats.face_patch[f] >= 0 || proxy.source_face[f] == last) continue;
            last = proxy.source_face[f];
            ProxyPoint place{f, Vec3(0)};
            place.bary[h % 3] = 1;
            const Frame frame = surface.frame(surface.lift(place));
            const bool better = !frame.umbilic && frame.confidence > best.confidence;
            if (better || best.umbilic) best = frame;
          }
        }
      },
      &context);
  return frames;
}

}  // namespace burin::field
