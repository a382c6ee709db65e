#include "flat_trees.h"

#include <burin/base/disjoint_sets.h>
#include <burin/converters/mesh_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace burin::csg::test {
namespace {

double volume_of(const std::vector<Vec3>& p, const std::vector<std::array<std::uint32_t, 3>>& all) {
  double sum = 0;
  for (const auto& [a, b, c] : all)
    sum += glm::dot(p[a] - p[0], glm::cross(p[b] - p[0], p[c] - p[0]));
  return sum / 6;
}

void append(Solid& to, const Solid& more) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const auto row = static_cast<std::int32_t>(to.surfaces.size());
  to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& [a, b, c] : more.triangles)
    to.triangles.push_back({first + a, first + b, first + c});
  for (const std::int32_t s : more.surface) to.surface.push_back(s < 0 ? -1 : row + s);
  to.surfaces.insert(to.surfaces.end(), more.surfaces.begin(), more.surfaces.end());
}

bool run(const std::string& command) { return std::system(command.c_str()) == 0; }

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

double distance_to_profile(const Turned& t, Vec2 p) {
  if (t.profile == Turned::Profile::Circle) return std::abs(glm::length(p - t.middle) - t.radius);
  const Vec2 d = t.b - t.a;
  return std::abs(cross2(p - t.a, d)) / glm::length(d);
}

}  // namespace

Evaluated::Evaluated(const std::string& text, const std::filesystem::path& folder)
    : tree_(parse(text, "test.csg", run_)),
      e_{tree_, folder, run_},
      dimensions_(dimensions(tree_)) {}

Region Evaluated::region() { return region_of(0); }
Solid Evaluated::solid() { return solid_of(0); }

bool Evaluated::reported(const std::string& code) const {
  return std::ranges::any_of(e_.diagnostics.entries(),
                             [&](const Diagnostic& d) { return d.code == code; });
}

bool Evaluated::is_flat() const { return dimensions_[0] == Dimension::Flat; }

Region Evaluated::region_of(std::uint32_t node) {
  const Node& n = tree_.nodes[node];
  std::vector<Region> children;
  if (n.module == Module::Projection) {
    Solid all;
    for_each_child(tree_, node, [&](std::uint32_t c) { append(all, solid_of(c)); });
    return projected(e_, node, all);
  }
  if (n.module >= Module::Square && n.module <= Module::Import) return leaf_region(e_, node);
  for_each_child(tree_, node, [&](std::uint32_t c) {
    if (tree_.nodes[c].background) return;
    children.push_back(dimensions_[c] == Dimension::Flat ? region_of(c) : Region{});
  });
  return combine_regions(e_, node, children);
}

Solid Evaluated::solid_of(std::uint32_t node) {
  const Node& n = tree_.nodes[node];
  if (n.module == Module::LinearExtrude || n.module == Module::RotateExtrude) {
    std::vector<Region> children;
    for_each_child(tree_, node, [&](std::uint32_t c) { children.push_back(region_of(c)); });
    return extruded(e_, node, combine_regions(e_, node, children));
  }
  if (n.module == Module::Import || n.module == Module::Surface) return file_solid(e_, node);
  Solid all;
  for_each_child(tree_, node, [&](std::uint32_t c) {
    if (!tree_.nodes[c].background && dimensions_[c] == Dimension::Solid) append(all, solid_of(c));
  });
  if (n.module == Module::Multmatrix) {
    const Matrix m = matrix_of(tree_, node);
    for (Vec3& p : all.positions) {
      const auto q = m * std::array<double, 3>{p.x, p.y, p.z};
      p = {q[0], q[1], q[2]};
    }
    if (m.determinant() < 0) {
      for (auto& t : all.triangles) std::swap(t[1], t[2]);
    }
  }
  return all;
}

double volume(const Solid& solid) {
  return solid.empty() ? 0 : volume_of(solid.positions, solid.triangles);
}

