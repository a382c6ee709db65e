#include "exact_faces.h"

#include <burin/base/parallel.h>
#include <burin/mesh/corners.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace burin::field {
namespace {

constexpr std::size_t kExactGrain = 512;
// Radians between the normals of a face up to which it is flat whatever its equations are; over a
// sheet of 300 mm its strokes would bend by a tenth of a millimetre.
constexpr double kFlat = 1e-3;

/// Where a source face begins among the triangles sorted by it.
struct Face {
  std::size_t begin = 0, end = 0;
};

// Triangles of a face that are looked at, at most.
constexpr std::size_t kSamples = 64;
// Radii of a sphere differ by no more than this share.
constexpr double kRoundPatch = 1e-3;

Vec3 mean_normal(const ProxyMesh& proxy, std::span<const std::uint32_t> triangles) {
  Vec3 mean(0);
  for (const std::uint32_t f : triangles) mean += proxy.mesh.area(f) * proxy.mesh.normal(f);
  return normalize_or(mean, Vec3(0));
}

// The kind of a face by its shape: CAD programs write planes and balls as B-splines and surfaces of
// revolution too.
FaceKind kind_by_shape(const Surface& surface, std::span<const std::uint32_t> triangles) {
  const ProxyMesh& proxy = surface.proxy();
  const Vec3 mean = mean_normal(proxy, triangles);
  const std::size_t stride = (triangles.size() + kSamples - 1) / kSamples;
  bool flat = true, round = true;
  double k = 0;
  for (std::size_t i = 0; i < triangles.size() && (flat || round); i += stride) {
    const Frame at = surface.frame(surface.lift({triangles[i], Vec3(1.0 / 3)}));
    flat = flat && glm::length(at.normal - mean) <= kFlat;
    const double own = 0.5 * (at.k1 + at.k2);
    if (i == 0) k = own;
    round = round && at.umbilic && k != 0 && std::abs(own - k) <= kRoundPatch * std::abs(k);
  }
  return flat ? FaceKind::Plane : round ? FaceKind::Sphere : FaceKind::Freeform;
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
      faces.size(), 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::span triangles(order.data() + faces[i].begin, order.data() + faces[i].end);
          const ProxyPoint middle{triangles.front(), Vec3(1.0 / 3)};
          FaceKind k = surface.frame(surface.lift(middle)).kind;
          if (k == FaceKind::Freeform || k == FaceKind::Torus) {
            const FaceKind shape = kind_by_shape(surface, triangles);
            if (shape != FaceKind::Freeform) k = shape;
          }
          for (const std::uint32_t f : triangles) kind[f] = k;
        }
      },
      &context);
  return kind;
}

namespace {

// How the border of a region runs: the sum of t t^T over its edges, by length.
using Runs = std::array<double, 6>;  // xx yy zz xy xz yz

Vec3 times(const Runs& m, Vec3 v) {
  return {m[0] * v.x + m[3] * v.y + m[4] * v.z, m[3] * v.x + m[1] * v.y + m[5] * v.z,
          m[4] * v.x + m[5] * v.y + m[2] * v.z};
}

// The direction that the border runs at a right angle to: the eigenvector of the least eigenvalue,
// by power iteration on (trace - m).
std::optional<Vec3> axis_of(const Runs& runs) {
  constexpr int kSteps = 200;
  // The border runs along its axis for no more than this share, and further round it than that.
  constexpr double kAlong = 0.15, kAround = 0.2;
  const double trace = runs[0] + runs[1] + runs[2];
  if (!(trace > 0)) return std::nullopt;
  Vec3 axis = glm::normalize(Vec3(0.61, 0.53, 0.59));
  for (int i = 0; i < kSteps; ++i) {
    axis = normalize_or(trace * axis - times(runs, axis), Vec3(0, 0, 1));
  }
  const double along = glm::dot(axis, times(runs, axis));
  // The middle eigenvalue: of a straight border there are many axes.
  const Vec3 x = any_orthogonal(axis), y = glm::cross(axis, x);
  const double a = glm::dot(x, times(runs, x)), b = glm::dot(y, times(runs, y)),
               c = glm::dot(x, times(runs, y));
  const double middle = 0.5 * (a + b) - std::hypot(0.5 * (a - b), c);
  if (along > kAlong * trace || middle < kAround * trace) return std::nullopt;
  return axis;
}

}  // namespace

