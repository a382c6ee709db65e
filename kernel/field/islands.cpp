#include "islands.h"

#include "links.h"

#include <algorithm>
#include <map>
#include <utility>

namespace burin::field {
namespace {

struct Islands {
  std::vector<std::uint32_t> of_node;
  std::uint32_t count = 0;
};

bool agree(const Links<double>& links, const std::vector<double>& sign, std::uint32_t i,
           std::uint32_t k) {
  return links.coupling[k] * sign[i] * sign[links.neighbour[k]] >= 0;
}

Islands find_islands(const Links<double>& links, const std::vector<double>& sign) {
  Islands islands;
  islands.of_node.assign(links.size(), kNone);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t seed = 0; seed < links.size(); ++seed) {
    if (islands.of_node[seed] != kNone) continue;
    islands.of_node[seed] = islands.count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      for (std::uint32_t k = links.first[i]; k < links.first[i + 1]; ++k) {
        const std::uint32_t j = links.neighbour[k];
        if (islands.of_node[j] != kNone || !agree(links, sign, i, k)) continue;
        islands.of_node[j] = islands.count;
        stack.push_back(j);
      }
    }
    ++islands.count;
  }
  return islands;
}

struct IslandBorder {
  double weight = 0;
  std::uint32_t a = 0, b = 0;
};

// The borders between islands, longest first.
std::vector<IslandBorder> find_island_borders(const Links<double>& links, const Islands& islands) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> weights;
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    for (std::uint32_t k = links.first[i]; k < links.first[i + 1]; ++k) {
      const std::uint32_t a = islands.of_node[i], b = islands.of_node[links.neighbour[k]];
      if (a < b) weights[{a, b}] += std::abs(links.coupling[k]);
    }
  }
  std::vector<IslandBorder> borders;
  for (const auto& [pair, weight] : weights) borders.push_back({weight, pair.first, pair.second});
  std::stable_sort(
      borders.begin(), borders.end(),
      [](const IslandBorder& x, const IslandBorder& y) { return x.weight > y.weight; });
  return borders;
}

// Islands joined into trees; each knows whether it is flipped against the root of its tree.
class Forest {
 public:
  explicit Forest(std::uint32_t count) : parent_(count), size_(count, 1), flipped_(count, 0) {
    for (std::uint32_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::pair<std::uint32_t, bool> root(std::uint32_t i) {
    if (parent_[i] == i) return {i, false};
    const auto [r, flip] = root(parent_[i]);
    flipped_[i] = static_cast<std::uint8_t>((flipped_[i] != 0) != flip);
    parent_[i] = r;
    return {r, flipped_[i] != 0};
  }
  // Makes the two the opposite of one another, unless they are joined already.
  void join_opposite(std::uint32_t a, std::uint32_t b) {
    auto [ra, flip_a] = root(a);
    auto [rb, flip_b] = root(b);
    if (ra == rb) return;
    if (size_[ra] < size_[rb]) std::swap(ra, rb);  // paths stay short
    parent_[rb] = ra;
    size_[ra] += size_[rb];
    flipped_[rb] = static_cast<std::uint8_t>(flip_a == flip_b);
  }

 private:
  std::vector<std::uint32_t> parent_, size_;
  std::vector<std::uint8_t> flipped_;
};

}  // namespace

void join_islands(const Links<double>& links, const std::vector<double>& pull,
                  std::vector<double>& sign) {
  for (double& s : sign) s = s < 0 ? -1 : 1;
  const Islands islands = find_islands(links, sign);
  Forest forest(islands.count);
  for (const IslandBorder& border : find_island_borders(links, islands)) {
    forest.join_opposite(border.a, border.b);
  }
  std::vector<double> votes(islands.count, 0);
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    const auto [root, flip] = forest.root(islands.of_node[i]);
    if (flip) sign[i] = -sign[i];
    votes[root] += pull[i] * sign[i];
  }
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    if (votes[forest.root(islands.of_node[i]).first] < 0) sign[i] = -sign[i];
  }
}

}  // namespace burin::field
