#include "triangle_runs.h"

#include <burin/base/parallel.h>
#include <burin/mesh/reorder.h>

#include "four_floats.h"
#include "sheared_ray.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// A sheared coordinate is off by this at most: a corner and an origin of up to 4 rounded to single
// precision, their difference, its product with a rounded slope of up to 1 and one more difference,
// each by half a unit in the last place of 4 or 8; twelve of 2^-23 in all.
constexpr float kRounding = 0x1.0p-19F;
// How many times the surface of a run's box may be that of its triangles' boxes: larger ones are
// entered in vain, smaller ones make a larger tree. 1.5 took the least time of 0.9 to 2.
constexpr double kLoosest = 1.5;
constexpr std::size_t kGrain = 16384;

Box3 box_of(const TriMesh& mesh, std::uint32_t face) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

double half_surface(const Box3& box) {
  const Vec3 s = box.size();
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

// A corner of four triangles, as the ray sees it.
struct Corners {
  FourFloats x, y;
};

FourFloats cross(const Corners& a, const Corners& b) { return a.x * b.y - a.y * b.x; }

// The larger magnitude of both coordinates.
FourFloats extent(const Corners& c) {
  return FourFloats::max(FourFloats::abs(c.x), FourFloats::abs(c.y));
}

}  // namespace

UnitRay::UnitRay(std::array<float, 3> from, std::array<float, 3> direction) : origin(from) {
  along = fastest_axis(std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]));
  x = (along + 1) % 3;
  y = (along + 2) % 3;
  shear_x = direction[x] / direction[along];
  shear_y = direction[y] / direction[along];
}

TriangleRuns::TriangleRuns(const TriMesh& mesh, const UnitFrame& frame, const RunContext& context)
    : mesh_(&mesh) {
  find_starts(context);
  // More runs than these are worth an order of their own.
  constexpr double kFewest = 2.5;
  if (static_cast<double>(mesh.triangles.size()) < kFewest * static_cast<double>(starts_.size())) {
    sort(context);
    find_starts(context);
  }
  fours_.resize(starts_.size());
  starts_.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
  parallel_for(
      fours_.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t run = begin; run < end; ++run) fill(run, frame);
      },
      &context);
}

void TriangleRuns::find_starts(const RunContext& context) {
  const std::size_t count = mesh_->triangles.size();
  std::vector<std::vector<std::uint32_t>> starts((count + kGrain - 1) / kGrain);
  parallel_for(
      count, kGrain,
      [&](std::size_t begin, std::size_t end) {
        starts[begin / kGrain] =
            starts_in(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
      },
      &context);
  starts_.clear();
  for (const auto& some : starts) starts_.insert(starts_.end(), some.begin(), some.end());
}

std::vector<std::uint32_t> TriangleRuns::starts_in(std::uint32_t begin, std::uint32_t end) const {
  const auto box_at = [&](std::uint32_t i) {
    return box_of(*mesh_, order_.empty() ? i : order_[i]);
  };
  std::vector<std::uint32_t> starts;
  for (std::uint32_t first = begin, next = begin; first < end; first = next) {
    starts.push_back(first);
    Box3 box = box_at(first);
    double sum = half_surface(box);
    for (next = first + 1; next < end && next - first < kLongest; ++next) {
      const Box3 own = box_at(next);
      Box3 both = box;
      both.add(own);
      sum += half_surface(own);
      if (half_surface(both) > kLoosest * sum) break;
      box = both;
    }
  }
  return starts;
}

void TriangleRuns::sort(const RunContext& context) {
  std::vector<Vec3> middles(mesh_->triangles.size());
  parallel_for(
      middles.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          middles[i] = box_of(*mesh_, static_cast<std::uint32_t>(i)).center();
        }
      },
      &context);
  order_ = morton_order(middles);
}

void TriangleRuns::fill(std::size_t run, const UnitFrame& frame) {
  for (std::uint32_t lane = 0; lane < kLongest; ++lane) {
    const Triangle& t = mesh_->triangles[face(run, std::min(lane, count(run) - 1))];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3 p = frame.of(mesh_->positions[t[corner]]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        fours_[run].corner[corner][axis][lane] = static_cast<float>(glm::value_ptr(p)[axis]);
      }
    }
  }
}

// A function of an edge, x1 y2 - y1 x2, is off by no more than what its four coordinates are off,
// times the others; beside that the rounding of the products is nothing.
unsigned int TriangleRuns::may_meet(std::size_t run, const UnitRay& ray) const {
  const FourFloats from_x(ray.origin[ray.x]), from_y(ray.origin[ray.y]);
  const FourFloats from(ray.origin[ray.along]), shear_x(ray.shear_x), shear_y(ray.shear_y);
  const auto seen = [&](const float(&corner)[3][kLongest]) {
    const FourFloats z = FourFloats::load(corner[ray.along]) - from;
    const FourFloats x = FourFloats::load(corner[ray.x]) - from_x;
    const FourFloats y = FourFloats::load(corner[ray.y]) - from_y;
    return Corners{x - shear_x * z, y - shear_y * z};
  };
  const Four& four = fours_[run];
  const Corners a = seen(four.corner[0]), b = seen(four.corner[1]), c = seen(four.corner[2]);
  const FourFloats u = cross(b, c), v = cross(c, a), w = cross(a, b);
  const FourFloats reach = FourFloats::max(extent(a), FourFloats::max(extent(b), extent(c)));
  const FourFloats off = FourFloats(5 * kRounding) * (reach + FourFloats(kRounding));
  const FourFloats least = FourFloats::min(u, FourFloats::min(v, w)),
                   most = FourFloats::max(u, FourFloats::max(v, w));
  const unsigned int misses =
      FourFloats::less(least, FourFloats(0) - off) & FourFloats::less(off, most);
  return ~misses & ((1U << count(run)) - 1U);
}

Box3 TriangleRuns::box(std::size_t run) const {
  Box3 box;
  for (std::uint32_t i = 0; i < count(run); ++i) box.add(box_of(*mesh_, face(run, i)));
  return box;
}

}  // namespace burin::detail
