#include "evaluated_part.h"

#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/straight_corners.h>
#include <burin/repair/repair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace burin::detail {
namespace {

/// Of the largest coordinate: corners of cuts are exact but for their last rounding.
constexpr double kCutDigits = 1e-9;

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
                 const RunContext& context, std::vector<std::int32_t>* surfaces) {
  constexpr std::array<std::string_view, 4> kOfRounding{
      "mesh.degenerate_faces", "mesh.zero_area_faces", "mesh.nonmanifold_edges",
      "mesh.nonmanifold_vertices"};
  Diagnostics found;
  if (surfaces) *surfaces = solid.surface;
  TriMesh mesh = repair(soup_of(solid), {}, found, context, surfaces);
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
  KnownSurfaces known;
  TriMesh mesh = repaired(solid, name, diagnostics, context, &known.of);
  if (facets == Facets::Judged) {
    std::ranges::replace(known.of, csg::kMeantFlat, KnownSurfaces::kUnknown);
  }
  const bool flat =
      std::ranges::all_of(known.of, [](std::int32_t s) { return s == csg::kMeantFlat; });
  // What is meant flat stays flat, however gently it meets its neighbours.
  if (facets == Facets::Flat || (flat && !has_gentle_edges(mesh))) {
    return std::make_shared<MeshForm>(std::move(mesh));
  }
  // Diagonals of other facets leave corners in the middle of edges that stand for rims.
  remove_straight_corners(mesh, {.digits = kCutDigits}, context, &known.of);
  known.surfaces = std::move(solid.surfaces);
  auto form = std::make_shared<RecognisedForm>(std::move(mesh), known, context);
  report_round_faces(form->faces(), name, diagnostics);
  if (form->is_mesh()) return std::make_shared<MeshForm>(form->mesh());
  return form;
}

}  // namespace burin::detail
