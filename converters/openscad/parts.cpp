#include "parts.h"

#include <burin/base/error.h>

#include "part_names.h"
#include "source_names.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace burin::detail {
namespace {

using csg::Module;

/// What color() says; OpenSCAD's -1 is a colour that nobody gave.
struct Paint {
  std::string color;
  double opacity = 1;
};

/// What a node inherits from those above it.
struct State {
  /// Where the part's frame stands, and the node in it.
  csg::Matrix frame = {}, at = {};
  Paint paint = {};
  /// Of part() and of calls; empty: that of the object at the top.
  std::string name = {};
  /// The node of the object, call or part() that this is some of.
  std::uint32_t of = 0;
  /// Numbers of calls of burin.scad that hold for what is below, outermost first.
  std::vector<std::size_t> calls = {};
  /// Likewise of thread(), which makes no part of its own.
  std::vector<std::size_t> threads = {};
  bool background = false, highlight = false;
  /// Whether `of` is one thing, whatever it looks like.
  bool of_one = false;
};

Paint paint_of(const csg::Node& node) {
  if (node.arguments.empty() || node.arguments[0].value.list.size() < 3) return {};
  const std::vector<csg::Value>& list = node.arguments[0].value.list;
  Paint out;
  if (list.size() > 3 && list[3].number >= 0) out.opacity = std::min(list[3].number, 1.0);
  const auto given = [](const csg::Value& v) { return v.number >= 0; };
  if (!std::all_of(list.begin(), list.begin() + 3, given)) return out;
  const auto byte = [&](std::size_t i) {
    return static_cast<int>(std::lround(255 * std::min(list[i].number, 1.0)));
  };
  out.color = fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2));
  return out;
}

/// A name that selectors take as one.
std::string plain(const std::string& name) {
  std::string out = clean_name(name);
  std::ranges::replace(out, '/', '-');
  return out;
}

class Divider {
 public:
  Divider(const csg::Tree& tree, const CallParts& calls, std::string stem, Diagnostics& diagnostics)
      : tree_(tree), calls_(calls), stem_(std::move(stem)), diagnostics_(diagnostics) {
    find_alike();
  }

  TreeParts run(std::string_view program) {
    const std::vector<std::uint32_t> top = objects_at_top(tree_);
    std::vector<std::string> names = source_names(program, top.size());
    // Statements and objects cannot be told to belong together: calls say what they are.
    const bool unknown = std::ranges::all_of(names, &std::string::empty);
    for (std::size_t i = 0; i < top.size(); ++i) {
      if (unknown || words_.contains(names[i])) {
        names[i] = called(top[i]);
      } else if (const auto c = first_call(top[i]); c && call_at(*c)->name == names[i]) {
        names[i] = maker(*c);
      }
    }
    // A program of one call is what that holds, whatever `%` shows around it.
    const auto counts = [&](std::uint32_t n) {
      return holds_[n] != 0 && !tree_.nodes[n].background;
    };
    const bool several = std::ranges::count_if(top, counts) > 1;
    for (std::size_t i = 0; i < top.size(); ++i) {
      object_ = plain(names[i].empty() ? stem_ : names[i]);
      groups_.clear();
      visit(top[i], several && is_call(top[i]));
    }
    if (nameless_ > 0) {
      diagnostics_.add(Severity::Warning, "openscad.mark", nameless_,
                       "part() takes a name, as in part(\"lid\") lid();");
    }
    name_parts(out_);
    return std::move(out_);
  }

 private:
  const ModuleCall* call_at(std::uint32_t node) const {
    return calls_.known ? calls_.known->at(node) : nullptr;
  }

  /// The one child of an open module that holds anything.
  std::optional<std::uint32_t> only_child(std::uint32_t node) const {
    std::optional<std::uint32_t> only;
    bool one = is_open(tree_.nodes[node].module);
    csg::for_each_child(tree_, node, [&](std::uint32_t c) {
      if (holds_[c] == 0) return;
      one = one && !only;
      only = c;
    });
    return one ? only : std::nullopt;
  }

  /// Whether all of an object is a call.
  bool is_call(std::uint32_t node) const {
    for (std::optional<std::uint32_t> n = node; n; n = only_child(*n)) {
      if (call_at(*n)) return true;
    }
    return false;
  }

