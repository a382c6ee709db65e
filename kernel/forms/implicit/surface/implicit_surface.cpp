#include "implicit_surface.h"

#include <burin/base/parallel.h>
#include <burin/mesh/nearest_side.h>

#include "../function/project.h"
#include "../function/shape_operator.h"
#include "../function/work.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>

namespace burin {
namespace {

std::atomic<std::uint64_t> surfaces_made{0};

}  // namespace

ImplicitSurface::ImplicitSurface(std::shared_ptr<const ImplicitFunction> function, ProxyMesh proxy,
                                 std::vector<const ImplicitFunction*> side, double step,
                                 double size)
    : function_(std::move(function)),
      proxy_(std::move(proxy)),
      side_(std::move(side)),
      step_(step),
      size_(size),
      name_(++surfaces_made) {
  double far = 0;
  for (const Vec3& p : proxy_.mesh.positions) far = std::max(far, glm::length(p));
  accuracy_ = 1e-11 * size + 1e-15 * far;  // as in project_nets
  find_locals();
}

void ImplicitSurface::find_locals() {
  constexpr double kSide = 3;  // steps
  local_of_.assign(side_.size(), -1);
  if (!function_->has_pieces()) return;
  const TriMesh& mesh = proxy_.mesh;
  using Key = std::array<std::int64_t, 3>;
  std::map<Key, std::int32_t> names;
  std::vector<Box3> boxes;
  for (std::size_t f = 0; f < side_.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3 corner = mesh.positions[t[0]];
    Key key;
    for (int a = 0; a < 3; ++a) {
      key[static_cast<std::size_t>(a)] =
          static_cast<std::int64_t>(std::floor(corner[a] / (kSide * step_)));
    }
    const auto [it, fresh] = names.try_emplace(key, static_cast<std::int32_t>(boxes.size()));
    if (fresh) boxes.emplace_back();
    local_of_[f] = it->second;
    for (const std::uint32_t v : t)
      boxes[static_cast<std::size_t>(it->second)].add(mesh.positions[v]);
  }
  // Nanoseconds of one core that may go into finding shorter functions.
  constexpr double kBudget = 3e9;
  const double each = work::kBox * function_->cost();
  if (static_cast<double>(boxes.size()) * each > kBudget) {
    local_of_.assign(side_.size(), -1);
    return;
  }
  locals_.resize(boxes.size());
  const double margin = kLocalReach * step_ + proxy_.tolerance;
  parallel_for(boxes.size(), work::grain(each, 16), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      locals_[i] = function_->restricted({boxes[i].min - margin, boxes[i].max + margin});
    }
  });
  for (std::int32_t& l : local_of_) {
    if (!locals_[static_cast<std::size_t>(l)]) l = -1;
  }
}

const ImplicitFunction& ImplicitSurface::function_at(std::uint32_t face) const {
  if (side_[face]) return *side_[face];
  return local_of_[face] < 0 ? *function_ : *locals_[static_cast<std::size_t>(local_of_[face])];
}

// f.hessian(p), or what that was a moment ago: tracers ask for the frame where a step ended and
// then step on from there, half a step for a try and a whole one. Nothing but the time depends on
// it.
Gradient2 ImplicitSurface::known_hessian(const ImplicitFunction& f, Vec3 p) const {
  struct Entry {
    std::uint64_t surface = 0;
    const ImplicitFunction* f = nullptr;
    Vec3 p{0};
    Gradient2 g;
  };
  constexpr std::size_t kEntries = 4;
  thread_local std::array<Entry, kEntries> entries;
  thread_local std::size_t oldest = 0;
  for (const Entry& e : entries) {
    if (e.p == p && e.f == &f && e.surface == name_) return e.g;
  }
  Entry& e = entries[oldest];
  oldest = (oldest + 1) % kEntries;
  e = {name_, &f, p, f.hessian(p)};
  return e.g;
}

SurfacePoint ImplicitSurface::lift(const ProxyPoint& point) const {
  const Vec3 p = proxy_.position(point.face, point.bary);
  // Where Newton does not get there (a jump of the function) the triangle is all there is.
  const double reach = 2 * proxy_.tolerance + accuracy_;
  return {0, point.bary, onto_surface(function_at(point.face), p, reach, accuracy_).value_or(p),
          point.face};
}

