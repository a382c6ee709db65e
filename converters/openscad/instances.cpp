#include "instances.h"

#include "child.h"
#include "repeated_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

// Sums of volumes that are the same: doubles of some thousands of triangles.
constexpr double kRounding = 1e-9;

/// Something that may be several: an object at the top or a call.
struct Unit {
  std::uint32_t node = 0;
  /// The modules that it is called by and within.
  std::vector<std::string> modules;
  /// Calls that all of its solids belong to.
  std::vector<std::uint32_t> pieces = {};
  /// Whether these are one body where they touch.
  bool touching_is_one = false;
};

class InstanceFinder {
 public:
  InstanceFinder(const csg::Tree& tree, const TreeCalls& calls,
                 const std::set<std::uint32_t>& repeated)
      : tree_(tree), calls_(calls), repeated_(repeated) {
    holds_.assign(tree.nodes.size(), 0);
    for (auto n = static_cast<std::uint32_t>(tree.nodes.size()); n-- > 0;) {
      bool holds = !is_open(tree.nodes[n].module) && !mark_at(tree, n);
      csg::for_each_child(tree, n, [&](std::uint32_t c) { holds = holds || holds_[c] != 0; });
      holds_[n] = holds ? 1 : 0;
    }
  }

  /// Fills in what a unit consists of; nothing where it is one thing.
  void divide(Unit& unit) const {
    for (std::uint32_t node = unit.node;;) {
      if (const ModuleCall* call = calls_.at(node)) unit.modules.push_back(call->module);
      unit.pieces = below(node);
      if (std::ranges::any_of(unit.pieces, [&](std::uint32_t p) { return again(p, unit); })) {
        unit.pieces.clear();
      }
      if (unit.pieces.size() != 1) break;
      node = unit.pieces.front();  // a module of one call
    }
    unit.touching_is_one =
        std::ranges::any_of(unit.pieces, [&](std::uint32_t p) { return calls_.at(p)->in_module; });
  }

 private:
  /// Whether a module calls itself.
  bool again(std::uint32_t piece, const Unit& unit) const {
    const ModuleCall& call = *calls_.at(piece);
    return call.in_module && std::ranges::find(unit.modules, call.module) != unit.modules.end();
  }

  /// The calls next below a node; none where something is no call's. What part() says is a part
  /// already; what callout() gives a number to stays one thing.
  std::vector<std::uint32_t> below(std::uint32_t top) const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t n = top + 1; n < tree_.nodes[top].end;) {
      const csg::Module m = tree_.nodes[n].module;
      const auto mark = m == csg::Module::Group ? mark_of_group(tree_, n) : std::nullopt;
      if (mark && mark->what == "callout") return {};
      if (holds_[n] == 0 || repeated_.contains(n) || (mark && mark->what == "part")) {
        n = tree_.nodes[n].end;
      } else if (calls_.at(n)) {
        out.push_back(n);
        n = tree_.nodes[n].end;
      } else if (m == csg::Module::Group || m == csg::Module::Multmatrix ||
                 m == csg::Module::Color) {
        ++n;
      } else {
        return {};
      }
    }
    return out;
  }

  const csg::Tree& tree_;
  const TreeCalls& calls_;
  const std::set<std::uint32_t>& repeated_;
  std::vector<char> holds_;
};

class Divisions {
 public:
  Divisions(const csg::Tree& tree, const TreeCalls& calls, std::string_view program,
            const std::string& stem, SolidStore& store, Diagnostics& diagnostics)
      : tree_(tree),
        program_(program),
        stem_(stem),
        store_(store),
        diagnostics_(diagnostics),
        finder_(tree, calls, accepted_.repeated) {
    accepted_.known = &calls;
    accepted_.repeated = repeated_calls(tree, calls);
    report_repeated();
  }

