#include "groups.h"

#include <burin/base/disjoint_sets.h>
#include <burin/repair/weld.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace burin {
namespace {

struct GroupEdge {
  std::uint32_t a, b;
  /// Groups of one family may be joined.
  std::uint32_t family, group;
  friend auto operator<=>(const GroupEdge&, const GroupEdge&) = default;
};

/// Groups numbered densely in the order of their first faces; returns their names.
std::vector<std::string> number_by_appearance(GroupedFaces& faces) {
  std::vector<std::uint32_t> number(faces.names.size() + 1, kNoGroup);
  std::vector<std::string> names;
  for (std::uint32_t& g : faces.group) {
    std::uint32_t& n = number[g == kNoGroup ? faces.names.size() : g];
    if (n == kNoGroup) {
      n = static_cast<std::uint32_t>(names.size());
      names.push_back(g == kNoGroup ? std::string() : faces.names[g]);
    }
    g = n;
  }
  return names;
}

using Join = GroupedFaces::Join;

/// Of each group: one for all, or one a name.
std::vector<std::uint32_t> families(const std::vector<std::string>& names, Join join) {
  std::vector<std::uint32_t> family(names.size(), 0);
  if (join != Join::OneName) return family;
  std::unordered_map<std::string_view, std::uint32_t> of_name;
  for (std::uint32_t g = 0; g < names.size(); ++g) {
    family[g] = of_name.try_emplace(names[g], g).first->second;
  }
  return family;
}

/// Joins groups that both end at one edge, and open ones of one name, as GroupedFaces::join says: a
/// solid may be written in pieces.
DisjointSets connect(const GroupedFaces& faces, const std::vector<std::string>& names,
                     const RunContext& context) {
  const std::vector<std::uint32_t> vertex = weld(faces.positions, context).vertex;
  const std::vector<std::uint32_t> family = families(names, faces.join);
  std::vector<GroupEdge> edges;
  edges.reserve(faces.indices.size());
  for (std::size_t f = 0; f + 1 < faces.offsets.size(); ++f) {
    const std::size_t begin = faces.offsets[f], end = faces.offsets[f + 1];
    for (std::size_t c = begin; c < end; ++c) {
      const auto [a, b] = std::minmax(vertex[faces.indices[c]],
                                      vertex[faces.indices[c + 1 == end ? begin : c + 1]]);
      edges.push_back({a, b, family[faces.group[f]], faces.group[f]});
    }
  }
  std::sort(edges.begin(), edges.end(), [&](const GroupEdge& a, const GroupEdge& b) {
    context.check();
    return a < b;
  });
  DisjointSets sets(names.size());
  std::vector<std::uint8_t> ends(names.size(), 0);
  const GroupEdge* open = nullptr;  // the last edge at which a group ends
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) {
      const GroupEdge& edge = edges[i];
      const bool fits =
          open && open->a == edge.a && open->b == edge.b && open->family == edge.family;
      if (fits) sets.join(open->group, edge.group);
      open = &edge;
      ends[edge.group] = 1;
    }
    i = next;
  }
  if (faces.join == Join::OneName) return sets;
  std::unordered_map<std::string_view, std::uint32_t> of_name;
  for (std::uint32_t g = 0; g < names.size(); ++g) {
    if (ends[g] && !names[g].empty()) sets.join(of_name.try_emplace(names[g], g).first->second, g);
  }
  return sets;
}

/// Joins the groups that are one surface; returns their names.
std::vector<std::string> joined(GroupedFaces& faces, std::vector<std::string> names,
                                Diagnostics& diagnostics, const RunContext& context) {
  DisjointSets sets = connect(faces, names, context);
  const std::size_t before = names.size();
  const bool alike = std::ranges::all_of(names, [&](const auto& n) { return n == names.front(); });
  for (std::uint32_t& g : faces.group) g = sets.find(g);
  faces.names = std::move(names);
  names = number_by_appearance(faces);
  if (names.size() < before && faces.join == Join::Connected) {
    diagnostics.add(Severity::Info, "mesh.joined_groups",
                    static_cast<std::int64_t>(before - names.size()),
                    "groups whose open borders fit together were read as one part");
    if (names.size() == 1 && !alike)
      names[0].clear();  // the name of a piece is not that of the whole
  }
  return names;
}

/// One use a group, with the colours that its faces have.
void add_looks(const GroupedFaces& faces, std::size_t groups, MeshFile& file) {
  if (faces.color.empty()) return;
  std::vector<FaceLooks> looks(groups);
  for (std::size_t f = 0; f < faces.group.size(); ++f) {
    looks[faces.group[f]].add(faces.color[f]);
  }
  for (const FaceLooks& one : looks) add_use(one, file);
}

std::vector<PolygonSoup> soups_of(GroupedFaces faces, std::vector<std::string> names,
                                  const RunContext& context) {
  std::vector<PolygonSoup> soups(names.size());
  for (std::size_t g = 0; g < names.size(); ++g) soups[g].name = std::move(names[g]);
  if (soups.size() == 1) {
    soups[0].positions = std::move(faces.positions);
    soups[0].indices = std::move(faces.indices);
    soups[0].offsets = std::move(faces.offsets);
    soups[0].texture = std::move(faces.texture);
    return soups;
  }
  // For each position the soup that took it last and its place there.
  std::vector<std::uint32_t> owner(faces.positions.size(), kNoGroup), place(faces.positions.size());
  std::vector<std::vector<std::size_t>> faces_of(soups.size());
  for (std::size_t f = 0; f < faces.group.size(); ++f) faces_of[faces.group[f]].push_back(f);
  for (std::uint32_t g = 0; g < soups.size(); ++g) {
    context.check();
    PolygonSoup& soup = soups[g];
    for (const std::size_t f : faces_of[g]) {
      for (std::size_t c = faces.offsets[f]; c < faces.offsets[f + 1]; ++c) {
        const std::uint32_t v = faces.indices[c];
        if (owner[v] != g) {
          owner[v] = g;
          place[v] = static_cast<std::uint32_t>(soup.positions.size());
          soup.positions.push_back(faces.positions[v]);
        }
        soup.indices.push_back(place[v]);
        if (!faces.texture.empty()) soup.texture.push_back(faces.texture[c]);
      }
      soup.offsets.push_back(soup.indices.size());
    }
  }
  return soups;
}

bool has_repeated(std::vector<std::string> names) {
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) != names.end();
}

}  // namespace

void add_use(const FaceLooks& looks, MeshFile& file) {
  report_many_colors(looks.too_many() ? 1 : 0, file.diagnostics);
  Appearance one = looks.look();
  file.polygon_colors.push_back(looks.colors());
  file.uses.push_back(
      {.object = file.uses.size(), .color = std::move(one.color), .opacity = one.opacity});
}

void split_groups(GroupedFaces faces, MeshFile& file, const RunContext& context) {
  std::vector<std::string> names = number_by_appearance(faces);
  const bool may_join =
      faces.join == Join::Connected || (faces.join == Join::OneName && has_repeated(names));
  if (may_join && names.size() > 1) {
    names = joined(faces, std::move(names), file.diagnostics, context);
  }
  add_looks(faces, names.size(), file);
  file.objects = soups_of(std::move(faces), std::move(names), context);
}

}  // namespace burin