std::string flaw(const Solid& solid) {
  if (solid.surface.size() != solid.triangles.size()) return "not one surface a triangle";
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> corner;
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = solid.triangles[t][k], b = solid.triangles[t][(k + 1) % 3];
      if (solid.positions[a] == solid.positions[b]) {
        return fmt::format("triangle {} has two corners at one place", t);
      }
      if (!corner.emplace(std::pair(a, b), 3 * t + k).second) {
        return fmt::format("two triangles run alike from {} to {}", a, b);
      }
    }
  }
  DisjointSets fans(3 * solid.triangles.size());
  const auto next = [](std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
  for (const auto& [edge, c] : corner) {
    const auto other = corner.find({edge.second, edge.first});
    if (other == corner.end()) return fmt::format("open from {} to {}", edge.first, edge.second);
    fans.join(c, next(other->second));
  }
  std::map<std::uint32_t, std::uint32_t> fan_of;
  for (std::uint32_t c = 0; c < 3 * solid.triangles.size(); ++c) {
    const std::uint32_t v = solid.triangles[c / 3][c % 3];
    if (fan_of.try_emplace(v, fans.find(c)).first->second != fans.find(c)) {
      return fmt::format("surfaces touch in vertex {}", v);
    }
  }
  return fan_of.size() == solid.positions.size() ? "" : "positions without triangles";
}

double farthest_from_arcs(const Region& region) {
  double most = 0;
  for (const Outline& o : region.outlines) {
    for (std::size_t i = 0; i < o.points.size(); ++i) {
      if (o.arc[i] < 0) continue;
      const Arc& arc = region.arcs[static_cast<std::size_t>(o.arc[i])];
      for (const std::size_t j : {i, (i + 1) % o.points.size()}) {
        most = std::max(most, std::abs(glm::length(o.points[j] - arc.middle) - arc.radius));
      }
    }
  }
  return most;
}

std::size_t tagged_edges(const Region& region) {
  std::size_t count = 0;
  for (const Outline& o : region.outlines) {
    count += o.points.size() - static_cast<std::size_t>(std::ranges::count(o.arc, -1));
  }
  return count;
}

double farthest_from_surfaces(const Solid& solid) {
  double most = 0;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    if (solid.surface[t] < 0) continue;
    const Turned& turned = solid.surfaces[static_cast<std::size_t>(solid.surface[t])];
    for (const std::uint32_t v : solid.triangles[t]) {
      const Vec3 p = solid.positions[v] - turned.origin;
      const double up = glm::dot(p, turned.axis);
      most = std::max(most, distance_to_profile(turned, {glm::length(p - up * turned.axis), up}));
    }
  }
  return most;
}

std::size_t tagged_triangles(const Solid& solid) {
  return solid.surface.size() - static_cast<std::size_t>(std::ranges::count(solid.surface, -1));
}

std::optional<std::string> tree_of(const std::filesystem::path& program) {
  const Folder folder;
  const std::filesystem::path out = folder / "tree.csg";
  if (!run("cd " + quoted(program.parent_path()) + " && openscad -o " + quoted(out) + " " +
           quoted(program) + " >/dev/null 2>&1")) {
    return std::nullopt;
  }
  return ::burin::test::slurp(out);
}

double openscad_volume(const std::filesystem::path& file) {
  const Folder folder;
  const std::filesystem::path out = folder / "solid.off";
  if (!run("cd " + quoted(file.parent_path()) + " && openscad -o " + quoted(out) + " " +
           quoted(file) + " >/dev/null 2>&1")) {
    return 0;
  }
  const RunContext context;
  const MeshFile mesh = read_mesh_file(out, context);
  double sum = 0;
  for (const PolygonSoup& soup : mesh.objects) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < soup.polygon_count(); ++i) {
      for (std::size_t k = soup.offsets[i] + 2; k < soup.offsets[i + 1]; ++k) {
        triangles.push_back({soup.indices[soup.offsets[i]], soup.indices[k - 1], soup.indices[k]});
      }
    }
    sum += volume_of(soup.positions, triangles);
  }
  return sum;
}

}  // namespace burin::csg::test
