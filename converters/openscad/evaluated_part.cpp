#include "evaluated_part.h"

#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/repair/repair.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace burin::detail {
namespace {

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

/// Repairs what was worked out. Rounded corners fall together and solids touch along edges: of a
/// program that is right nobody has to hear so.
TriMesh repaired(const csg::Solid& solid, const std::string& name, Diagnostics& diagnostics,
                 const RunContext& context) {
  constexpr std::array<std::string_view, 4> kOfRounding{
      "mesh.degenerate_faces", "mesh.zero_area_faces", "mesh.nonmanifold_edges",
      "mesh.nonmanifold_vertices"};
  Diagnostics found;
  TriMesh mesh = repair(soup_of(solid), {}, found, context);
  for (Diagnostic d : found.entries()) {
    if (std::ranges::find(kOfRounding, d.code) != kOfRounding.end()) continue;
    d.message = name + ": " + d.message;
    diagnostics.add(std::move(d));
  }
  return mesh;
}

}  // namespace

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
  if (facets == Facets::Flat || flat) return std::make_shared<MeshForm>(std::move(mesh));
  KnownSurfaces known;
  known.of = surfaces_of(solid, mesh);
  known.surfaces = std::move(solid.surfaces);
  auto form = std::make_shared<RecognisedForm>(std::move(mesh), known, context);
  tell_round_faces(form->faces(), name, diagnostics);
  if (form->faces().total() == 0) return std::make_shared<MeshForm>(form->mesh());
  return form;
}

}  // namespace burin::detail
