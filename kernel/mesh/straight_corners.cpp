#include <burin/base/parallel_filter.h>
#include <burin/mesh/corners.h>
#include <burin/mesh/straight_corners.h>

#include "build_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <vector>

namespace burin {

namespace {

/// Times how far corners may be off: the bulge over an edge from which on a corner in its middle is
/// out of place, not one of a fine mesh, whose edges are straight within the digits all the same.
/// At ten times directions of curvature on a mesh of 0.0006 mm tolerance were off by 2.5 degrees.
constexpr double kBulge = 20;
/// Cosine of a degree: two faces that meet at less are one flat face.
constexpr double kOneFace = 0.99985;
/// Times how far corners may be off: a triangle that is higher leans by less than a degree for it.
constexpr double kKnown = 200;
/// Of a difference of squares, at most, by the rounding of doubles.
constexpr double kOfDoubles = 1e-14;
/// Triangles around a corner, at most; and passes, each of which takes every other corner of a row.
constexpr std::size_t kMostAround = 64;
constexpr int kMostPasses = 8;

class StraightCorners {
 public:
  StraightCorners(TriMesh& mesh, const StraightCornerOptions& options, const RunContext& context,
                  std::vector<std::int32_t>* of)
      : mesh_(mesh),
        of_(of),
        context_(context),
        corners_(corners_at(mesh.triangles, mesh.positions.size())),
        smooth_(std::cos(options.crease_angle * std::numbers::pi / 180)) {
    double largest = 0;
    for (const Vec3& p : mesh.positions) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    off_ = options.digits * largest;
  }

  std::size_t run() {
    std::vector<std::uint32_t> found = parallel_filter<std::uint32_t>(
        mesh_.positions.size(), kFaceGrain,
        [&](std::uint32_t v) { return may_be_straight(v) && may_be_two_faces(v); }, context_);
    // The straightest first: what stands close to a corner makes that look straight, too.
    std::ranges::stable_sort(found, {}, [&](std::uint32_t v) { return off_line(v); });
    std::size_t removed = 0;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      context_.check();
      const std::size_t gone = std::erase_if(found, [&](std::uint32_t v) { return remove(v); });
      removed += gone;
      if (gone == 0) break;
    }
    if (removed > 0) compact();
    return removed;
  }

 private:
  /// The neighbours on one side of the edge, from one of its ends to the other.
  using Side = std::vector<std::uint32_t>;
  struct Split {
    std::uint32_t from, to;
    Side left, right;  // from `from` to `to`, and back
  };

  const Vec3& at(std::uint32_t v) const { return mesh_.positions[v]; }

  /// How far a point between two others is off the line through them; large where it is not.
  double off_line(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
    const Vec3 p = at(a) - at(v), q = at(b) - at(v);
    if (glm::dot(p, q) >= 0) return std::numeric_limits<double>::max();
    return glm::length(glm::cross(p, q)) / glm::distance(p, q);
  }
  bool between(std::uint32_t v, std::uint32_t a, std::uint32_t b) const {
    return off_line(v, a, b) <= off_;
  }

  /// Whether two neighbours may stand on opposite sides; cheaply, as every corner is asked.
  bool may_be_straight(std::uint32_t v) const {
    const auto around = corners_[v];
    if (around.size() > kMostAround) return false;
    std::array<Vec3, kMostAround> arms;
    std::array<double, kMostAround> squared;
    for (std::size_t i = 0; i < around.size(); ++i) {
      arms[i] = at(origin(mesh_, next_in_face(around[i]))) - at(v);
      squared[i] = glm::dot(arms[i], arms[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const double along = glm::dot(arms[i], arms[j]);
        if (along >= 0) continue;
        // The product of the arms with the sine and the cosine between them.
        const double whole = squared[i] * squared[j], aside = whole - along * along;
        const double line = squared[i] + squared[j] - 2 * along;
        if (aside <= off_ * off_ * line + kOfDoubles * whole) return true;
      }
    }
    return false;
  }

  /// Whether the triangles at a corner that are large enough to know it lie in two planes at most.
  bool may_be_two_faces(std::uint32_t v) const {
    std::array<Vec3, 2> planes;
    std::size_t count = 0;
    for (const HalfEdge h : corners_[v]) {
      const Triangle& t = mesh_.triangles[face_of(h)];
      const Vec3 twice = doubled(t);
      const double area = glm::length(twice);
      if (area <= kKnown * off_ * longest(t)) continue;
      const Vec3 n = twice / area;
      const auto end = planes.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::any_of(planes.begin(), end, [&](Vec3 m) { return glm::dot(m, n) >= kOneFace; })) {
        continue;
      }
      if (count == planes.size()) return false;
      planes[count++] = n;
    }
    return true;
  }

