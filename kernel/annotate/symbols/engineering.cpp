#include <burin/drawing/font.h>
#include <burin/options/declared.h>
#include <burin/options/row.h>

#include "frame_path.h"
#include "own_symbols.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace burin::detail {
namespace {

struct SurfaceSymbol {
  static constexpr const char* kRow = "surface";
  enum class Material { Any, Removed, Kept };
  Material material = Material::Any;

  static std::vector<OptionRow<SurfaceSymbol>> rows() {
    return {options::word("material", &SurfaceSymbol::material, {"any", "removed", "kept"},
                          "whether material is to be removed, must be kept, or may be either")};
  }
};

/// Of the height of letters, @cite ISO1302: the short and the long leg of the tick.
constexpr double kShortLeg = 1.4, kLongLeg = 3;

Label draw_surface(const SymbolRequest& request) {
  using Material = SurfaceSymbol::Material;
  const auto [material] = values_in<SurfaceSymbol>(request.values);
  const double h = request.pens.height, line = request.pens.line;
  const double slope = 1 / std::numbers::sqrt3;  // both legs are steep by 60 degrees
  const double low = kShortLeg * h, high = kLongLeg * h;
  const Vec2 foot(slope * low + 0.3 * h, 0);
  const Vec2 left = foot + low * Vec2(-slope, 1), bend = foot + low * Vec2(slope, 1);
  const Vec2 top = foot + high * Vec2(slope, 1);
  const std::string text = in_one_line(request.text);
  const double words = text.empty() ? 0 : text_width(text, h) + 0.6 * h;
  Label out;
  out.size = {top.x + words + 0.3 * h, high};
  out.underlined = true;
  out.paths.push_back(label_line({left, foot, top}, line));
  if (material == Material::Removed) out.paths.push_back(label_line({left, bend}, line));
  if (material == Material::Kept) {
    // Touches both legs and the line between them that is not drawn.
    const double radius = low / 3;
    out.paths.push_back(circle(foot + Vec2(0, 2 * radius), radius, line));
  }
  if (words > 0) {
    out.paths.push_back(label_line({top, top + Vec2(words, 0)}, line));
    out.texts.push_back({top + Vec2(0.3 * h, -1.4 * h), h, TextAnchor::Start, text, "note", 0});
  }
  return out;
}

struct WeldSymbol {
  static constexpr const char* kRow = "weld";
  enum class Joint { Fillet, Square, V, Bevel, Plug, Spot };
  Joint joint = Joint::Fillet;

  static std::vector<OptionRow<WeldSymbol>> rows() {
    return {options::word("joint", &WeldSymbol::joint,
                          {"fillet", "square", "v", "bevel", "plug", "spot"},
                          "how the parts are prepared")};
  }
};

/// The sign on the reference line, from its left end; how wide it is.
double add_joint(WeldSymbol::Joint joint, double left, const LabelPens& pens, Label& out) {
  using Joint = WeldSymbol::Joint;
  const double side = 1.2 * pens.height, line = pens.line;
  const auto add = [&](std::vector<Vec2> points) {
    for (Vec2& p : points) p = Vec2(left, 0) + side * p;
    out.paths.push_back(label_line(std::move(points), line));
  };
  switch (joint) {
    case Joint::Fillet:
      add({{0, 0}, {0, 1}, {1, 0}});
      return side;
    case Joint::Square:
      add({{0, 0}, {0, 1}});
      add({{0.4, 0}, {0.4, 1}});
      return 0.4 * side;
    case Joint::V:
      add({{0, 1}, {0.55, 0}, {1.1, 1}});
      return 1.1 * side;
    case Joint::Bevel:
      add({{0, 1}, {0, 0}, {0.6, 1}});
      return 0.6 * side;
    case Joint::Plug:
      add({{0, 0}, {0, 0.8}, {1.4, 0.8}, {1.4, 0}});
      return 1.4 * side;
    case Joint::Spot:
      out.paths.push_back(circle({left + 0.5 * side, 0.5 * side}, 0.5 * side, line));
      return side;
  }
  return side;
}

/// The size before the sign, and its length behind: "a5|3x50".
Label draw_weld(const SymbolRequest& request) {
  const double h = request.pens.height, gap = 0.5 * h, base = 0.25 * h;
  const std::string text = in_one_line(request.text);
  const std::size_t bar = text.find('|');
  const std::string before = text.substr(0, bar);
  const std::string behind = bar == std::string::npos ? "" : text.substr(bar + 1);
  Label out;
  out.underlined = true;
  double x = 2 * h;
  const auto write = [&](const std::string& words) {
    if (words.empty()) return;
    out.texts.push_back({{x, base}, h, TextAnchor::Start, words, "note", 0});
    x += text_width(words, h) + gap;
  };
  write(before);
  x += add_joint(values_in<WeldSymbol>(request.values).joint, x, request.pens, out) + gap;
  write(behind);
  out.size = {x + 1.5 * h, 1.25 * h};
  return out;
}

Label draw_balloon(const SymbolRequest& request) {
  const double h = request.pens.height;
  const std::string text = in_one_line(request.text);
  const double radius = std::max(1.4 * h, 0.5 * text_width(text, h) + 0.6 * h);
  Label out;
  out.size = Vec2(2 * radius);
  out.shoulder = radius;
  out.paths.push_back(circle(Vec2(radius), radius, request.pens.line));
  out.texts.push_back({{radius, radius - 0.5 * h}, h, TextAnchor::Middle, text, "note", 0});
  return out;
}

}  // namespace

SymbolKind surface_symbol() {
  return {"surface", "surface texture (ISO 1302), its text beside", draw_surface,
          declared<SurfaceSymbol>()};
}

SymbolKind weld_symbol() {
  return {"weld", "a weld (ISO 2553); \"a5|50\" is its size, and its length behind the sign",
          draw_weld, declared<WeldSymbol>()};
}

SymbolKind balloon_symbol() { return {"balloon", "the text in a circle", draw_balloon, {}}; }

}  // namespace burin::detail