Frame ImplicitSurface::frame(const SurfacePoint& point) const {
  return implicit_frame(known_hessian(function_at(point.triangle), point.position), point.position,
                        proxy_.mesh.normal(point.triangle), size_);
}

std::vector<Frame> ImplicitSurface::wedge_frames(const RunContext& context) const {
  const std::size_t n = proxy_.wedge_vertex.size();
  std::vector<const ImplicitFunction*> piece(n, nullptr);
  for (std::uint32_t f = 0; f < proxy_.wedges.size(); ++f) {
    for (const std::uint32_t w : proxy_.wedges[f]) piece[w] = side_[f];
  }
  std::vector<Frame> frames(n);
  parallel_for(
      n, work::grain(2 * work::kHessian * function_->cost(), 1024),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points;
        for (std::size_t w = begin; w < end; ++w) {
          points.push_back(proxy_.wedge_position(static_cast<std::uint32_t>(w)));
        }
        std::vector<Gradient2> g(points.size());
        function_->hessians(points, g);
        for (std::size_t w = begin; w < end; ++w) {
          if (piece[w]) g[w - begin] = piece[w]->hessian(points[w - begin]);
          frames[w] =
              implicit_frame(g[w - begin], points[w - begin], proxy_.wedge_normal[w], size_);
        }
      },
      &context);
  return frames;
}

namespace {

// Coordinates in a triangle of the foot of p on its plane; false where the triangle has no area.
bool coordinates(const TriMesh& mesh, std::uint32_t face, Vec3 p, Vec3& bary) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.positions[t[0]], u = mesh.positions[t[1]] - a, v = mesh.positions[t[2]] - a;
  const Vec3 n = glm::cross(u, v), w = p - a;
  const double nn = glm::dot(n, n);
  if (!(nn > 0)) return false;
  bary.y = glm::dot(glm::cross(w, v), n) / nn;
  bary.z = glm::dot(glm::cross(u, w), n) / nn;
  bary.x = 1 - bary.y - bary.z;
  return true;
}

// The nearest point of the triangle's border or inside.
Vec3 clamped(const TriMesh& mesh, std::uint32_t face, Vec3 p, Vec3 bary) {
  return std::min({bary.x, bary.y, bary.z}) >= 0 ? bary : nearest_side(mesh, face, p);
}

}  // namespace

ImplicitSurface::Walk ImplicitSurface::walk(std::uint32_t face, Vec3 p) const {
  // Triangles at the most; steps are short against the surface, so that few are needed.
  constexpr int kMost = 4096;
  // From here on it may be going round a corner: what lies nearest counts.
  constexpr int kStraight = 64;
  Walk w;
  std::uint32_t before = face, best = face;
  double least = std::numeric_limits<double>::infinity();
  Vec3 bary(1, 0, 0), best_bary = bary;
  for (int i = 0; i < kMost; ++i) {
    w.by_crease |= side_[face] != nullptr;
    const bool flat = !coordinates(proxy_.mesh, face, p, bary);
    if (flat) bary = Vec3(-1, -1, 3);
    const Vec3 on = flat ? Vec3(1, 0, 0) : clamped(proxy_.mesh, face, p, bary);
    const double gap = glm::distance(p, proxy_.position(face, on));
    const bool nearer = gap < least;
    if (nearer) {
      least = gap;
      best = face;
      best_bary = on;
    }
    if (!flat && on == bary) break;
    // Over the edge that it is farthest beyond, unless that is sharp or it came from there.
    HalfEdge through = kNoHalfEdge;
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      const HalfEdge h = static_cast<HalfEdge>(3 * face) + (k + 1) % 3;  // opposite to corner k
      const auto e = static_cast<std::size_t>(h);
      if (bary[k] >= most || proxy_.edge_kind[e] != EdgeKind::Smooth) continue;
      const HalfEdge o = proxy_.topology.opposite[e];
      if (o == kNoHalfEdge || (face_of(o) == before && i > 0)) continue;
      most = bary[k];
      through = o;
    }
    if (through == kNoHalfEdge || (i > kStraight && !nearer)) break;
    before = face;
    face = face_of(through);
  }
  w.place = {best, best_bary};
  // Beside an edge between two triangles a point of the surface lies off both by some sagitta.
  w.reached = least <= 2 * proxy_.tolerance + 0.05 * step_;
  w.lost = least > 2 * proxy_.tolerance + 0.5 * step_;
  return w;
}

}  // namespace burin