  /// Off the nearest line through two of its neighbours.
  double off_line(std::uint32_t v) const {
    double least = std::numeric_limits<double>::max();
    const auto around = corners_[v];
    if (around.size() > kMostAround) return least;
    const auto neighbour = [&](HalfEdge h) { return origin(mesh_, next_in_face(h)); };
    for (std::size_t i = 0; i < around.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        least = std::min(least, off_line(v, neighbour(around[i]), neighbour(around[j])));
      }
    }
    return least;
  }

  /// Of the triangles at a vertex those that are left, from the first time on that one changes.
  std::vector<std::uint32_t>& triangles_at(std::uint32_t v) {
    const auto [entry, added] = triangles_at_.try_emplace(v);
    if (added) {
      for (const HalfEdge h : corners_[v]) entry->second.push_back(face_of(h));
    }
    return entry->second;
  }

  static std::size_t corner_of(const Triangle& t, std::uint32_t v) {
    return static_cast<std::size_t>(std::ranges::find(t, v) - t.begin());
  }

  /// The neighbours of a vertex in order; empty at a boundary.
  Side ring(std::uint32_t v) {
    Side out;
    const auto& all = triangles_at(v);
    if (all.size() < 4 || all.size() > kMostAround) return out;
    const Triangle& first = mesh_.triangles[all.front()];
    std::uint32_t p = first[(corner_of(first, v) + 1) % 3];
    for (std::size_t i = 0; i < all.size(); ++i) {
      out.push_back(p);
      const auto next = std::ranges::find_if(all, [&](std::uint32_t f) {
        const Triangle& t = mesh_.triangles[f];
        return t[(corner_of(t, v) + 1) % 3] == p;
      });
      if (next == all.end()) return {};
      const Triangle& t = mesh_.triangles[*next];
      p = t[(corner_of(t, v) + 2) % 3];
    }
    const bool whole = p == out.front();
    Side sorted = out;
    std::ranges::sort(sorted);
    return whole && std::ranges::adjacent_find(sorted) == sorted.end() ? out : Side();
  }

