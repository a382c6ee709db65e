#include <burin/base/error.h>

#include "stages.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::repair_stages {
namespace {

/// Two pairs of partners may still have the same ends, where a fan comes by one neighbour twice: a
/// new vertex in the middle of all pairs but one tells them apart and changes no shape. Returns
/// whether there was one.
bool split_repeated_edges(TriMesh& mesh, Numbers* of, const RunContext& context) {
  EdgeGroups edges = group_edges(mesh, context);
  std::vector<std::uint8_t> touched(mesh.triangles.size(), 0);  // its half-edges are out of date
  const auto insert = [&](std::uint32_t h, std::uint32_t middle) {
    const std::uint32_t x = from(mesh, h), y = to(mesh, h), b = apex(mesh, h);
    mesh.triangles[h / 3] = {x, middle, b};
    mesh.triangles.push_back({middle, y, b});
    if (of) of->push_back((*of)[h / 3]);
    touched[h / 3] = 1;
  };
  bool found = false;
  for (std::size_t g = 0; g < edges.size(); ++g) {
    const auto group = edges[g];
    // The first two in opposite directions keep the edge.
    std::vector<std::uint32_t> forward, backward;
    const std::uint32_t low = std::min(from(mesh, group[0]), to(mesh, group[0]));
    if (group.size() <= 2) continue;
    found = true;
    if (std::ranges::any_of(group, [&](std::uint32_t h) { return touched[h / 3] != 0; })) continue;
    for (const std::uint32_t h : group) (from(mesh, h) == low ? forward : backward).push_back(h);
    for (std::size_t i = 1; i < std::max(forward.size(), backward.size()); ++i) {
      const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
      const Vec3 a = mesh.positions[from(mesh, group[0])], b = mesh.positions[to(mesh, group[0])];
      mesh.positions.push_back(0.5 * (a + b));
      if (i < forward.size()) insert(forward[i], middle);
      if (i < backward.size()) insert(backward[i], middle);
    }
  }
  return found;
}

void report(const RepairCounts& c, Diagnostics& diagnostics) {
  const auto add = [&](std::int64_t count, Severity severity, const char* code,
                       const char* message) {
    if (count > 0) diagnostics.add(severity, code, count, message);
  };
  add(c.repeated_corners, Severity::Warning, "mesh.degenerate_faces",
      "triangles with two equal corners were left out");
  add(c.duplicates, Severity::Warning, "mesh.duplicate_faces",
      "triangles that repeat another one were left out");
  add(c.flat, Severity::Warning, "mesh.zero_area_faces",
      "triangles without area were removed, their neighbours joined");
  add(c.flat_dropped, Severity::Warning, "mesh.holes",
      "triangles without area could not be joined to neighbours and leave slits");
  add(c.flipped, Severity::Warning, "mesh.flipped_faces",
      "triangles were turned over to agree with their neighbours");
  add(c.nonorientable_edges, Severity::Warning, "mesh.nonorientable",
      "edges at which a one-sided surface was cut open");
  add(c.nonmanifold_edges, Severity::Warning, "mesh.nonmanifold_edges",
      "edges of more than two triangles were taken apart");
  add(c.nonmanifold_vertices, Severity::Warning, "mesh.nonmanifold_vertices",
      "vertices where separate pieces touch were taken apart");
}

}  // namespace

void split_fans(TriMesh& mesh, const std::vector<std::uint32_t>& opposite, const EdgeGroups& edges,
                RepairCounts& counts) {
  std::vector<std::uint8_t> at_bad_edge(mesh.positions.size(), 0);
  for (std::size_t g = 0; g < edges.size(); ++g) {
    const auto group = edges[g];
    const bool good = group.size() == 1 || (group.size() == 2 && opposite[group[0]] == group[1]);
    if (good) continue;
    for (const std::uint32_t h : group) at_bad_edge[from(mesh, h)] = at_bad_edge[to(mesh, h)] = 1;
  }
  std::vector<std::uint8_t> seen(opposite.size(), 0), used(mesh.positions.size(), 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> moved;  // corner and its new vertex
  for (std::uint32_t start = 0; start < opposite.size(); ++start) {
    if (seen[start] || repeats_corner(mesh.triangles[start / 3])) continue;
    const std::uint32_t v = from(mesh, start);
    const bool is_new = used[v] != 0;
    const auto vertex = is_new ? static_cast<std::uint32_t>(mesh.positions.size()) : v;
    if (is_new) {
      const Vec3 position = mesh.positions[v];
      mesh.positions.push_back(position);
      if (!at_bad_edge[v] && used[v] == 1) ++counts.nonmanifold_vertices;
      used[v] = 2;
    } else {
      used[v] = 1;
    }
    const auto take = [&](std::uint32_t h) {
      seen[h] = 1;
      if (is_new) moved.emplace_back(h, vertex);
    };
    take(start);
    std::uint32_t h = opposite[prev_half_edge(start)];
    for (; h != kNone && h != start; h = opposite[prev_half_edge(h)]) take(h);
    if (h == start) continue;
    for (h = opposite[start]; h != kNone; h = opposite[h]) {
      h = next_half_edge(h);
      take(h);
    }
  }
  for (const auto& [corner, vertex] : moved) mesh.triangles[corner / 3][corner % 3] = vertex;
}

void make_manifold(TriMesh& mesh, Numbers* of, Diagnostics& diagnostics,
                   const RunContext& context) {
  RepairCounts counts;
  join_tiny_edges(mesh);
  counts.repeated_corners = erase_triangles(mesh, of, repeats_corner);
  counts.duplicates = drop_duplicates(mesh, of, context);
  // Mending may lay bare a further defect, or among slivers go in circles: later rounds only cut
  // apart.
  constexpr int kMendingRounds = 4, kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    context.check();
    const bool cut = round >= kMendingRounds;
    RepairCounts again;  // what later rounds find is of our own making
    RepairCounts& now = round == 0 ? counts : again;
    EdgeGroups edges = group_edges(mesh, context);
    orient_patches(mesh, edges, now, context);
    std::vector<std::uint32_t> opposite = match_half_edges(mesh, edges, cut, now);
    remove_flat(mesh, opposite, of, cut, now, context);
    split_fans(mesh, opposite, edges, now);
    erase_triangles(mesh, of, repeats_corner);
    if (!cut && split_repeated_edges(mesh, of, context)) continue;
    if (inspect(mesh, context).clean()) break;
  }
  drop_unused_positions(mesh);
  report(counts, diagnostics);
  if (!mesh.triangles.empty() && !inspect(mesh, context).clean()) {
    throw GeometryError(
        "the triangles cannot be made into surfaces; mend the model in a mesh editor");
  }
}

}  // namespace burin::repair_stages
