#include "order.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// A level while it is taken apart.
class Taking {
 public:
  Taking(std::vector<Node> nodes, const Situation& s) : s_(s), nodes_(std::move(nodes)) {
    base_part_ = largest();
    rebuild();
  }

  Level run() {
    while (alive_ > 1) {
      s_.context.check();
      if (take_free() || take_knot() || open_assemblies()) continue;
      lock();
    }
    level_.base = nodes_[base_];
    return std::move(level_);
  }

 private:
  std::size_t largest() const {
    std::size_t best = kNone;
    double most = -1;
    for (const Node& node : nodes_) {
      for (const std::size_t part : node.parts) {
        if (s_.options.base == part) return part;
        const Vec3 size = s_.shapes.boxes[part].size();
        const double volume = size.x * size.y * size.z;
        constexpr double kSame = 1 + 1e-6;
        if (best == kNone || volume > kSame * most || (volume * kSame > most && part < best)) {
          most = volume;
          best = part;
        }
      }
    }
    return best;
  }

  /// Who blocks whom, of the nodes that are there.
  void rebuild() {
    alive_ = nodes_.size();
    there_.assign(nodes_.size(), true);
    of_part_.assign(s_.shapes.boxes.size(), kNone);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      for (const std::size_t part : nodes_[n].parts) {
        of_part_[part] = n;
        if (part == base_part_) base_ = n;
      }
    }
    blockers_.assign(s_.directions(), std::vector<std::vector<std::size_t>>(nodes_.size()));
    for (std::size_t axis = 0; axis < s_.views.size(); ++axis) {
      for (const auto& [a, b] : s_.views[axis].ahead) {
        const std::size_t one = of_part_[a], other = of_part_[b];
        if (one == kNone || other == kNone || one == other) continue;
        blockers_[2 * axis][one].push_back(other);
        blockers_[2 * axis + 1][other].push_back(one);
      }
    }
    count_.assign(s_.directions(), std::vector<std::size_t>(nodes_.size()));
    blocked_.assign(s_.directions(), std::vector<std::vector<std::size_t>>(nodes_.size()));
    for (std::size_t d = 0; d < s_.directions(); ++d) {
      for (std::size_t n = 0; n < nodes_.size(); ++n) {
        auto& list = blockers_[d][n];
        std::ranges::sort(list);
        list.erase(std::unique(list.begin(), list.end()), list.end());
        count_[d][n] = list.size();
        for (const std::size_t by : list) blocked_[d][by].push_back(n);
      }
    }
    ways_.assign(s_.directions() * nodes_.size(), {});
  }

  void remove(std::size_t node) {
    there_[node] = false;
    --alive_;
    for (const std::size_t part : nodes_[node].parts) of_part_[part] = kNone;
    for (std::size_t d = 0; d < s_.directions(); ++d) {
      for (const std::size_t n : blocked_[d][node]) --count_[d][n];
    }
  }

  /// How far some parts have to go to clear those that are there, and which node is the last.
  std::pair<double, std::size_t> way_out(const std::vector<std::size_t>& parts, std::size_t d,
                                         const std::vector<std::size_t>& except) const {
    const AxisView& view = s_.view(d);
    std::pair<double, std::size_t> way(0, kNone);
    for (const std::size_t part : parts) {
      const double from = s_.reach(d, view.boxes[part]).x;
      for (const Column& other : view.columns[part]) {
        const std::size_t node = of_part_[other.part];
        const double by = s_.reach(d, other).y - from;
        if (node == kNone || by <= way.first) continue;
        if (std::ranges::find(except, node) == except.end()) way = {by, node};
      }
    }
    return way;
  }

  double way_of(std::size_t node, std::size_t d) {
    Way& way = ways_[d * nodes_.size() + node];
    if (!way.known || (way.last != kNone && !there_[way.last])) {
      const auto [by, last] = way_out(nodes_[node].parts, d, {node});
      way = {by, last, true};
    }
    return way.by;
  }

  bool touches(const std::vector<std::size_t>& parts, const std::vector<std::size_t>& own) const {
    return std::ranges::any_of(parts, [&](std::size_t part) {
      return std::ranges::any_of(s_.neighbours[part], [&](const Neighbour& other) {
        const std::size_t node = of_part_[other.part];
        return node != kNone && std::ranges::find(own, node) == own.end();
      });
    });
  }

  Vec3 middle(const std::vector<std::size_t>& parts) const {
    Box3 box;
    for (const std::size_t part : parts) box.add(s_.shapes.boxes[part]);
    return box.center();
  }

  /// What makes one choice better than another, the least first: parts, loose ones last, way out
  /// (in steps of a millionth of the assembly, so that rounding decides nothing), away from what
  /// stays, name.
  struct Rank {
    std::size_t parts = 0;
    bool loose = false;
    double way = 0, inwards = 0;
    std::string name;
    std::size_t first = 0, direction = 0;

    auto key() const { return std::tie(parts, loose, way, inwards, name, first, direction); }
    bool operator<(const Rank& other) const { return key() < other.key(); }
  };

  double stepped(double mm) const { return std::round(1e6 * mm / s_.shapes.diagonal); }

  Rank rank(const std::vector<std::size_t>& parts, const std::vector<std::size_t>& own,
            std::size_t d, double way) const {
    const Vec3 away = middle(parts) - middle(nodes_[base_].parts);
    const Vec3 along = in_rows(s_.shapes.frame, s_.along(d));
    // Axes of contacts are as good as what is known of them: they have to be worth it.
    constexpr std::size_t kOwnAxes = 3;
    constexpr double kWorth = 0.02;  // of the assembly's diagonal
    const double detour = d / 2 < kOwnAxes ? 0 : kWorth * s_.shapes.diagonal;
    return {parts.size(),
            !touches(parts, own),
            stepped(way + detour),
            stepped(-glm::dot(away, along)),
            s_.shapes.paths[parts.front()],
            parts.front(),
            d};
  }

  /// Removes what nothing blocks.
  bool take_free() {
    std::optional<Rank> best;
    std::size_t node = kNone;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!there_[n] || n == base_) continue;
      if (best && nodes_[n].parts.size() > best->parts) continue;
      for (std::size_t d = 0; d < s_.directions(); ++d) {
        if (count_[d][n] > 0 || !s_.allowed(d)) continue;
        Rank one = rank(nodes_[n].parts, {n}, d, way_of(n, d));
        if (!best || one < *best) best = std::move(one), node = n;
      }
    }
    if (!best) return false;
    Removal removal{{}, best->direction};
    for (const std::size_t n : equals(node, best->direction)) {
      removal.nodes.push_back(nodes_[n]);
      remove(n);
    }
    level_.removals.push_back(std::move(removal));
    return true;
  }

  /// The nodes of one shape that can go the same way, and have no shorter one.
  std::vector<std::size_t> equals(std::size_t node, std::size_t direction) {
    const auto signature = [&](std::size_t n) {
      Signature sum;
      for (const std::size_t part : nodes_[n].parts) sum += s_.shapes.signatures[part];
      return sum;
    };
    const Signature one = signature(node);
    std::vector<std::size_t> same;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!there_[n] || n == base_ || count_[direction][n] > 0) continue;
      if (nodes_[n].parts.size() != nodes_[node].parts.size()) continue;
      if (n != node && (!signature(n).same(one) || best_direction(n) != direction)) continue;
      same.push_back(n);
    }
    return same;
  }

  std::size_t best_direction(std::size_t n) {
    std::optional<Rank> best;
    for (std::size_t d = 0; d < s_.directions(); ++d) {
      if (count_[d][n] > 0 || !s_.allowed(d)) continue;
      Rank one = rank(nodes_[n].parts, {n}, d, way_of(n, d));
      if (!best || one < *best) best = std::move(one);
    }
    return best ? best->direction : kNone;
  }

  /// Sets of nodes that block each other along a direction, and that no others block.
  std::vector<std::vector<std::size_t>> sinks(std::size_t d) const {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    Graph graph(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!there_[n]) continue;
      for (const std::size_t by : blockers_[d][n]) {
        if (there_[by]) boost::add_edge(n, by, graph);
      }
    }
    std::vector<std::size_t> component(nodes_.size());
    const std::size_t count = boost::strong_components(
        graph, boost::make_iterator_property_map(component.begin(),
                                                 boost::get(boost::vertex_index, graph)));
    std::vector<std::vector<std::size_t>> sets(count);
    std::vector<bool> held(count, false);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!there_[n]) continue;
      sets[component[n]].push_back(n);
      for (const std::size_t by : blockers_[d][n]) {
        if (there_[by] && component[by] != component[n]) held[component[n]] = true;
      }
    }
    std::vector<std::vector<std::size_t>> free;
    for (std::size_t c = 0; c < count; ++c) {
      if (!held[c] && !sets[c].empty()) free.push_back(std::move(sets[c]));
    }
    std::ranges::sort(free);
    return free;
  }

  std::vector<std::size_t> parts_of(const std::vector<std::size_t>& nodes) const {
    std::vector<std::size_t> parts;
    for (const std::size_t n : nodes) {
      parts.insert(parts.end(), nodes_[n].parts.begin(), nodes_[n].parts.end());
    }
    std::ranges::sort(parts);
    return parts;
  }

  /// Removes the least set of nodes that block each other.
  bool take_knot() {
    std::optional<Rank> best;
    std::vector<std::size_t> knot;
    for (std::size_t d = 0; d < s_.directions(); ++d) {
      if (!s_.allowed(d)) continue;
      for (const auto& nodes : sinks(d)) {
        if (std::ranges::find(nodes, base_) != nodes.end()) continue;
        const std::vector<std::size_t> parts = parts_of(nodes);
        Rank one = rank(parts, nodes, d, way_out(parts, d, nodes).first);
        if (!best || one < *best) best = std::move(one), knot = nodes;
      }
    }
    if (!best) return false;
    Node whole{parts_of(knot), 0};
    for (const std::size_t n : knot) whole.members.push_back(nodes_[n]);
    for (const std::size_t n : knot) remove(n);
    level_.removals.push_back({{std::move(whole)}, best->direction});
    return true;
  }

  /// The least set with the base that nothing else blocks.
  std::vector<std::size_t> base_knot() const {
    std::vector<std::size_t> least;
    for (std::size_t d = 0; d < s_.directions(); ++d) {
      if (!s_.allowed(d)) continue;
      for (auto& nodes : sinks(d)) {
        if (least.empty() || parts_of(nodes).size() < parts_of(least).size()) least = nodes;
      }
    }
    return least;
  }

  /// Puts nodes in the place of those of a set.
  void replace(const std::vector<std::size_t>& set,
               const std::function<void(const Node&, std::vector<Node>&)>& by) {
    std::vector<Node> next;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!there_[n]) continue;
      if (std::ranges::find(set, n) == set.end()) {
        next.push_back(std::move(nodes_[n]));
      } else {
        by(nodes_[n], next);
      }
    }
    nodes_ = std::move(next);
    rebuild();
  }

  /// Sub-assemblies that do not leave as wholes are looked at part by part.
  bool open_assemblies() {
    const std::vector<std::size_t> knot = base_knot();
    const bool opens = std::ranges::any_of(
        knot, [&](std::size_t n) { return inside(nodes_[n], s_.shapes).size() > 1; });
    if (!opens) return false;
    replace(knot, [&](const Node& node, std::vector<Node>& next) {
      for (Node& one : inside(node, s_.shapes)) next.push_back(std::move(one));
    });
    return true;
  }

  /// What is left of a set that nothing sets free moves as one from here on.
  void lock() {
    std::vector<std::size_t> knot = base_knot();
    if (knot.size() < 2) {  // one way only, and all others lie behind the base
      knot.clear();
      for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (there_[n]) knot.push_back(n);
      }
    }
    Node whole{parts_of(knot), 0, {}, true};
    std::vector<std::size_t> parts = whole.parts;
    // One that holds a set that was named before takes its place.
    std::erase_if(level_.interlocked,
                  [&](const auto& set) { return std::ranges::includes(parts, set); });
    level_.interlocked.push_back(std::move(parts));
    bool placed = false;
    replace(knot, [&](const Node&, std::vector<Node>& next) {
      if (!placed) next.push_back(whole);
      placed = true;
    });
  }

  struct Way {
    double by = 0;
    std::size_t last = kNone;
    bool known = false;
  };

  const Situation& s_;
  std::vector<Node> nodes_;
  std::vector<bool> there_;
  std::size_t alive_ = 0, base_ = 0, base_part_ = kNone;
  std::vector<std::size_t> of_part_;
  /// A direction and a node: who blocks it, whom it blocks, how many of the former are there.
  std::vector<std::vector<std::vector<std::size_t>>> blockers_, blocked_;
  std::vector<std::vector<std::size_t>> count_;
  std::vector<Way> ways_;
  Level level_;
};

}  // namespace

