#include "clusters.h"

#include "boxes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace burin {
namespace {

// A cell and those around it.
template <class Visit>
void for_around(Cell cell, const Visit& visit) {
  for (int k = 0; k < 27; ++k) visit(cell + Cell(k % 3, k / 3 % 3, k / 9) - 1);
}

}  // namespace

std::vector<Cluster> clusters_of(const std::vector<HiddenPlace>& places) {
  struct InCell {
    Box3 box;
    double side = 0;
  };
  const auto before = [](const Cell& a, const Cell& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<Cell, InCell, decltype(before)> cells(before);
  for (const HiddenPlace& p : places) {
    InCell& c = cells[p.cell];
    c.box.add(p.box.min);
    c.box.add(p.box.max);
    c.side = std::max(c.side, longest(p.box));
  }
  std::map<Cell, std::uint32_t, decltype(before)> number(before);
  for (const auto& [cell, in] : cells) {
    number.emplace(cell, static_cast<std::uint32_t>(number.size()));
  }
  DisjointSets sets(cells.size());
  for (const auto& [cell, n] : number) {
    for (int k = 0; k < 27; ++k) {
      const auto it = number.find(cell + Cell(k % 3, k / 3 % 3, k / 9) - 1);
      if (it != number.end()) sets.join(n, it->second);
    }
  }
  std::map<std::uint32_t, Cluster> clusters;
  std::map<std::uint32_t, std::vector<double>> sides;
  for (const auto& [cell, in] : cells) {
    Cluster& c = clusters[sets.find(number.at(cell))];
    c.cells.push_back(cell);
    c.box.add(in.box.min);
    c.box.add(in.box.max);
    sides[sets.find(number.at(cell))].push_back(in.side);
  }
  for (const HiddenPlace& p : places) {
    clusters[sets.find(number.at(p.cell))].places.push_back(p);
  }
  std::vector<Cluster> out;
  for (auto& [name, c] : clusters) {
    std::vector<double>& s = sides[name];
    std::ranges::nth_element(s, s.begin() + static_cast<std::ptrdiff_t>(s.size() / 2));
    c.side = s[s.size() / 2];
    out.push_back(std::move(c));
  }
  return out;
}

PassedCells::PassedCells(const ExactMesh& mesh, const std::vector<HiddenPlace>& places,
                         const GridLayout& layout)
    : parts_(mesh), step_(layout.step) {
  in_cell_.reserve(8 * places.size());
  for (const HiddenPlace& p : places) {
    for_around(p.cell, [&](Cell c) { in_cell_.try_emplace(name_of(c)); });
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      const auto it = in_cell_.find(name_of(layout.cell_of(mesh.positions[v])));
      if (it == in_cell_.end()) continue;
      const std::uint32_t part = parts_.sets.find(v);
      if (std::ranges::find(it->second, part) == it->second.end()) it->second.push_back(part);
    }
  }
}

double PassedCells::share(const Cluster& cluster) const {
  const auto n = std::ranges::count_if(
      cluster.cells, [&](const Cell& c) { return !in_cell_.at(name_of(c)).empty(); });
  return static_cast<double>(n) / static_cast<double>(cluster.cells.size());
}

bool PassedCells::spans(std::uint32_t component, const Box3& box) const {
  constexpr double kMost = 0.6, kMargin = 2;
  const Vec3 own = parts_.boxes[component].size(), wanted = kMost * box.size() - kMargin * step_;
  return glm::all(glm::greaterThanEqual(own, wanted));
}

double PassedCells::longest_missing(const Cluster& cluster) const {
  Box3 missing;
  for (const HiddenPlace& p : cluster.places) {
    bool passed = false;
    for_around(p.cell, [&](Cell c) {
      const auto it = in_cell_.find(name_of(c));
      if (it == in_cell_.end()) return;
      passed |=
          std::ranges::any_of(it->second, [&](std::uint32_t k) { return spans(k, cluster.box); });
    });
    if (!passed) missing.add(p.box);
  }
  return longest(missing);
}

}  // namespace burin
