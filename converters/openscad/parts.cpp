#include "parts.h"

#include <burin/base/error.h>

#include "marks.h"
#include "source_names.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace burin::detail {
namespace {

using Json = nlohmann::ordered_json;
using csg::Module;

/// What a node inherits from those above it.
struct State {
  csg::Matrix at;
  std::string color;
  /// Of part(); empty: that of the object at the top.
  std::string name;
  /// Numbers of calls of burin.scad that hold for what is below, outermost first.
  std::vector<std::size_t> calls;
  bool background = false, highlight = false;
};

/// A call that is about the parts below it.
struct Call {
  Mark mark;
  csg::Matrix at;
  /// Names of the parts.
  std::vector<std::string> parts;
};

std::string color_of(const csg::Node& node) {
  if (node.arguments.empty() || node.arguments[0].value.list.size() < 3) return {};
  std::string text = "#";
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = node.arguments[0].value.list[i].number;
    if (!(v >= 0)) return {};  // -1: unset
    text += fmt::format("{:02x}", static_cast<int>(std::lround(255 * std::min(v, 1.0))));
  }
  return text;
}

/// Modules that show their children as they are.
bool is_open(Module m) {
  return m == Module::Group || m == Module::Union || m == Module::Multmatrix ||
         m == Module::Color || m == Module::Render;
}

/// A name that selectors take as one.
std::string plain(const std::string& name) {
  std::string out = clean_name(name);
  std::ranges::replace(out, '/', '-');
  return out;
}

class Divider {
 public:
  Divider(const csg::Tree& tree, std::string stem, Diagnostics& diagnostics)
      : tree_(tree), stem_(std::move(stem)), diagnostics_(diagnostics) {
    find_alike();
  }

  TreeParts run(std::string_view program) {
    std::vector<std::uint32_t> top = objects_at_top();
    const std::vector<std::string> names = source_names(program, top.size());
    for (std::size_t i = 0; i < top.size(); ++i) {
      object_ = plain(names[i].empty() ? stem_ : names[i]);
      groups_.clear();
      visit(top[i]);
    }
    TreeParts out;
    name_parts();
    out.parts = std::move(parts_);
    out.settings = settings(out.parts);
    return out;
  }

 private:
  /// What is above a `!` does not move it: OpenSCAD shows it alone.
  std::vector<std::uint32_t> objects_at_top() const {
    for (std::uint32_t n = 1; n < tree_.nodes.size(); ++n) {
      if (tree_.nodes[n].root) return {n};
    }
    std::vector<std::uint32_t> out;
    csg::for_each_child(tree_, 0, [&](std::uint32_t c) { out.push_back(c); });
    return out;
  }