bool overlap_across(const Box3& a, const Box3& b, double eps) {
  for (int k = 0; k < 2; ++k) {
    if (std::min(a.max[k], b.max[k]) - std::max(a.min[k], b.min[k]) <= eps) return false;
  }
  return true;
}

std::vector<Node> inside(const Node& node, const Shapes& shapes) {
  if (!node.members.empty()) return node.members;
  const auto of_first = [&](std::size_t part) {
    return shapes.things[part] == shapes.things[node.parts.front()];
  };
  if (node.locked || std::ranges::all_of(node.parts, of_first)) return {node};
  std::vector<Node> nodes;
  std::map<std::string, std::size_t> known;
  for (const std::size_t part : node.parts) {
    const auto& names = shapes.names[part];
    if (names.size() <= node.depth) {
      nodes.push_back({{part}, node.depth});
      continue;
    }
    const auto [at, fresh] = known.emplace(names[node.depth], nodes.size());
    if (fresh) nodes.push_back({{}, node.depth + 1});
    nodes[at->second].parts.push_back(part);
  }
  return nodes.size() == 1 ? inside(nodes.front(), shapes) : nodes;
}

Level take_apart(std::vector<Node> nodes, const Situation& situation) {
  return Taking(std::move(nodes), situation).run();
}

}  // namespace burin::detail
