#include <burin/assembly/items.h>
#include <burin/assembly/things.h>
#include <burin/book/build_steps.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace burin {
namespace {

using Parts = std::vector<std::size_t>;

bool within(const Parts& inner, const Parts& outer) { return std::ranges::includes(outer, inner); }
Parts common(const Parts& a, const Parts& b) {
  Parts out;
  std::ranges::set_intersection(a, b, std::back_inserter(out));
  return out;
}
Parts without(const Parts& a, const Parts& b) {
  Parts out;
  std::ranges::set_difference(a, b, std::back_inserter(out));
  return out;
}

/// Names from the top of the assembly down, and the part.
std::vector<std::string> names_of(const Part& part) {
  std::vector<std::string> names = part.assembly;
  names.push_back(part.name);
  return names;
}

/// Parts of one thing are called by their looks: the assembly has its name.
const std::string& called(const Scene& scene, std::size_t part) {
  const Part& one = scene.parts[part];
  return (one.joined || end_of_thing(scene, part) > part + 1) && !one.assembly.empty()
             ? one.assembly.back()
             : one.name;
}

/// The names that all parts have from the top on.
std::size_t common_depth(const Scene& scene, const Parts& parts) {
  const std::vector<std::string> first = names_of(scene.parts[parts.front()]);
  std::size_t depth = first.size() - 1;
  for (const std::size_t part : parts) {
    const std::vector<std::string>& names = scene.parts[part].assembly;
    std::size_t same = 0;
    while (same < std::min(depth, names.size()) && names[same] == first[same]) ++same;
    depth = same;
  }
  return depth;
}

/// Drawn parts of the assembly that a part has above it, with so many names.
std::size_t count_below(const Scene& scene, const std::vector<bool>& drawn, std::size_t part,
                        std::size_t depth) {
  const auto above = std::span(scene.parts[part].assembly).first(depth);
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const std::vector<std::string>& other = scene.parts[i].assembly;
    count += drawn[i] && other.size() >= depth &&
             std::ranges::equal(above, std::span(other).first(depth));
  }
  return count;
}

/// A set of parts that comes apart: the whole, or what a step moved.
struct Group {
  Parts parts;
  /// How many names of assemblies are above what is in it.
  std::size_t depth = 0;
  /// Steps that take it apart, in order, each what it moved of what was still there.
  std::vector<ExplodeStep> steps;
};

/// Which steps take which group apart.
class Groups {
 public:
  Groups(const Scene& scene, const std::vector<bool>& drawn, Parts all,
         const std::vector<ExplodeStep>& steps)
      : scene_(scene), drawn_(drawn) {
    add(std::move(all));
    std::vector<Parts> left{groups_.front().parts};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Parts moved = common(steps[i].parts, groups_.front().parts);
      if (moved.empty()) continue;
      const std::size_t group = smallest_above(moved);
      ExplodeStep step = steps[i];
      step.parts = common(moved, left[group]);
      if (step.parts.empty()) continue;  // it follows what has left
      left[group] = without(left[group], step.parts);
      for (Parts& unit : things_of(step.parts, groups_[group].depth, steps, i)) {
        left.push_back(unit);
        add(std::move(unit));
      }
      groups_[group].steps.push_back(std::move(step));
    }
  }

  const Group& whole() const { return groups_.front(); }
  /// Null where these parts do not come apart.
  const Group* of(const Parts& parts) const {
    const auto found = std::find_if(groups_.begin() + 1, groups_.end(), [&](const Group& g) {
      return g.parts == parts && !g.steps.empty();
    });
    return found == groups_.end() ? nullptr : &*found;
  }
  /// What a step of a group adds, one by one.
  std::vector<Parts> things_in(const Parts& moved, std::size_t depth) const {
    if (of(moved)) return {moved};
    return units_of(scene_, drawn_, moved, depth);
  }

 private:
  void add(Parts parts) {
    const std::size_t depth = common_depth(scene_, parts);
    groups_.push_back({std::move(parts), depth, {}});
  }

  std::size_t smallest_above(const Parts& parts) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < groups_.size(); ++i) {
      const Parts& outer = groups_[i].parts;
      if (outer.size() > parts.size() && outer.size() < groups_[best].parts.size() &&
          within(parts, outer)) {
        best = i;
      }
    }
    return best;
  }

  /// Sub-assemblies and parts; all as one where a later step takes apart what is in several of
  /// them, as parts that hold each other leave together.
  std::vector<Parts> things_of(const Parts& moved, std::size_t depth,
                               const std::vector<ExplodeStep>& steps, std::size_t at) const {
    std::vector<Parts> units = units_of(scene_, drawn_, moved, depth);
    for (std::size_t i = at + 1; i < steps.size(); ++i) {
      const Parts& later = steps[i].parts;
      const bool inside = steps[i].trail && later.size() < moved.size() && within(later, moved);
      const auto apart = [&](const Parts& u) {
        return common(later, u).empty() || within(u, later);
      };
      if (inside && std::ranges::all_of(units, apart)) return {moved};
    }
    return units;
  }

  const Scene& scene_;
  const std::vector<bool>& drawn_;
  std::vector<Group> groups_;
};

class Builder {
 public:
  Builder(const Scene& scene, const std::vector<bool>& drawn, const Groups& groups,
          const std::vector<int>& item_of, const BuildOptions& options)
      : scene_(scene), drawn_(drawn), groups_(groups), item_of_(item_of), options_(options) {}

  std::vector<BuildStep> run() {
    build(groups_.whole(), "", 1);
    return std::move(out_);
  }