  /// The module whose call all of an object is: a word of burin.scad says something of what it
  /// holds, and calls it nothing. Empty where there is none.
  std::string called(std::uint32_t node) const {
    const auto call = first_call(node);
    return call ? maker(*call) : std::string();
  }
  std::optional<std::uint32_t> first_call(std::uint32_t node) const {
    for (std::optional<std::uint32_t> n = node; n; n = only_child(*n)) {
      const ModuleCall* call = call_at(*n);
      if (call && !words_.contains(call->name)) return n;
    }
    return std::nullopt;
  }

  /// The module of a chain that makes its solids: the innermost one, but for what stands on or in
  /// what one before it makes (`base() knob();` where base() has a solid of its own,
  /// `box(3) outline();` that extrudes).
  std::string maker(std::uint32_t node) const {
    const ModuleCall& chain = *call_at(node);
    std::string name = chain.module;
    while (name != chain.name) {
      const auto inner = next_in_chain(node, chain);
      if (!inner) break;
      node = *inner;
      name = call_at(node)->module;
    }
    return words_.contains(name) ? chain.name : name;
  }

  /// The first call of a chain below one of it, where all that this makes is of such calls. What a
  /// difference leaves is of its first operand.
  std::optional<std::uint32_t> next_in_chain(std::uint32_t node, const ModuleCall& chain) const {
    std::optional<std::uint32_t> first;
    std::vector<std::uint32_t> open{node};
    while (!open.empty()) {
      const std::uint32_t n = open.back();
      open.pop_back();
      const ModuleCall* call = n == node ? nullptr : call_at(n);
      if (call && call->name == chain.name && call->in_module == chain.in_module) {
        if (!first) first = n;
        continue;
      }
      const bool cut = tree_.nodes[n].module == Module::Difference;
      if (!cut && !is_open(tree_.nodes[n].module)) return std::nullopt;
      bool taken = false;
      csg::for_each_child(tree_, n, [&](std::uint32_t c) {
        if (holds_[c] == 0 || (cut && taken)) return;
        open.push_back(c);
        taken = true;
      });
    }
    return first;
  }

  /// The name of a call that is a part.
  std::string name_of_call(std::uint32_t node) const {
    const std::string name = called(node);
    return name.empty() ? object_ : name;
  }

  /// Walks the open modules below an object; no recursion, as trees may be deep.
  void visit(std::uint32_t top, bool of_one) {
    std::vector<std::pair<std::uint32_t, State>> open{{top, State{.of = top, .of_one = of_one}}};
    while (!open.empty()) {
      auto [node, state] = std::move(open.back());
      open.pop_back();
      if (calls_.repeated.contains(node)) continue;
      const csg::Node& n = tree_.nodes[node];
      state.background = state.background || n.background;
      state.highlight = state.highlight || n.highlight;
      if (calls_.nodes.contains(node)) begin(node, name_of_call(node), state);
      std::vector<std::uint32_t> children;
      if (is_open(n.module)) {
        csg::for_each_child(tree_, node, [&](std::uint32_t c) { children.push_back(c); });
        if (const auto mark = mark_of_group(tree_, node)) {
          take(*mark, node, state);
          children.erase(children.begin());
        }
        // The outermost colour holds.
        if (n.module == Module::Color && state.paint.color.empty()) state.paint = paint_of(n);
      }
      const auto& alike = state.paint.color.empty() ? plain_ : calm_;
      if (holds_[node] != 0 &&
          std::ranges::all_of(children, [&](std::uint32_t c) { return alike[c] != 0; })) {
        add_alike(node, state);
        continue;
      }
      if (n.module == Module::Multmatrix) state.at = state.at * csg::matrix_of(tree_, node);
      for (auto c = children.rbegin(); c != children.rend(); ++c) open.emplace_back(*c, state);
    }
  }

  /// An instance begins here: what is below stands in its frame, so that equal ones are found.
  static void begin(std::uint32_t node, const std::string& name, State& state) {
    if (!(state.at == csg::Matrix{})) state.frame = state.frame * state.at;
    state.at = {};
    state.of = node;
    state.of_one = true;
    state.name = plain(name);
  }

