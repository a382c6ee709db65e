#include "evaluated_part.h"

#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/straight_corners.h>
#include <burin/repair/repair.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace burin::detail {
namespace {

/// Of the largest coordinate: corners of cuts are exact but for their last rounding.
constexpr double kCutDigits = 1e-9;

/// The corners of a triangle by their coordinates, beginning with the least: repair may number
/// points anew, but moves none.
struct Corners {
  std::array<Vec3, 3> at;
  bool operator==(const Corners&) const = default;
};

bool before(const Vec3& a, const Vec3& b) {
  return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
}

Corners corners_of(const std::vector<Vec3>& positions, const Triangle& t) {
  Corners c{{positions[t[0]], positions[t[1]], positions[t[2]]}};
  std::ranges::sort(c.at, before);
  return c;
}

struct HashCorners {
  std::size_t operator()(const Corners& c) const {
    std::uint64_t h = 0;
    for (const Vec3& p : c.at) {
      for (int k = 0; k < 3; ++k) {
        h = (h ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;
        h ^= h >> 29;
      }
    }
    return static_cast<std::size_t>(h);
  }
};

/// For each triangle of the repaired mesh what it stands for.
std::vector<std::int32_t> surfaces_of(const csg::Solid& solid, const TriMesh& mesh) {
  if (mesh.triangles == solid.triangles && mesh.positions == solid.positions) return solid.surface;
  std::unordered_map<Corners, std::int32_t, HashCorners> known;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    known.emplace(corners_of(solid.positions, solid.triangles[t]), solid.surface[t]);
  }
  std::vector<std::int32_t> out;
  for (const Triangle& t : mesh.triangles) {
    const auto at = known.find(corners_of(mesh.positions, t));
    out.push_back(at == known.end() ? csg::kMeantFlat : at->second);
  }
  return out;
}

/// Whether facets meet in an edge that a mesh would take for a smooth one: by less than the crease
/// angle, and more than what rounding makes of one plane.
bool has_gentle_edges(const TriMesh& mesh) {
  constexpr double kPlane = 0.5, kCrease = 30;  // degrees
  constexpr double kSliver = 1e-5;              // of the size: its normal says nothing
  const double least = kSliver * mesh.bounds().diagonal();
  std::unordered_map<std::uint64_t, Vec3> normals;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 twice = glm::cross(b - a, c - a);
    const double area = glm::length(twice),
                 longest =
                     std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    if (!(area > least * longest)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = std::minmax(t[k], t[(k + 1) % 3]);
      const std::uint64_t edge = (static_cast<std::uint64_t>(from) << 32) | to;
      const auto [other, fresh] = normals.try_emplace(edge, twice / area);
      if (fresh) continue;
      const double angle = glm::degrees(std::atan2(glm::length(glm::cross(other->second, twice)),
                                                   glm::dot(other->second, twice)));
      if (angle > kPlane && angle < kCrease) return true;
    }
  }
  return false;
}

}  // namespace

TriMesh repaired(const csg::Solid& solid, const std::string& name, Diagnostics& diagnostics,
                 const RunContext& context) {
  constexpr std::array<std::string_view, 4> kOfRounding{
      "mesh.degenerate_faces", "mesh.zero_area_faces", "mesh.nonmanifold_edges",
      "mesh.nonmanifold_vertices"};
  Diagnostics found;
  TriMesh mesh = repair(soup_of(solid), {}, found, context);
  for (Diagnostic d : found.entries()) {
    if (std::ranges::find(kOfRounding, d.code) != kOfRounding.end()) continue;
    if (!name.empty()) d.message = name + ": " + d.message;
    diagnostics.add(std::move(d));
  }
  return mesh;
}

PolygonSoup soup_of(const csg::Solid& solid) {
  PolygonSoup soup;
  soup.positions = solid.positions;
  for (const auto& t : solid.triangles) {
    soup.indices.insert(soup.indices.end(), t.begin(), t.end());
    soup.offsets.push_back(soup.indices.size());
  }
  return soup;
}

std::shared_ptr<const Form> form_of(csg::Solid solid, Facets facets, const std::string& name,
                                    Diagnostics& diagnostics, const RunContext& context) {
  TriMesh mesh = repaired(solid, name, diagnostics, context);
  if (facets == Facets::Judged) {
    std::ranges::replace(solid.surface, csg::kMeantFlat, KnownSurfaces::kUnknown);
  }
  const bool flat =
      std::ranges::all_of(solid.surface, [](std::int32_t s) { return s == csg::kMeantFlat; });
  // What is meant flat stays flat, however gently it meets its neighbours.
  if (facets == Facets::Flat || (flat && !has_gentle_edges(mesh))) {
    return std::make_shared<MeshForm>(std::move(mesh));
  }
  KnownSurfaces known;
  known.of = surfaces_of(solid, mesh);
  // Diagonals of other facets leave corners in the middle of edges that stand for rims.
  remove_straight_corners(mesh, {.digits = kCutDigits}, context, &known.of);
  known.surfaces = std::move(solid.surfaces);
  auto form = std::make_shared<RecognisedForm>(std::move(mesh), known, context);
  report_round_faces(form->faces(), name, diagnostics);
  if (form->is_mesh()) return std::make_shared<MeshForm>(form->mesh());
  return form;
}

}  // namespace burin::detail
