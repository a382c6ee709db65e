#include "known.h"

#include "facets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <tuple>

namespace burin::recognised {
namespace {

// Sine of the angle between axes that are one.
constexpr double kParallel = 1e-5;
// A cone of less than a hundredth of a degree is a cylinder that was rounded.
constexpr double kUpright = 1e-4;

/// How far chords of `step` radians lie within a circle of `radius`.
double chord_depth(double radius, double step) { return radius * (1 - std::cos(0.5 * step)); }

Patch patch_of(const TurnedSurface& s) {
  if (s.profile == TurnedSurface::Profile::Grid) {
    return patch_on(std::make_shared<const Sheet>(*s.grid), s.grid->window);
  }
  Patch p;
  p.axis = {s.origin, s.axis};
  p.step = s.step;
  if (s.profile == TurnedSurface::Profile::Line) {
    const Vec2 along = glm::normalize(s.b - s.a);
    p.normal = {along.y, -along.x};
    p.offset = glm::dot(p.normal, s.a);
    p.sagitta = chord_depth(std::max(s.a.x, s.b.x), s.step);
    p.turn = 2 * std::asin(std::min(1.0, std::abs(p.normal.x) * std::sin(0.5 * s.step)));
    p.kind = std::abs(p.normal.y) < kUpright ? FaceKind::Cylinder : FaceKind::Cone;
    return p;
  }
  p.profile = Patch::Profile::Circle;
  p.middle = s.middle;
  p.radius = s.radius;
  p.sagitta =
      chord_depth(std::abs(s.middle.x) + s.radius, s.step) + chord_depth(s.radius, s.profile_step);
  p.turn = std::max(s.step, s.profile_step);
  p.kind = std::abs(s.middle.x) <= 1e-6 * s.radius ? FaceKind::Sphere : FaceKind::Torus;
  if (p.kind == FaceKind::Sphere) {
    // The middle is the origin of spheres, wherever the profile had it.
    p.axis.origin += s.middle.y * s.axis;
    p.middle = Vec2(0);
  }
  return p;
}

/// The same surface facing the other way.
Patch turned_over(Patch p) {
  p.side = -p.side;
  if (p.profile == Patch::Profile::Circle) {
    p.radius = -p.radius;
  } else {
    p.normal = -p.normal;
    p.offset = -p.offset;
  }
  return p;
}

/// Whether two surfaces are one, whichever way they face and count along their axis.
bool same(const Patch& a, const Patch& b, double noise) {
  const double off = 4 * noise;
  if (a.profile != b.profile || a.kind != b.kind || a.sheet || b.sheet) return false;
  if (a.kind == FaceKind::Sphere) {
    return glm::distance(a.axis.origin, b.axis.origin) <= off &&
           std::abs(a.radius - b.radius) <= off;
  }
  if (glm::length(glm::cross(a.axis.direction, b.axis.direction)) > kParallel) return false;
  if (a.axis.profile(b.axis.origin).x > off) return false;
  const double turned = glm::dot(a.axis.direction, b.axis.direction) > 0 ? 1 : -1;
  const double shift = glm::dot(b.axis.origin - a.axis.origin, a.axis.direction);
  if (a.profile == Patch::Profile::Circle) {
    const Vec2 middle(b.middle.x, turned * b.middle.y + shift);
    return glm::distance(a.middle, middle) <= off && std::abs(a.radius - b.radius) <= off;
  }
  Vec2 normal(b.normal.x, turned * b.normal.y);
  double offset = b.offset + normal.y * shift;
  if (glm::dot(a.normal, normal) < 0) {
    normal = -normal;
    offset = -offset;
  }
  return glm::distance(a.normal, normal) <= kParallel && std::abs(a.offset - offset) <= off;
}

class KnownFacetFinder {
 public:
  KnownFacetFinder(const TriMesh& mesh, const KnownSurfaces& known) : mesh_(mesh), known_(known) {
    if (known.of.size() != mesh.triangles.size()) {
      throw std::invalid_argument("one surface a triangle expected");
    }
  }

  KnownFacets run(const Topology& topology, const RunContext& context) {
    KnownFacets out;
    find_patches(mesh_noise(mesh_), context);
    std::vector<std::int32_t> label;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) label.push_back(label_of(t));
    out.facets = find_facets(mesh_, topology, context, label);
    Bands& bands = out.bands;
    bands.of.assign(out.facets.list.size(), -1);
    bands.of_sphere.assign(out.facets.list.size(), -1);
    for (std::size_t f = 0; f < out.facets.list.size(); ++f) {
      const std::int32_t l = label[out.facets.list[f].triangles.front()];
      if (l >= 0) add(bands, static_cast<std::int32_t>(f), l);
    }
    if (std::ranges::find(label, KnownSurfaces::kUnknown) != label.end()) {
      recognise(out, label, context);
    }
    return out;
  }

