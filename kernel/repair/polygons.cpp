#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/repair/polygons.h>

#include "exact_orientation.h"
#include "stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <queue>
#include <stdexcept>

namespace burin::repair_stages {
namespace {

/// Twice the area vector of a polygon, from differences to its first corner so that a far origin
/// costs no digits.
Vec3 area_vector(std::span<const Vec3> positions, std::span<const std::uint32_t> corners) {
  const Vec3 origin = positions[corners[0]];
  Vec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(positions[corners[i]] - origin, positions[corners[i + 1]] - origin);
  }
  return sum;
}

/// Cuts off ears, the shortest diagonal first, until a triangle is left. The polygon is looked at
/// along the main axis of its normal: dropping a coordinate, unlike turning, is exact.
class EarClipper {
 public:
  EarClipper(std::span<const Vec3> positions, std::span<const std::uint32_t> corners);
  bool run(std::span<Triangle> out, const RunContext& context);

 private:
  struct Ear {
    double diagonal2;
    std::uint32_t corner, stamp;
    bool operator<(const Ear& o) const {  // the heap gives the largest first
      return diagonal2 != o.diagonal2 ? diagonal2 > o.diagonal2 : corner > o.corner;
    }
  };
  bool convex(std::uint32_t i) const { return orientation(at(prev_[i]), at(i), at(next_[i])) > 0; }
  const Vec2& at(std::uint32_t i) const { return points_[i]; }
  bool blocked(std::uint32_t i) const;
  void offer(std::uint32_t i);
  void refill();
  std::uint32_t worst_case_corner() const;
  void cut(std::uint32_t i, Triangle& out);

  std::span<const std::uint32_t> corners_;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> prev_, next_, stamp_;
  std::vector<std::uint32_t> reflex_;  // may hold corners that are convex or gone by now
  std::vector<std::uint8_t> is_reflex_;
  std::priority_queue<Ear> ears_;
  std::uint32_t any_ = 0;
};

EarClipper::EarClipper(std::span<const Vec3> positions, std::span<const std::uint32_t> corners)
    : corners_(corners) {
  const Vec3 n = area_vector(positions, corners);
  const Vec3 size = glm::abs(n);
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (n[axis] < 0) std::swap(u, v);
  const auto count = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3& p = positions[corners[i]];
    points_.push_back({p[u], p[v]});
    prev_.push_back(i == 0 ? count - 1 : i - 1);
    next_.push_back(i + 1 == count ? 0 : i + 1);
  }
  stamp_.assign(count, 0);
  is_reflex_.assign(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    is_reflex_[i] = !convex(i);
    if (is_reflex_[i]) reflex_.push_back(i);
  }
}

/// Whether a corner that is not convex lies in the triangle at i. Corners at the same place as one
/// of the triangle's do not count: outlines are joined to their holes by such pairs.
bool EarClipper::blocked(std::uint32_t i) const {
  const Vec2 a = at(prev_[i]), b = at(i), c = at(next_[i]);
  const Vec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  return std::ranges::any_of(reflex_, [&](std::uint32_t r) {
    const Vec2 p = at(r);
    if (!is_reflex_[r] || p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y) return false;
    if (p == a || p == b || p == c) return false;
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
  });
}

void EarClipper::offer(std::uint32_t i) {
  if (!convex(i)) return;
  const Vec2 d = at(next_[i]) - at(prev_[i]);
  ears_.push({glm::dot(d, d), i, stamp_[i]});
}

void EarClipper::refill() {
  std::erase_if(reflex_, [&](std::uint32_t r) { return !is_reflex_[r]; });
  std::uint32_t i = any_;
  do {
    offer(i);
    i = next_[i];
  } while (i != any_);
}

/// Where no corner is an ear: the one whose triangle turns right least.
std::uint32_t EarClipper::worst_case_corner() const {
  std::uint32_t best = any_;
  double best_area = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = next_[any_]; i != any_; i = next_[i]) {
    const double area = cross2(at(i) - at(prev_[i]), at(next_[i]) - at(i));
    if (area > best_area) {
      best_area = area;
      best = i;
    }
  }
  return best;
}

void EarClipper::cut(std::uint32_t i, Triangle& out) {
  const std::uint32_t p = prev_[i], n = next_[i];
  out = {corners_[p], corners_[i], corners_[n]};
  next_[p] = n;
  prev_[n] = p;
  is_reflex_[i] = 0;
  ++stamp_[i];
  any_ = n;
  for (const std::uint32_t k : {p, n}) {
    ++stamp_[k];
    // A cut of a true ear only widens the angles that are left; after a forced cut both may change.
    const bool reflex = !convex(k);
    if (reflex && !is_reflex_[k]) reflex_.push_back(k);
    is_reflex_[k] = reflex;
    offer(k);
  }
}

bool EarClipper::run(std::span<Triangle> out, const RunContext& context) {
  bool simple = true;
  bool refilled = false;  // since the last cut
  std::size_t done = 0;
  while (done + 1 < out.size()) {
    context.check();
    if (ears_.empty()) {
      // A corner may have become an ear far from the cuts; where none has, the polygon crosses
      // itself.
      if (refilled) {
        simple = false;
        cut(worst_case_corner(), out[done++]);
      } else {
        refill();
      }
      refilled = !refilled;
      continue;
    }
    const Ear ear = ears_.top();
    ears_.pop();
    if (ear.stamp != stamp_[ear.corner] || blocked(ear.corner)) continue;
    cut(ear.corner, out[done++]);
    refilled = false;
  }
  out[done] = {corners_[prev_[any_]], corners_[any_], corners_[next_[any_]]};
  return simple && orientation(at(prev_[any_]), at(any_), at(next_[any_])) >= 0;
}

