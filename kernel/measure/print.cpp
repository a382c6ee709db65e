#include <burin/measure/print.h>

#include "fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace burin {
namespace {

/// How much apart prints may be, and how much each of these counts for.
constexpr double kFar = 0.5;
constexpr double kPlace = 3;   // a diagonal of the part
constexpr double kSize = 0.7;  // a factor of e
constexpr double kTurn = 1;    // a radian
constexpr double kBeside = 0.4;

Vec3 middle_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return box.center();
}

FeaturePrint print_of(const Feature& f, const Box3& box) {
  FeaturePrint out{
      .kind = f.kind, .size = f.size, .at = middle_of(f.points) - box.min, .box = box.size()};
  if (f.is_round()) out.radius = f.radius;
  if (f.has_axis() || f.kind == FeatureKind::Plane || f.kind == FeatureKind::Line) {
    out.along = f.along;
  }
  return out;
}

double factor(double a, double b) {
  if (a == b) return 0;
  return a > 0 && b > 0 ? std::abs(std::log(a / b)) : std::numeric_limits<double>::infinity();
}

/// How far two places are apart along each side of the part, from the end that changed less.
double apart(const FeaturePrint& a, const FeaturePrint& b) {
  Vec3 least(0);
  for (int k = 0; k < 3; ++k) {
    const double low = std::abs(a.at[k] - b.at[k]),
                 high = std::abs((a.box[k] - a.at[k]) - (b.box[k] - b.at[k])),
                 middle = std::abs((a.at[k] - 0.5 * a.box[k]) - (b.at[k] - 0.5 * b.box[k]));
    least[k] = std::min({low, high, middle});
  }
  const double diagonal = glm::length(a.box);
  return diagonal > 0 ? glm::length(least) / diagonal : glm::length(least);
}

/// Share of the faces beside that only one of both has.
double other_beside(const FeaturePrint& a, const FeaturePrint& b) {
  std::vector<FeatureKind> common;
  std::ranges::set_intersection(a.beside, b.beside, std::back_inserter(common));
  const auto all = static_cast<double>(a.beside.size() + b.beside.size());
  return all > 0 ? 1 - 2 * static_cast<double>(common.size()) / all : 0;
}

double distance(const FeaturePrint& a, const FeaturePrint& b) {
  if (a.kind != b.kind) return std::numeric_limits<double>::infinity();
  // Axes and ways have no sense; normals do.
  const double cosine = glm::dot(a.along, b.along),
               sine = glm::length(glm::cross(a.along, b.along));
  const double turn =
      a.kind == FeatureKind::Plane ? std::atan2(sine, cosine) : std::atan2(sine, std::abs(cosine));
  // Of what is round the radius says more than the area, which goes with the length.
  const double size = a.radius > 0 ? factor(a.radius, b.radius) + 0.2 * factor(a.size, b.size)
                                   : 0.3 * factor(a.size, b.size);
  return kPlace * apart(a, b) + kSize * size + (a.along == Vec3(0) ? 0 : kTurn * turn) +
         kBeside * other_beside(a, b);
}

}  // namespace

FeatureIndex::FeatureIndex(const Surface& surface, bool edges, const RunContext& context) {
  const ProxyMesh& proxy = surface.proxy();
  const Box3 box = proxy.mesh.bounds();
  std::map<std::int32_t, std::set<std::int32_t>> beside, along_edge;
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(proxy.topology.opposite.size()); ++h) {
    const auto k = static_cast<std::size_t>(h);
    const HalfEdge other = proxy.topology.opposite[k];
    const std::int32_t own = proxy.face_source(face_of(h));
    if (proxy.is_cut(face_of(h))) continue;
    if (edges && !proxy.source_edge.empty() && proxy.source_edge[k] >= 0) {
      along_edge[proxy.source_edge[k]].insert(own);
    }
    if (other == kNoHalfEdge || proxy.is_cut(face_of(other))) continue;
    const std::int32_t next = proxy.face_source(face_of(other));
    if (next != own) beside[own].insert(next);
  }
  std::map<std::int32_t, FeatureKind> kinds;
  for (const auto& [number, triangles] : triangles_of_faces(proxy)) {
    const Feature f = detail::feature_of(surface, number, triangles, context);
    kinds[number] = f.kind;
    faces_.push_back({number, print_of(f, box)});
  }
  const auto set_beside = [&](FeaturePrint& print, const std::set<std::int32_t>& faces) {
    for (const std::int32_t face : faces) print.beside.push_back(kinds[face]);
    std::ranges::sort(print.beside);
  };
  for (Entry& face : faces_) set_beside(face.print, beside[face.number]);
  for (const auto& [number, faces] : along_edge) {
    context.check();
    edges_.push_back({number, print_of(*edge_feature(surface, number), box)});
    set_beside(edges_.back().print, faces);
  }
}

std::optional<FeaturePrint> FeatureIndex::entry(const std::vector<Entry>& list,
                                                std::int32_t number) {
  const auto found = std::ranges::find(list, number, &Entry::number);
  return found == list.end() ? std::nullopt : std::optional(found->print);
}

std::optional<FeaturePrint> FeatureIndex::face(std::int32_t number) const {
  return entry(faces_, number);
}
std::optional<FeaturePrint> FeatureIndex::edge(std::int32_t number) const {
  return entry(edges_, number);
}

std::optional<std::int32_t> FeatureIndex::find(const std::vector<Entry>& list,
                                               const FeaturePrint& print, std::int32_t number) {
  constexpr double kAsNear = 1e-6;
  std::optional<std::int32_t> best;
  double least = kFar;
  for (const Entry& one : list) {
    const double d = distance(print, one.print);
    const bool same = d <= least + kAsNear && one.number == number;
    if (d < least - kAsNear || same) least = std::min(d, least), best = one.number;
  }
  return best;
}

std::optional<std::int32_t> FeatureIndex::find_face(const FeaturePrint& print,
                                                    std::int32_t number) const {
  return find(faces_, print, number);
}
std::optional<std::int32_t> FeatureIndex::find_edge(const FeaturePrint& print,
                                                    std::int32_t number) const {
  return find(edges_, print, number);
}

}  // namespace burin