  /// A node below which nothing changes. Where it stands is parted from what it is, so that equal
  /// ones are found.
  void add_alike(std::uint32_t node, State state) {
    for (;;) {
      const csg::Node& n = tree_.nodes[node];
      const std::uint32_t only = node + 1;
      if (!is_open(n.module) || only >= n.end || tree_.nodes[only].end != n.end) break;
      if (n.module == Module::Multmatrix) state.at = state.at * csg::matrix_of(tree_, node);
      node = only;
    }
    add(node, state);
    show_within(node, state);
  }

  /// Which nodes have nothing below them, as far as modules are open, that parts would be told by:
  /// neither marks, modifiers and calls (calm), nor colours (plain); and which hold anything at
  /// all.
  void find_alike() {
    calm_.assign(tree_.nodes.size(), 1);
    plain_ = holds_ = calm_;
    for (auto n = static_cast<std::uint32_t>(tree_.nodes.size()); n-- > 0;) {
      const csg::Node& node = tree_.nodes[n];
      const std::optional<Mark> mark = mark_at(tree_, n);
      if (mark) words_.insert(mark->what);
      bool calm = !node.background && !node.highlight && !mark && !calls_.nodes.contains(n) &&
                  !calls_.repeated.contains(n);
      bool plain = calm && node.module != Module::Color;
      bool holds = !is_open(node.module) && !mark;
      if (is_open(node.module)) {
        csg::for_each_child(tree_, n, [&](std::uint32_t c) {
          calm = calm && calm_[c] != 0;
          plain = plain && plain_[c] != 0;
          holds = holds || holds_[c] != 0;
        });
      }
      calm_[n] = calm ? 1 : 0;
      plain_[n] = plain ? 1 : 0;
      holds_[n] = holds ? 1 : 0;
    }
  }

  void take(const Mark& mark, std::uint32_t node, State& state) {
    const auto text = [&](std::size_t i) {
      return i < mark.arguments.size() && mark.arguments[i].is_string()
                 ? mark.arguments[i].get<std::string>()
                 : std::string();
    };
    if (mark.what == "part") {
      if (text(0).empty()) ++nameless_;
      return begin(node, text(0), state);
    }
    if (mark.what == "view") {
      out_.views.push_back(mark);
      return;
    }
    // A thread is on what it holds, which stays a piece of its part.
    (mark.what == "thread" ? state.threads : state.calls).push_back(out_.calls.size());
    out_.calls.push_back({mark, state.frame * state.at, {}});
  }

  /// A piece of the object; what differs in nothing is one part.
  void add(std::uint32_t node, const State& s) {
    const auto key = std::tuple(s.background, s.highlight, s.of, s.name, s.paint.color,
                                s.paint.opacity, s.calls);
    const auto [entry, fresh] = groups_.try_emplace(key, out_.parts.size());
    if (fresh) {
      const Paint paint = s.paint.color.empty() ? paint_of_first(node, s.paint) : s.paint;
      out_.parts.push_back({.name = s.name.empty() ? object_ : s.name,
                            .assembly = {},
                            .definition = definition_of(s),
                            .color = paint.color,
                            .opacity = paint.opacity,
                            .background = s.background,
                            .highlight = s.highlight,
                            .of_one = s.of_one && !s.background,
                            .of = s.of,
                            .frame = s.frame,
                            .pieces = {}});
      for (const std::size_t c : s.calls) out_.calls[c].parts.push_back(out_.parts.size() - 1);
    }
    out_.parts[entry->second].pieces.push_back({node, s.at});
    for (const std::size_t c : s.threads) {
      std::vector<std::size_t>& parts = out_.calls[c].parts;
      if (std::ranges::find(parts, entry->second) == parts.end()) parts.push_back(entry->second);
    }
  }

  /// A bolt that is highlighted is a bolt; one that only stands there as what is around is none.
  std::string definition_of(const State& s) const {
    if (s.background) return {};
    return s.highlight && s.name.empty() ? object_ : s.name;
  }