BallAxes find_balls(const ProxyMesh& proxy, const std::vector<FaceKind>& kinds,
                    const SmoothedOptions& options) {
  const auto count = static_cast<std::size_t>(proxy.region_count);
  std::vector<std::uint8_t> ball(count, 1);
  std::vector<Runs> runs(count, Runs{});
  for (std::size_t f = 0; f < kinds.size(); ++f) {
    const auto region = static_cast<std::size_t>(proxy.face_region[f]);
    if (kinds[f] != FaceKind::Sphere) {
      ball[region] = 0;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (proxy.edge_kind[3 * f + k] == EdgeKind::Smooth) continue;
      const Triangle& t = proxy.mesh.triangles[f];
      const Vec3 e = proxy.mesh.positions[t[(k + 1) % 3]] - proxy.mesh.positions[t[k]];
      const double length = glm::length(e);
      if (!(length > 0)) continue;
      const double products[6] = {e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.x * e.z, e.y * e.z};
      for (std::size_t i = 0; i < 6; ++i) runs[region][i] += products[i] / length;
    }
  }
  const bool view = options.policy.sphere == FacePolicy::Sphere::View;
  const Vec3 given = normalize_or(view ? options.view : options.fallback, Vec3(0, 0, 1));
  BallAxes axes(count);
  for (std::size_t r = 0; r < count; ++r) {
    if (ball[r] != 0) axes[r] = view ? given : axis_of(runs[r]).value_or(given);
  }
  return axes;
}

namespace {

// The curved faces around a wedge, each with its frame there and a third of its triangles' area.
struct AtWedge {
  std::int32_t face = 0;
  Frame frame;
  double area = 0;
};

void find_faces_at(const Surface& surface, const FlatPatches& flats,
                   std::span<const HalfEdge> corners, std::vector<AtWedge>& found) {
  const ProxyMesh& proxy = surface.proxy();
  found.clear();
  for (const HalfEdge h : corners) {
    const std::uint32_t f = face_of(h);
    if (flats.face_patch[f] >= 0) continue;
    auto at = std::ranges::find(found, proxy.source_face[f], &AtWedge::face);
    if (at == found.end()) {
      ProxyPoint place{f, Vec3(0)};
      place.bary[h % 3] = 1;
      found.push_back({proxy.source_face[f], surface.frame(surface.lift(place)), 0});
      at = found.end() - 1;
    }
    at->area += proxy.mesh.area(f) / 3;
  }
}

}  // namespace

CurvedFrames curved_frames(const Surface& surface, const FlatPatches& flats,
                           const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  const auto corners = corners_at(proxy.wedges, proxy.wedge_vertex.size());
  CurvedFrames frames;
  frames.best.resize(proxy.wedge_vertex.size());
  std::vector<std::vector<CurvedFrames::Other>> others((frames.best.size() + kExactGrain - 1) /
                                                       kExactGrain);
  parallel_for(
      others.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        std::vector<AtWedge> found;
        const std::size_t last = std::min(end * kExactGrain, frames.best.size());
        for (std::size_t w = begin * kExactGrain; w < last; ++w) {
          Frame& best = frames.best[w];
          best.position = proxy.wedge_position(static_cast<std::uint32_t>(w));
          best.normal = proxy.wedge_normal[w];
          find_faces_at(surface, flats, corners[w], found);
          std::size_t chosen = 0;
          for (std::size_t i = 0; i < found.size(); ++i) {
            const Frame& frame = found[i].frame;
            const bool better = !frame.umbilic && frame.confidence > best.confidence;
            if (!better && !best.umbilic) continue;
            best = frame;
            chosen = i;
          }
          for (std::size_t i = 0; i < found.size(); ++i) {
            if (i == chosen) continue;
            others[w / kExactGrain].push_back(
                {static_cast<std::uint32_t>(w), found[i].frame, found[i].area});
          }
        }
      },
      &context);
  for (const auto& some : others) {
    frames.others.insert(frames.others.end(), some.begin(), some.end());
  }
  return frames;
}

}  // namespace burin::field