 private:
  /// Adds what facets of which nothing is known stand for. The others have no area and no
  /// neighbours while these are looked at.
  void recognise(KnownFacets& out, const std::vector<std::int32_t>& label,
                 const RunContext& context) const {
    Facets unknown = out.facets;
    for (Facet& f : unknown.list) {
      if (label[f.triangles.front()] == KnownSurfaces::kUnknown) continue;
      f.area = 0;
      f.links.clear();
    }
    Bands found = find_bands(mesh_, unknown, context);
    Bands& bands = out.bands;
    const auto first = static_cast<std::int32_t>(bands.list.size());
    const auto first_sphere = static_cast<std::int32_t>(bands.spheres.size());
    for (std::size_t f = 0; f < bands.of.size(); ++f) {
      if (found.of[f] >= 0) bands.of[f] = first + found.of[f];
      if (found.of_sphere[f] >= 0) bands.of_sphere[f] = first_sphere + found.of_sphere[f];
    }
    for (Patch& p : found.spheres) {
      if (p.chain >= 0) p.chain += chains_;
    }
    std::ranges::move(found.list, std::back_inserter(bands.list));
    std::ranges::move(found.spheres, std::back_inserter(bands.spheres));
  }

  /// Equal surfaces become one patch. By their sizes first, so that few are compared.
  void find_patches(double noise, const RunContext& context) {
    std::multimap<double, std::int32_t> by_size;
    for (const TurnedSurface& s : known_.surfaces) {
      context.check();
      Patch p = patch_of(s);
      const double size = p.sheet                               ? p.sheet->size()
                          : p.profile == Patch::Profile::Circle ? p.radius
                          : p.kind == FaceKind::Cylinder        ? std::abs(p.offset)
                                                                : std::abs(p.normal.y);
      const double off = std::max(4 * noise, kParallel);
      std::int32_t found = -1;
      for (auto i = by_size.lower_bound(size - off);
           found < 0 && i != by_size.end() && i->first <= size + off; ++i) {
        Patch& other = patches_[at(i->second)];
        if (same(other, p, noise)) found = i->second;
        if (s.grid && other.sheet && other.sheet->goes_through(*s.grid)) join_parts(other, p);
      }
      if (found < 0) {
        found = static_cast<std::int32_t>(patches_.size());
        patches_.push_back(p);
        by_size.emplace(size, found);
      } else {
        Patch& one = patches_[at(found)];
        one.sagitta = std::max(one.sagitta, p.sagitta);
        one.turn = std::max(one.turn, p.turn);
      }
      patch_.push_back(found);
    }
  }

  /// Parts of one surface go over into one another.
  void join_parts(Patch& one, Patch& other) {
    if (one.chain < 0) one.chain = chains_++;
    other.chain = one.chain;
    other.sheet = one.sheet;
  }

  /// Twice the patch, and one more where the triangle faces against it.
  std::int32_t label_of(std::uint32_t t) const {
    const std::int32_t s = known_.of[t];
    if (s < 0) return s;
    const Triangle& tri = mesh_.triangles[t];
    const Vec3 a = mesh_.positions[tri[0]], b = mesh_.positions[tri[1]],
               c = mesh_.positions[tri[2]];
    const Patch& p = patches_[at(patch_[at(s)])];
    const bool against = glm::dot(glm::cross(b - a, c - a), p.normal_at((a + b + c) / 3.0)) < 0;
    return 2 * patch_[at(s)] + (against ? 1 : 0);
  }

  void add(Bands& bands, std::int32_t facet, std::int32_t label) {
    const Patch& found = patches_[at(label / 2)];
    const bool circle = found.profile != Patch::Profile::Line;
    const auto count = circle ? bands.spheres.size() : bands.list.size();
    const auto [entry, fresh] = row_.try_emplace(label, static_cast<std::int32_t>(count));
    if (fresh) {
      const Patch patch = label % 2 == 0 ? found : turned_over(found);
      if (circle) {
        bands.spheres.push_back(patch);
      } else {
        bands.list.push_back({.patch = patch, .phase = {}, .facets = {}});
      }
    }
    (circle ? bands.of_sphere : bands.of)[at(facet)] = entry->second;
    if (!circle) bands.list[at(entry->second)].facets.push_back(facet);
  }

  const TriMesh& mesh_;
  const KnownSurfaces& known_;
  std::vector<Patch> patches_;
  std::int32_t chains_ = 0;
  /// For each known surface its patch.
  std::vector<std::int32_t> patch_;
  /// For each label its band, or its row of spheres and tori.
  std::map<std::int32_t, std::int32_t> row_;
};

}  // namespace

KnownFacets known_facets(const TriMesh& mesh, const Topology& topology, const KnownSurfaces& known,
                         const RunContext& context) {
  return KnownFacetFinder(mesh, known).run(topology, context);
}

}  // namespace burin::recognised