  /// What a difference leaves has the colour of what it was taken from.
  Paint paint_of_first(std::uint32_t node, const Paint& above) const {
    for (; node < tree_.nodes.size(); ++node) {
      const csg::Node& n = tree_.nodes[node];
      if (n.module == Module::Color) return paint_of(n);
      if (node + 1 >= n.end) break;
    }
    return above;
  }

  /// `%` and `#` below what makes one thing of its children.
  void show_within(std::uint32_t top, const State& state) {
    struct Above {
      std::uint32_t end;
      csg::Matrix at;
    };
    std::vector<Above> above{
        {tree_.nodes[top].end, state.frame * (state.at * csg::matrix_of(tree_, top))}};
    for (std::uint32_t n = top + 1; n < tree_.nodes[top].end;) {
      while (n >= above.back().end) above.pop_back();
      const csg::Node& node = tree_.nodes[n];
      if (node.background || node.highlight) {
        State shown{.at = above.back().at, .of = state.of};
        shown.background = true;
        shown.highlight = node.highlight;
        add(n, shown);
        n = node.end;
        continue;
      }
      if (node.module == Module::Multmatrix) {
        above.push_back({node.end, above.back().at * csg::matrix_of(tree_, n)});
      }
      ++n;
    }
  }

  const csg::Tree& tree_;
  const CallParts& calls_;
  std::string stem_, object_;
  std::int64_t nameless_ = 0;  // calls of part()
  Diagnostics& diagnostics_;
  std::vector<std::uint8_t> calm_, plain_, holds_;
  /// Modules of burin.scad that the program calls.
  std::set<std::string> words_;
  TreeParts out_;
  std::map<std::tuple<bool, bool, std::uint32_t, std::string, std::string, double,
                      std::vector<std::size_t>>,
           std::size_t>
      groups_;
};

}  // namespace

void report_undefined_places(const csg::Tree& tree, Diagnostics& diagnostics) {
  std::int64_t count = 0;
  const auto finite = [](const csg::Value& row) {
    return std::ranges::all_of(row.list,
                               [](const csg::Value& v) { return std::isfinite(v.number); });
  };
  for (const csg::Node& n : tree.nodes) {
    if (n.module != Module::Multmatrix || n.arguments.empty()) continue;
    count += std::ranges::all_of(n.arguments[0].value.list, finite) ? 0 : 1;
  }
  if (count == 0) return;
  diagnostics.add(Severity::Warning, "openscad.undefined_place", count,
                  "what a transformation by numbers that are not finite (such as 1/0) places is "
                  "left out");
}

bool is_open(Module m) {
  return m == Module::Group || m == Module::Union || m == Module::Multmatrix ||
         m == Module::Color || m == Module::Render;
}

std::vector<std::uint32_t> objects_at_top(const csg::Tree& tree) {
  for (std::uint32_t n = 1; n < tree.nodes.size(); ++n) {
    if (tree.nodes[n].root) return {n};
  }
  std::vector<std::uint32_t> out;
  csg::for_each_child(tree, 0, [&](std::uint32_t c) { out.push_back(c); });
  return out;
}

bool has_unknown_facets(const csg::Tree& tree, const TreePart& part) {
  const auto unknown = [&](std::uint32_t n) {
    const Module m = tree.nodes[n].module;
    if (m == Module::Polyhedron) return !mark_at(tree, n);
    return m == Module::Polygon || m == Module::Text || m == Module::Import ||
           m == Module::Minkowski;
  };
  return std::ranges::any_of(part.pieces, [&](const TreePart::Piece& piece) {
    for (std::uint32_t n = piece.node; n < tree.nodes[piece.node].end; ++n) {
      if (unknown(n)) return true;
    }
    return false;
  });
}

bool is_flat(const csg::Tree& tree) {
  // The first module that has a dimension of its own says it for all that hold it.
  for (std::uint32_t n = 1; n < tree.nodes.size(); ++n) {
    if (csg::makes_flat(tree.nodes[n].module)) return true;
    if (csg::makes_solid(tree.nodes[n].module) && !mark_at(tree, n)) return false;
  }
  return false;
}

TreeParts parts_of(const csg::Tree& tree, std::string_view program, const std::string& stem,
                   Diagnostics& diagnostics, const CallParts& calls) {
  return Divider(tree, calls, stem, diagnostics).run(program);
}

}  // namespace burin::detail
