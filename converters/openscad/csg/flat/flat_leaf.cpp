#include "at_node.h"
#include "clip.h"
#include "flat.h"
#include "flat/import/import_file.h"
#include "fragments.h"
#include "lettering.h"
#include "origins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin::csg {
namespace {

Region one_outline(std::vector<Vec2> points) {
  Region region;
  region.outlines.push_back({std::move(points), {}});
  region.outlines[0].arc.assign(region.outlines[0].points.size(), -1);
  return region;
}

Region square(const Node& node) {
  const std::vector<double> size = node.numbers("size");
  if (size.size() < 2 || !(size[0] > 0 && size[1] > 0)) return {};
  if (!std::isfinite(size[0]) || !std::isfinite(size[1])) return {};
  const Vec2 whole(size[0], size[1]);
  const Vec2 low = node.truth("center", false) ? -whole / 2.0 : Vec2(0);
  const Vec2 high = node.truth("center", false) ? whole / 2.0 : whole;
  return one_outline({low, {high.x, low.y}, high, {low.x, high.y}});
}

Region circle(const Node& node) {
  const double r = node.number("r", 1);
  if (!(r > 0) || !std::isfinite(r)) return {};
  const int n = fragments(r, fineness_of(node));
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) points.push_back(r * corner(i, n));
  Region region = one_outline(std::move(points));
  if (n >= kFewestRound) {
    region.arcs.push_back({Vec2(0), r, 2 * M_PI / n});
    region.outlines[0].arc.assign(region.outlines[0].points.size(), 0);
  }
  return region;
}

std::optional<Vec2> point_of(const Value& value) {
  if (!value.is_list() || value.list.size() != 2) return std::nullopt;
  for (const Value& v : value.list) {
    if (v.kind != Value::Kind::Number || !std::isfinite(v.number)) return std::nullopt;
  }
  return Vec2(value.list[0].number, value.list[1].number);
}

/// The points that a path names; those that are not there are told and left out.
std::vector<Vec2> along(Evaluation& e, std::uint32_t node, const Value& path,
                        const std::vector<Vec2>& points) {
  std::vector<Vec2> out;
  for (const Value& index : path.list) {
    const double i = index.kind == Value::Kind::Number ? std::trunc(index.number) : 0;
    if (i >= 0 && i < static_cast<double>(points.size())) {
      out.push_back(points[static_cast<std::size_t>(i)]);
    } else {
      report(e, node, "openscad.no_point", fmt::format("polygon() has no point {:g}", i));
    }
  }
  return out;
}

Region polygon(Evaluation& e, std::uint32_t at) {
  const Node& node = e.tree.nodes[at];
  std::vector<Vec2> points;
  if (const Value* list = node.argument("points")) {
    for (const Value& value : list->list) {
      const std::optional<Vec2> p = point_of(value);
      if (!p) {
        report(e, at, "openscad.no_point",
               fmt::format("point {} of polygon() is no pair of finite numbers; it draws nothing",
                           points.size()));
        return {};
      }
      points.push_back(*p);
    }
  }
  Region crossing;
  const auto add = [&](std::vector<Vec2> outline) {
    if (outline.size() < 3) return;
    crossing.outlines.push_back({std::move(outline), {}});
    crossing.outlines.back().arc.assign(crossing.outlines.back().points.size(), -1);
  };
  const Value* paths = node.argument("paths");
  if (!paths || paths->list.empty()) {
    add(std::move(points));
  } else {
    for (const Value& path : paths->list) add(along(e, at, path, points));
  }
  return odd_places(crossing);
}

Region imported(Evaluation& e, std::uint32_t node) {
  const std::string suffix = suffix_of(file_of(e, node));
  return suffix == ".svg" ? import_svg(e, node) : import_dxf(e, node);
}

}  // namespace

Region leaf_region(Evaluation& e, std::uint32_t node) {
  return at_node(e, node, [&]() -> Region {
    switch (e.tree.nodes[node].module) {
      case Module::Square:
        return square(e.tree.nodes[node]);
      case Module::Circle:
        return circle(e.tree.nodes[node]);
      case Module::Polygon:
        return polygon(e, node);
      case Module::Text:
        return lettering(e, node);
      case Module::Import:
        return imported(e, node);
      default:
        return {};
    }
  });
}

}  // namespace burin::csg