  /// The edge that goes straight through a vertex.
  std::optional<Split> split(std::uint32_t v) {
    const Side all = ring(v);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 2; j < all.size(); ++j) {
        if ((j + 1) % all.size() == i || !between(v, all[i], all[j])) continue;
        Split out{.from = all[i], .to = all[j], .left = {}, .right = {}};
        for (std::size_t k = i; k <= j; ++k) out.left.push_back(all[k]);
        for (std::size_t k = j; k != i + 1; k = (k + 1) % all.size()) out.right.push_back(all[k]);
        const auto left = plane(out.left), right = plane(out.right);
        if (left && right && glm::dot(*left, *right) < kOneFace && are_alike(v, out)) return out;
      }
    }
    return std::nullopt;
  }

  /// Whether the triangles on each side have one number.
  bool are_alike(std::uint32_t v, const Split& s) {
    if (!of_) return true;
    std::optional<std::int32_t> left, right;
    return std::ranges::all_of(triangles_at(v), [&](std::uint32_t f) {
      const Triangle& t = mesh_.triangles[f];
      const std::uint32_t p = t[(corner_of(t, v) + 1) % 3];
      const bool on_left = p != s.to && std::ranges::find(s.left, p) != s.left.end();
      std::optional<std::int32_t>& known = on_left ? left : right;
      if (!known) known = (*of_)[f];
      return *known == (*of_)[f];
    });
  }

  /// The normal of the flat face on one side; none where it is not flat, or has no width.
  std::optional<Vec3> plane(const Side& side) const {
    const Vec3 base = at(side.front()), line = at(side.back()) - base;
    Vec3 most(0);
    for (const std::uint32_t p : side) {
      const Vec3 aside = glm::cross(at(p) - base, line);
      if (glm::dot(aside, aside) > glm::dot(most, most)) most = aside;
    }
    const double length = glm::length(line), twice = glm::length(most);
    if (twice <= off_ * length) return std::nullopt;
    const Vec3 normal = most / twice;
    const bool flat = std::ranges::all_of(
        side, [&](std::uint32_t p) { return std::abs(glm::dot(normal, at(p) - base)) <= off_; });
    return flat ? std::optional(normal) : std::nullopt;
  }

  /// Whether what is round at one end bends along the edge, so that a smooth surface is beside it.
  bool bends(const Split& s) {
    const Vec3 line = at(s.to) - at(s.from);
    const double length = glm::length(line);
    const std::array faces{plane(s.left).value_or(Vec3(0)), plane(s.right).value_or(Vec3(0))};
    for (const std::uint32_t end : {s.from, s.to}) {
      for (const std::uint32_t f : triangles_at(end)) {
        const Vec3 n = mesh_.normal(f);
        const double lean = std::abs(glm::dot(n, line)) / length;
        // The normal at the corner leans by half of that.
        if (lean * length / 8 <= kBulge * off_ || is_needle(mesh_.triangles[f])) continue;
        if (std::ranges::any_of(faces, [&](Vec3 m) { return glm::dot(n, m) >= smooth_; })) {
          return true;
        }
      }
    }
    return false;
  }

  Vec3 doubled(const Triangle& t) const {
    return glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
  }
  double longest(const Triangle& t) const {
    return std::max({glm::distance(at(t[0]), at(t[1])), glm::distance(at(t[1]), at(t[2])),
                     glm::distance(at(t[2]), at(t[0]))});
  }
  /// Whether a triangle is thinner than the digits of a file tell.
  bool is_needle(const Triangle& t) const { return glm::length(doubled(t)) <= off_ * longest(t); }

  bool remove(std::uint32_t v) {
    const auto s = split(v);
    if (!s || !bends(*s)) return false;
    std::array ends{s->from, s->to};
    if (glm::distance(at(v), at(s->to)) < glm::distance(at(v), at(s->from))) {
      std::swap(ends[0], ends[1]);
    }
    return std::ranges::any_of(ends, [&](std::uint32_t end) {
      if (!may_become(v, end, *s)) return false;
      become(v, end);
      return true;
    });
  }

  /// Whether the triangles around a corner stay what they are where it is moved to the end.
  bool may_become(std::uint32_t v, std::uint32_t end, const Split& s) {
    const auto all = triangles_at(v);
    for (const std::uint32_t f : all) {
      Triangle t = mesh_.triangles[f];
      if (corner_of(t, end) < 3) continue;
      t[corner_of(t, v)] = end;
      const auto on = [&](const Side& side) {
        return std::ranges::all_of(
            t, [&](std::uint32_t p) { return std::ranges::find(side, p) != side.end(); });
      };
      const auto normal = plane(on(s.left) ? s.left : s.right);
      if (!normal || is_needle(t) || glm::dot(doubled(t), *normal) <= 0) return false;
    }
    // Two triangles go; any other neighbour in common would be two sheets of one edge.
    const Side here = ring(v), there = ring(end);
    return std::ranges::count_if(there, [&](std::uint32_t p) {
             return std::ranges::find(here, p) != here.end();
           }) == 2;
  }

  void become(std::uint32_t v, std::uint32_t end) {
    const auto all = triangles_at(v);
    for (const std::uint32_t f : all) {
      Triangle& t = mesh_.triangles[f];
      if (corner_of(t, end) < 3) {
        for (const std::uint32_t p : t) std::erase(triangles_at(p), f);
        t = {};
        continue;
      }
      t[corner_of(t, v)] = end;
      triangles_at(end).push_back(f);
    }
    triangles_at(v).clear();
  }

  static bool is_gone(const Triangle& t) { return t[0] == t[1]; }

  /// Leaves out the triangles that are gone, and the corners that none has.
  void compact() {
    if (of_) {
      std::size_t kept = 0;
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (!is_gone(mesh_.triangles[t])) (*of_)[kept++] = (*of_)[t];
      }
      of_->resize(kept);
    }
    std::erase_if(mesh_.triangles, is_gone);
    std::vector<std::uint32_t> place(mesh_.positions.size(), 0);
    for (const Triangle& t : mesh_.triangles) {
      for (const std::uint32_t v : t) place[v] = 1;
    }
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
      if (place[v] == 0) continue;
      mesh_.positions[count] = mesh_.positions[v];
      place[v] = count++;
    }
    mesh_.positions.resize(count);
    for (Triangle& t : mesh_.triangles) {
      for (std::uint32_t& v : t) v = place[v];
    }
  }

  TriMesh& mesh_;
  std::vector<std::int32_t>* of_;
  const RunContext& context_;
  Corners corners_;
  double smooth_, off_ = 0;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> triangles_at_;
};

}  // namespace

std::size_t remove_straight_corners(TriMesh& mesh, const StraightCornerOptions& options,
                                    const RunContext& context, std::vector<std::int32_t>* of) {
  return StraightCorners(mesh, options, context, of).run();
}

}  // namespace burin