/// The angle between the two triangles of a quadrilateral that is cut from a to c.
double fold(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 one = glm::cross(b - a, c - a), other = glm::cross(c - a, d - a);
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

/// Whether a bent quadrilateral is to be cut from a to c: the cut that folds it less, else the
/// shorter one, else the one that makes a ridge. None of these looks at where the corners begin: a
/// surface of alike quadrilaterals gets alike cuts. Absent where it is flat, but for rounding.
std::optional<bool> cut_of_bent(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double kBent = 0.02, kAlike = 0.01;  // radians: 1.1 and 0.6 degrees
  constexpr double kEqual = 1 + 1e-4;
  const double ac = fold(a, b, c, d), bd = fold(b, c, d, a);
  if (!(std::max(ac, bd) > kBent)) return std::nullopt;
  if (std::abs(ac - bd) > kAlike) return ac < bd;
  const double long_ac = glm::dot(c - a, c - a), long_bd = glm::dot(d - b, d - b);
  if (long_ac > kEqual * long_bd || long_bd > kEqual * long_ac) return long_ac < long_bd;
  return glm::dot(glm::cross(b - a, c - a), d - a) < 0;
}

/// The two triangles of a quadrilateral: the cut must lie inside it; of two such cuts the one that
/// suits it better, of a flat one the shorter.
void triangulate_quad(std::span<const Vec3> positions, std::span<const std::uint32_t> q,
                      std::span<Triangle> out) {
  const Vec3 &a = positions[q[0]], &b = positions[q[1]], &c = positions[q[2]], &d = positions[q[3]];
  const bool ac = glm::dot(glm::cross(b - a, c - a), glm::cross(c - a, d - a)) > 0;
  const bool bd = glm::dot(glm::cross(b - a, d - a), glm::cross(c - b, d - b)) > 0;
  // Rectangles have equal diagonals: rounding must not make the cuts of a row of them alternate.
  constexpr double kEqual = 1 + 1e-6;
  const auto better = [&] {
    const bool shorter = glm::dot(c - a, c - a) <= kEqual * glm::dot(d - b, d - b);
    return cut_of_bent(a, b, c, d).value_or(shorter);
  };
  if (ac == bd ? better() : ac) {
    out[0] = {q[0], q[1], q[2]};
    out[1] = {q[0], q[2], q[3]};
  } else {
    out[0] = {q[0], q[1], q[3]};
    out[1] = {q[1], q[2], q[3]};
  }
}

void check_soup(const PolygonSoup& soup, const RunContext& context) {
  if (soup.offsets.empty() || soup.offsets.front() != 0 ||
      soup.offsets.back() != soup.indices.size()) {
    throw GeometryError("the offsets of a polygon soup do not match its indices");
  }
  if (soup.indices.size() >= kNone)
    throw GeometryError("more than 4,294,967,294 corners; split the model");
  parallel_for(
      soup.polygon_count(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          if (soup.offsets[f + 1] < soup.offsets[f] + 3 ||
              soup.offsets[f + 1] > soup.indices.size()) {
            throw GeometryError(fmt::format("polygon {} has fewer than three corners", f));
          }
          for (std::size_t c = soup.offsets[f]; c < soup.offsets[f + 1]; ++c) {
            if (soup.indices[c] >= soup.positions.size()) {
              throw GeometryError(fmt::format("polygon {} refers to point {} of {}", f,
                                              soup.indices[c], soup.positions.size()));
            }
          }
        }
      },
      &context);
}

/// From one number a polygon to one for each of its triangles.
void number_triangles(const PolygonSoup& soup, Numbers& of) {
  if (of.size() != soup.polygon_count()) {
    throw std::invalid_argument("one number a polygon expected");
  }
  Numbers out;
  for (std::size_t f = 0; f < of.size(); ++f) {
    const std::size_t corners = soup.offsets[f + 1] - soup.offsets[f];
    out.insert(out.end(), corners - 2, of[f]);
  }
  of = std::move(out);
}

}  // namespace

TriMesh triangulate(PolygonSoup soup, Numbers* of, Diagnostics& diagnostics,
                    const RunContext& context) {
  check_soup(soup, context);
  if (of) number_triangles(soup, *of);
  TriMesh mesh;
  mesh.positions = std::move(soup.positions);
  mesh.triangles.resize(soup.indices.size() - 2 * soup.polygon_count());
  std::atomic<std::int64_t> crossed{0};
  parallel_for(
      soup.polygon_count(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const std::size_t first = soup.offsets[f], count = soup.offsets[f + 1] - first;
          const bool simple = triangulate_polygon(
              mesh.positions, std::span(soup.indices).subspan(first, count),
              std::span(mesh.triangles).subspan(first - 2 * f, count - 2), context);
          if (!simple) crossed.fetch_add(1, std::memory_order_relaxed);
        }
      },
      &context);
  if (crossed > 0) {
    diagnostics.add(Severity::Warning, "mesh.crossed_polygons", crossed,
                    "polygons that cross themselves were cut into triangles as well as could be");
  }
  return mesh;
}

}  // namespace burin::repair_stages

namespace burin {

bool triangulate_polygon(std::span<const Vec3> positions, std::span<const std::uint32_t> corners,
                         std::span<Triangle> out, const RunContext& context) {
  if (corners.size() == 3) {
    out[0] = {corners[0], corners[1], corners[2]};
    return true;
  }
  if (corners.size() == 4) {
    repair_stages::triangulate_quad(positions, corners, out);
    return true;
  }
  return repair_stages::EarClipper(positions, corners).run(out, context);
}

}  // namespace burin