  /// Walks the open modules below an object; no recursion, as trees may be deep.
  void visit(std::uint32_t top) {
    std::vector<std::pair<std::uint32_t, State>> open{{top, State{}}};
    while (!open.empty()) {
      auto [node, state] = std::move(open.back());
      open.pop_back();
      const csg::Node& n = tree_.nodes[node];
      state.background = state.background || n.background;
      state.highlight = state.highlight || n.highlight;
      std::vector<std::uint32_t> children;
      if (is_open(n.module)) {
        csg::for_each_child(tree_, node, [&](std::uint32_t c) { children.push_back(c); });
        if (const auto mark = mark_of_group(tree_, node)) {
          take(*mark, state);
          children.erase(children.begin());
        }
        // The outermost colour holds.
        if (n.module == Module::Color && state.color.empty()) state.color = color_of(n);
      }
      const auto& alike = state.color.empty() ? plain_ : calm_;
      if (holds_[node] != 0 &&
          std::ranges::all_of(children, [&](std::uint32_t c) { return alike[c] != 0; })) {
        add_alike(node, state);
        continue;
      }
      if (n.module == Module::Multmatrix) state.at = state.at * csg::matrix_of(tree_, node);
      for (auto c = children.rbegin(); c != children.rend(); ++c) open.emplace_back(*c, state);
    }
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
  /// neither marks nor modifiers (calm), nor colours (plain); and which hold anything at all.
  void find_alike() {
    calm_.assign(tree_.nodes.size(), 1);
    plain_ = holds_ = calm_;
    for (auto n = static_cast<std::uint32_t>(tree_.nodes.size()); n-- > 0;) {
      const csg::Node& node = tree_.nodes[n];
      bool calm = !node.background && !node.highlight && !mark_at(tree_, n);
      bool plain = calm && node.module != Module::Color;
      bool holds = !is_open(node.module) && !mark_at(tree_, n);
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

  void take(const Mark& mark, State& state) {
    const auto text = [&](std::size_t i) {
      return i < mark.arguments.size() && mark.arguments[i].is_string()
                 ? mark.arguments[i].get<std::string>()
                 : std::string();
    };
    if (mark.what == "part") {
      if (text(0).empty()) tell("part() takes a name, as in part(\"lid\") lid();");
      state.name = plain(text(0));
      return;
    }
    if (mark.what == "view") {
      views_.push_back(mark);
      return;
    }
    state.calls.push_back(calls_.size());
    calls_.push_back({mark, state.at, {}});
  }

  void tell(const std::string& what) {
    diagnostics_.add(Severity::Warning, "openscad.mark", 1, what);
  }

  /// A piece of the object; what differs in nothing is one part.
  void add(std::uint32_t node, const State& s) {
    const auto key = std::tuple(s.background, s.highlight, s.name, s.color, s.calls);
    const auto [entry, fresh] = groups_.try_emplace(key, parts_.size());
    if (fresh) {
      parts_.push_back({s.name.empty() ? object_ : s.name,
                        s.color.empty() ? color_of_first(node) : s.color,
                        s.background,
                        s.highlight,
                        {}});
      calls_of_.push_back(s.calls);
    }
    parts_[entry->second].pieces.push_back({node, s.at});
  }

  /// What a difference leaves has the colour of what it was taken from.
  std::string color_of_first(std::uint32_t node) const {
    for (; node < tree_.nodes.size(); ++node) {
      const csg::Node& n = tree_.nodes[node];
      if (n.module == Module::Color) return color_of(n);
      if (node + 1 >= n.end) break;
    }
    return {};
  }

  /// `%` and `#` below what makes one thing of its children.
  void show_within(std::uint32_t top, const State& state) {
    struct Above {
      std::uint32_t end;
      csg::Matrix at;
    };
    std::vector<Above> above{{tree_.nodes[top].end, state.at * csg::matrix_of(tree_, top)}};
    for (std::uint32_t n = top + 1; n < tree_.nodes[top].end;) {
      while (n >= above.back().end) above.pop_back();
      const csg::Node& node = tree_.nodes[n];
      if (node.background || node.highlight) {
        State shown{.at = above.back().at, .color = {}, .name = {}, .calls = {}};
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

  void name_parts() {
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      TreePart& part = parts_[i];
      if (part.highlight)
        part.name += " (highlighted)";
      else if (part.background)
        part.name += " (background)";
      const int n = ++seen[part.name];
      if (n > 1) part.name += fmt::format(" #{}", n);
      for (const std::size_t c : calls_of_[i]) calls_[c].parts.push_back(part.name);
    }
  }

  std::string settings(const std::vector<TreePart>& parts) {
    Json json;
    json["burin"] = "illustration";
    json["version"] = 1;
    for (const TreePart& part : parts) {
      if (part.background || part.highlight) ghost(json, part);
    }
    for (const Call& call : calls_) {
      if (call.parts.empty()) continue;
      if (call.mark.what == "ink")
        ink(json, call);
      else if (call.mark.what == "explode")
        explode(json, call);
      else if (call.mark.what == "callout")
        callout(json, call);
      else
        tell(fmt::format("burin.scad says {}, which this Burin does not know",
                         in_quotes(call.mark.what)));
    }
    if (!views_.empty()) view(json, views_.back());
    return json.size() > 2 ? json.dump() : std::string();
  }

  static void ghost(Json& json, const TreePart& part) {
    Json look = {{"select", part.name}, {"hatched", false}};
    if (part.background) look["transparent"] = true;
    json["looks"].push_back(look);
  }

  void ink(Json& json, const Call& call) {
    const Json& style = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (!style.is_string()) return tell("ink() takes a style, as in ink(\"engraving\") lid();");
    for (const std::string& name : call.parts) {
      json["looks"].push_back({{"select", name}, {"style", style}});
    }
  }

  void explode(Json& json, const Call& call) {
    const Json& by = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    const bool numbers = by.is_array() && by.size() == 3 &&
                         std::ranges::all_of(by, [](const Json& v) { return v.is_number(); });
    std::array<double, 3> way{};
    for (std::size_t i = 0; numbers && i < 3; ++i) {
      // A direction: turned as the parts are, not moved.
      for (std::size_t k = 0; k < 3; ++k) way[i] += call.at.row[i][k] * by[k].get<double>();
    }
    const double length = std::hypot(way[0], way[1], way[2]);
    if (!(length > 0)) return tell("explode() takes a way in mm, as in explode([0, 0, 30]) lid();");
    json["explode"]["steps"].push_back(
        {{"move", call.parts}, {"along", {way[0], way[1], way[2]}}, {"by", length}});
  }

  void callout(Json& json, const Call& call) {
    json["callouts"] = true;
    const Json& number = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (number.is_null()) return;
    if (!number.is_number() || number != std::floor(number.get<double>())) {
      return tell("callout() takes a whole number or nothing, as in callout(3) lid();");
    }
    json["items"][fmt::format("{:.0f}", number.get<double>())] = call.parts.front();
  }

  /// The last one holds.
  void view(Json& json, const Mark& mark) {
    const auto given = [&](std::size_t i) {
      return i < mark.arguments.size() && !mark.arguments[i].is_null();
    };
    if (given(0)) json["view"]["from"] = mark.arguments[0];
    if (given(1)) json["view"]["up"] = mark.arguments[1];
  }

  const csg::Tree& tree_;
  std::string stem_, object_;
  Diagnostics& diagnostics_;
  std::vector<std::uint8_t> calm_, plain_, holds_;
  std::vector<TreePart> parts_;
  std::vector<std::vector<std::size_t>> calls_of_;
  std::map<std::tuple<bool, bool, std::string, std::string, std::vector<std::size_t>>, std::size_t>
      groups_;
  std::vector<Call> calls_;
  std::vector<Mark> views_;
};

}  // namespace

bool has_unknown_facets(const csg::Tree& tree, const TreePart& part) {
  const auto unknown = [&](std::uint32_t n) {
    const Module m = tree.nodes[n].module;
    if (m == Module::Polyhedron) return !mark_at(tree, n);
    return m == Module::Polygon || m == Module::Text || m == Module::Import ||
           m == Module::Surface || m == Module::Minkowski;
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
    switch (tree.nodes[n].module) {
      case Module::Square:
      case Module::Circle:
      case Module::Polygon:
      case Module::Text:
      case Module::Offset:
      case Module::Projection:
        return true;
      case Module::Cube:
      case Module::Sphere:
      case Module::Cylinder:
      case Module::Polyhedron:
      case Module::Surface:
      case Module::LinearExtrude:
      case Module::RotateExtrude:
        if (!mark_at(tree, n)) return false;
        break;
      default:
        break;
    }
  }
  return false;
}

TreeParts parts_of(const csg::Tree& tree, std::string_view program, const std::string& stem,
                   Diagnostics& diagnostics) {
  return Divider(tree, stem, diagnostics).run(program);
}

}  // namespace burin::detail