  CallParts run() {
    std::vector<Unit> units;
    for (const std::uint32_t object : objects_at_top(tree_)) {
      units.push_back({.node = object, .modules = {}});
    }
    if (!choose(units)) return std::move(accepted_);
    std::set<std::uint32_t> nodes;
    for (const Unit& u : units) nodes.insert(u.node);
    std::map<std::uint32_t, Bulk> whole = bulks(accepted_, nodes, diagnostics_);
    do {
      CallParts asked = accepted_;
      nodes.clear();
      for (const Unit& u : units) nodes.insert(u.pieces.begin(), u.pieces.end());
      asked.nodes.insert(nodes.begin(), nodes.end());
      Diagnostics said_before;  // of the same solids
      std::map<std::uint32_t, Bulk> parted;
      try {
        parted = bulks(asked, nodes, said_before);
      } catch (const csg::NotEvaluated&) {
        break;  // what could be evaluated stays as it was
      }
      std::vector<Unit> next;
      for (const Unit& u : units) {
        if (same(u, whole[u.node], parted)) {
          accept(u, next);
        } else {
          report(Severity::Info, u, "openscad.one_body", "they touch or run into each other");
        }
      }
      units = std::move(next);
      whole = std::move(parted);
    } while (choose(units));
    return std::move(accepted_);
  }

 private:
  void report_repeated() {
    std::map<std::string, int> of_name;
    for (const std::uint32_t n : accepted_.repeated) ++of_name[accepted_.known->at(n)->name];
    for (const auto& [name, count] : of_name) {
      diagnostics_.add(Severity::Warning, "openscad.repeated_call", count,
                       fmt::format("{} of {} left out: an equal one is in the same place already; "
                                   "a loop that goes round, such as [0:60:360], ends where it "
                                   "began",
                                   count == 1 ? "a call" : fmt::format("{} calls", count), name));
    }
  }

  /// Of the parts of each of these objects and calls.
  std::map<std::uint32_t, Bulk> bulks(const CallParts& calls, const std::set<std::uint32_t>& of,
                                      Diagnostics& diagnostics) {
    Diagnostics said_later;
    const TreeParts all = parts_of(tree_, program_, stem_, said_later, calls);
    const std::vector<StoredPart> stored = store_.store(all.parts, diagnostics);
    std::map<std::uint32_t, Bulk> out;
    for (std::size_t i = 0; i < stored.size(); ++i) {
      if (!of.contains(all.parts[i].of)) continue;
      const Bulk b = store_.bulk(stored[i]);
      Bulk& sum = out[all.parts[i].of];
      sum.volume += b.volume;
      sum.shells += b.shells;
    }
    return out;
  }

  /// Those of the units that may be several; false where there are none.
  bool choose(std::vector<Unit>& units) {
    std::vector<Unit> out;
    std::size_t count = accepted_.nodes.size();
    for (Unit& u : units) {
      finder_.divide(u);
      if (u.pieces.empty()) continue;
      count += u.pieces.size();
      if (count > kMostInstances) {
        count -= u.pieces.size();
        report(Severity::Warning, u, "openscad.many_instances",
               fmt::format("more than {} parts come of loops and modules", kMostInstances));
        continue;
      }
      out.push_back(std::move(u));
    }
    units = std::move(out);
    return !units.empty();
  }

  void report(Severity severity, const Unit& u, const char* code, const std::string& why) {
    std::vector<std::string> names;
    for (const std::uint32_t p : u.pieces) names.push_back(accepted_.known->at(p)->name);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    diagnostics_.add(severity, code, 1,
                     fmt::format("{} calls of {} stay one part: {}; mark parts with part()",
                                 u.pieces.size(), fmt::join(names, ", "), why));
  }

  static bool same(const Unit& u, const Bulk& whole, const std::map<std::uint32_t, Bulk>& parted) {
    Bulk sum;
    for (const std::uint32_t p : u.pieces) {
      const auto at = parted.find(p);
      if (at == parted.end()) continue;
      sum.volume += at->second.volume;
      sum.shells += at->second.shells;
    }
    return whole.volume > 0 && std::abs(sum.volume - whole.volume) <= kRounding * whole.volume &&
           (!u.touching_is_one || sum.shells == whole.shells);
  }

  void accept(const Unit& u, std::vector<Unit>& next) {
    accepted_.nodes.erase(u.node);
    accepted_.nodes.insert(u.pieces.begin(), u.pieces.end());
    for (const std::uint32_t p : u.pieces) next.push_back({.node = p, .modules = u.modules});
  }

  const csg::Tree& tree_;
  std::string_view program_;
  const std::string& stem_;
  SolidStore& store_;
  Diagnostics& diagnostics_;
  CallParts accepted_;
  InstanceFinder finder_;
};

}  // namespace

CallParts instances_of(const csg::Tree& tree, const TreeCalls& calls, std::string_view program,
                       const std::string& stem, SolidStore& store, Diagnostics& diagnostics) {
  return Divisions(tree, calls, program, stem, store, diagnostics).run();
}

}  // namespace burin::detail