 private:
  /// What two things have in common that are built alike.
  std::vector<int> items_of(const Parts& parts) const {
    std::vector<int> items;
    for (const std::size_t part : parts) items.push_back(item_of_[part]);
    std::ranges::sort(items);
    return items;
  }

  /// One step of the book before it is merged with others.
  struct Addition {
    std::vector<BuildMove> moves;
    std::set<std::vector<int>> kinds;
  };

  Addition addition_of(const ExplodeStep& step, std::size_t depth) const {
    Addition addition;
    for (Parts& thing : groups_.things_in(step.parts, depth)) {
      addition.kinds.insert(items_of(thing));
      addition.moves.push_back({std::move(thing), step.along});
    }
    return addition;
  }

  /// What a step adds, parted where it is too much.
  std::vector<Addition> parted(Addition whole) const {
    if (whole.kinds.size() <= options_.items) return {std::move(whole)};
    std::vector<Addition> pieces(1);
    for (BuildMove& move : whole.moves) {
      const std::vector<int> kind = items_of(move.parts);
      if (!pieces.back().kinds.contains(kind) && pieces.back().kinds.size() >= options_.items) {
        pieces.emplace_back();
      }
      pieces.back().kinds.insert(kind);
      pieces.back().moves.push_back(std::move(move));
    }
    return pieces;
  }

  void build(const Group& group, const std::string& name, std::size_t quantity) {
    std::vector<Addition> additions;
    Parts assembled = group.parts;
    for (const ExplodeStep& step : group.steps) assembled = without(assembled, step.parts);
    for (auto step = group.steps.rbegin(); step != group.steps.rend(); ++step) {
      for (Addition& one : parted(addition_of(*step, group.depth))) {
        if (!additions.empty() && additions.back().kinds == one.kinds) {
          std::move(one.moves.begin(), one.moves.end(), std::back_inserter(additions.back().moves));
        } else {
          additions.push_back(std::move(one));
        }
      }
    }
    build_inside(units_of(scene_, drawn_, assembled, group.depth));
    bool begins = true;
    if (additions.empty()) out_.push_back({{}, assembled, true, name, quantity});
    for (Addition& addition : additions) {
      std::vector<Parts> things;
      for (const BuildMove& move : addition.moves) things.push_back(move.parts);
      build_inside(things);
      BuildStep page{std::move(addition.moves), assembled, begins, name, quantity};
      assembled = page.parts();
      out_.push_back(std::move(page));
      begins = false;
    }
  }

  /// Sub-assemblies among things, each kind once.
  void build_inside(const std::vector<Parts>& things) {
    std::map<std::vector<int>, std::size_t> count;
    for (const Parts& thing : things) ++count[items_of(thing)];
    for (const Parts& thing : things) {
      const Group* inner = groups_.of(thing);
      if (!inner || !built_.insert(items_of(thing)).second) continue;
      build(*inner, name_together(scene_, drawn_, thing), count.at(items_of(thing)));
    }
  }

  const Scene& scene_;
  const std::vector<bool>& drawn_;
  const Groups& groups_;
  const std::vector<int>& item_of_;
  const BuildOptions& options_;
  std::set<std::vector<int>> built_;
  std::vector<BuildStep> out_;
};

}  // namespace

std::vector<std::size_t> BuildStep::parts() const {
  Parts all = assembled;
  for (const BuildMove& move : moves) all.insert(all.end(), move.parts.begin(), move.parts.end());
  std::ranges::sort(all);
  return all;
}

std::string name_together(const Scene& scene, const std::vector<bool>& drawn,
                          const std::vector<std::size_t>& parts) {
  const std::size_t depth = common_depth(scene, parts);
  if (depth > 0 && count_below(scene, drawn, parts.front(), depth) == parts.size()) {
    return scene.parts[parts.front()].assembly[depth - 1];
  }
  std::vector<std::string> names;
  for (const std::size_t part : parts) {
    const std::string name = instance_stem(called(scene, part));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  constexpr std::size_t kMost = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (i > 0 ? " + " : "") + names[i];
  }
  return names.size() > kMost ? text + " ..." : text;
}

std::vector<std::vector<std::size_t>> units_of(const Scene& scene, const std::vector<bool>& drawn,
                                               const std::vector<std::size_t>& parts,
                                               std::size_t depth) {
  std::vector<Parts> groups;
  std::map<std::string, std::size_t> known;
  for (const std::size_t part : parts) {
    const std::vector<std::string>& above = scene.parts[part].assembly;
    if (above.size() <= depth) {
      groups.push_back({part});
      continue;
    }
    const auto [entry, is_new] = known.try_emplace(above[depth], groups.size());
    if (is_new) groups.emplace_back();
    groups[entry->second].push_back(part);
  }
  std::vector<Parts> units;
  for (Parts& group : groups) {
    const bool single = scene.parts[group.front()].assembly.size() <= depth;
    if (single || count_below(scene, drawn, group.front(), depth + 1) == group.size()) {
      units.push_back(std::move(group));
      continue;
    }
    for (Parts& unit : units_of(scene, drawn, group, depth + 1)) units.push_back(std::move(unit));
  }
  return units;
}

std::vector<BuildStep> build_steps(const Scene& scene, const std::vector<bool>& drawn,
                                   const std::vector<ExplodeStep>& steps,
                                   const std::vector<int>& item_of, const BuildOptions& options) {
  Parts all;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (drawn[i]) all.push_back(i);
  }
  if (all.empty()) return {};
  const Groups groups(scene, drawn, std::move(all), steps);
  return Builder(scene, drawn, groups, item_of, options).run();
}

}  // namespace burin
