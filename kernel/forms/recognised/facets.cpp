#include "facets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burin::recognised {
namespace {

// Of the largest coordinate: text of six digits has 5e-6 at the worst, usually less.
constexpr double kNoise = 1e-6;
// Of the largest coordinate where all coordinates are of single precision: two roundings.
constexpr double kSingleNoise = 1.2e-7;
// Noises that a corner may lie off the plane of its facet: three coordinates are rounded.
constexpr double kOff = 3;
// Radians between triangles of one facet: a tenth of a degree is a circle of 3600 sides.
constexpr double kFlatFacet = 0.0017;

struct Shape {
  Vec3 normal{0};
  double area = 0, height = 0;  // the least of the three heights
};

Shape shape_of(const TriMesh& mesh, std::uint32_t t) {
  const Triangle& tri = mesh.triangles[t];
  const Vec3 a = mesh.positions[tri[0]], b = mesh.positions[tri[1]], c = mesh.positions[tri[2]];
  const Vec3 n = glm::cross(b - a, c - a);
  const double twice = glm::length(n);
  const double longest =
      std::sqrt(std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)}));
  Shape s;
  if (twice > 0) s.normal = n / twice;
  s.area = twice / 2;
  s.height = longest > 0 ? twice / longest : 0;
  return s;
}

class FacetFinder {
 public:
  FacetFinder(const TriMesh& mesh, const Topology& topology, std::span<const std::int32_t> label)
      : mesh_(mesh), topology_(topology), label_(label) {
    out_.noise = mesh_noise(mesh);
    out_.of.assign(mesh.triangles.size(), -1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) shapes_.push_back(shape_of(mesh, t));
  }

  Facets run(const RunContext& context) {
    std::vector<std::uint32_t> order(shapes_.size());
    std::iota(order.begin(), order.end(), 0U);
    // The widest triangle knows its plane best.
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return shapes_[a].height > shapes_[b].height;
    });
    std::size_t count = 0;
    for (const std::uint32_t t : order) {
      if (++count % 4096 == 0) context.check();
      if (out_.of[t] < 0) grow(t);
    }
    for (Facet& f : out_.list) finish(f);
    context.check();
    return std::move(out_);
  }

 private:
  bool fits(const Facet& f, const Shape& seed, std::uint32_t t) const {
    const Shape& s = shapes_[t];
    // A triangle as thin as the noise may point anywhere.
    const double angle = std::max(kFlatFacet, 4 * out_.noise / std::max(s.height, 1e-300));
    if (angle < 1 && glm::dot(s.normal, f.normal) < std::cos(angle)) return false;
    for (const std::uint32_t v : mesh_.triangles[t]) {
      const Vec3 p = mesh_.positions[v];
      const double reach = 1 + glm::length(p - f.center) / std::max(seed.height, out_.noise);
      if (std::abs(glm::dot(f.normal, p) - f.offset) > kOff * out_.noise * std::min(reach, 100.0)) {
        return false;
      }
    }
    return true;
  }

  void grow(std::uint32_t seed) {
    const auto id = static_cast<std::int32_t>(out_.list.size());
    Facet& f = out_.list.emplace_back();
    const Triangle& tri = mesh_.triangles[seed];
    f.normal = shapes_[seed].normal;
    f.center = (mesh_.positions[tri[0]] + mesh_.positions[tri[1]] + mesh_.positions[tri[2]]) / 3.0;
    f.offset = glm::dot(f.normal, f.center);
    f.triangles.push_back(seed);
    out_.of[seed] = id;
    for (std::size_t i = 0; i < f.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto h = 3 * std::size_t{f.triangles[i]} + static_cast<std::size_t>(k);
        const HalfEdge o = topology_.opposite[h];
        if (o == kNoHalfEdge || out_.of[face_of(o)] >= 0) continue;
        if (!label_.empty() && label_[face_of(o)] != label_[seed]) continue;
        if (!fits(f, shapes_[seed], face_of(o))) continue;
        out_.of[face_of(o)] = id;
        f.triangles.push_back(face_of(o));
      }
    }
  }

  /// The plane of all triangles, the vertices, the neighbours.
  void finish(Facet& f) {
    Vec3 n(0), center(0);
    const auto id = out_.of[f.triangles.front()];
    for (const std::uint32_t t : f.triangles) {
      const Triangle& tri = mesh_.triangles[t];
      const double area = shapes_[t].area;
      f.area += area;
      n += area * shapes_[t].normal;
      center +=
          area / 3 * (mesh_.positions[tri[0]] + mesh_.positions[tri[1]] + mesh_.positions[tri[2]]);
      f.vertices.insert(f.vertices.end(), tri.begin(), tri.end());
      for (int k = 0; k < 3; ++k) link(f, id, 3 * static_cast<HalfEdge>(t) + k);
    }
    std::sort(f.vertices.begin(), f.vertices.end());
    f.vertices.erase(std::unique(f.vertices.begin(), f.vertices.end()), f.vertices.end());
    if (!(f.area > 0) || !(glm::length(n) > 0)) return;
    f.normal = glm::normalize(n);
    f.center = center / f.area;
    f.offset = glm::dot(f.normal, f.center);
  }

  void link(Facet& f, std::int32_t id, HalfEdge h) {
    const HalfEdge o = topology_.opposite[static_cast<std::size_t>(h)];
    if (o == kNoHalfEdge) return;
    const std::int32_t other = out_.of[face_of(o)];
    if (other == id) return;
    const double length = glm::length(mesh_.positions[origin(mesh_, next_in_face(h))] -
                                      mesh_.positions[origin(mesh_, h)]);
    for (FacetLink& l : f.links) {
      if (l.facet == other) {
        l.length += length;
        return;
      }
    }
    f.links.push_back({other, length});
  }

  const TriMesh& mesh_;
  const Topology& topology_;
  std::span<const std::int32_t> label_;
  std::vector<Shape> shapes_;
  Facets out_;
};

}  // namespace

// Parts are worked on at about their own size first: far from the origin only the digits that are
// lost there count.
double mesh_noise(const TriMesh& mesh) {
  double largest = 0;
  bool single = true;
  for (const Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(p[k]));
      single = single && p[k] == static_cast<double>(static_cast<float>(p[k]));
    }
  }
  if (!single) return kNoise * largest;
  return std::max(kSingleNoise * largest, kNoise * std::min(largest, mesh.bounds().diagonal()));
}

Facets find_facets(const TriMesh& mesh, const Topology& topology, const RunContext& context,
                   std::span<const std::int32_t> label) {
  return FacetFinder(mesh, topology, label).run(context);
}

}  // namespace burin::recognised
