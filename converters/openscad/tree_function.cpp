#include "tree_function.h"

#include <burin/base/error.h>

#include "affine.h"
#include "fragments.h"
#include "marks.h"
#include "solid.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <vector>

namespace burin::detail {
namespace {

using csg::Module;
using Solid = std::optional<Expression>;  // nothing: empty

/// Formulas of the nodes below one, children before parents. Flat nodes are formulas of x and y.
class Builder {
 public:
  Builder(const csg::Tree& tree, const RunContext& context) : tree_(tree), context_(context) {}

  Solid of(std::uint32_t top) {
    std::unordered_map<std::uint32_t, Solid> made;
    for (std::uint32_t n = tree_.nodes[top].end; n-- > top;) {
      context_.check();
      if (mark_at(tree_, n)) continue;
      std::vector<Solid> children;
      csg::for_each_child(tree_, n, [&](std::uint32_t c) {
        if (!tree_.nodes[c].background && !mark_at(tree_, c)) children.push_back(made[c]);
        made.erase(c);
      });
      made[n] = make(tree_.nodes[n], n, children);
    }
    return made[top];
  }

  static Solid moved(const Solid& f, const csg::Matrix& m) {
    if (!f || m == csg::Matrix{}) return f;
    const Affine by(m);
    if (!(std::abs(glm::determinant(by.linear)) > 0)) return {};
    return implicit::transform(*f, by.linear, by.offset);
  }

 private:
  Solid make(const csg::Node& n, std::uint32_t at, const std::vector<Solid>& children) const {
    switch (n.module) {
      case Module::Cube:
        return cube(n);
      case Module::Sphere:
        return sphere(n);
      case Module::Cylinder:
        return cylinder(n);
      case Module::Square:
        return square(n);
      case Module::Circle:
        return circle(n);
      case Module::Polygon:
        return polygon(n);
      case Module::Difference:
        return difference(children);
      case Module::Intersection:
        return intersection(children);
      case Module::Multmatrix:
        return moved(united(children), csg::matrix_of(tree_, at));
      case Module::LinearExtrude:
        return extruded(n, united(children));
      case Module::RotateExtrude:
        return turned(n, united(children));
      case Module::Group:
      case Module::Union:
      case Module::Render:
      case Module::Color:
        return united(children);
      default:
        has_none(n, "");
    }
  }

  [[noreturn]] void has_none(const csg::Node& n, const char* why) const {
    throw InputError(fmt::format("{}() has no implicit function{}; draw the file without `as_`",
                                 csg::name_of(n.module), why),
                     tree_.file);
  }

  static Solid united(const std::vector<Solid>& children) {
    Solid out;
    for (const Solid& c : children) {
      if (c) out = out ? implicit::unite(*out, *c) : *c;
    }
    return out;
  }
  static Solid difference(const std::vector<Solid>& children) {
    if (children.empty() || !children[0]) return {};
    Solid out = children[0];
    for (std::size_t i = 1; i < children.size(); ++i) {
      if (children[i]) out = implicit::subtract(*out, *children[i]);
    }
    return out;
  }
  static Solid intersection(const std::vector<Solid>& children) {
    Solid out;
    for (const Solid& c : children) {
      if (!c) return {};
      out = out ? implicit::intersect(*out, *c) : *c;
    }
    return out;
  }

  Vec3 sizes(const csg::Node& n, int count) const {
    const csg::Value* v = n.argument("size");
    Vec3 out(1);
    if (v && v->kind == csg::Value::Kind::Number) return Vec3(v->number);
    const std::vector<double> list = n.numbers("size");
    for (int i = 0; i < count && static_cast<std::size_t>(i) < list.size(); ++i) {
      out[i] = list[static_cast<std::size_t>(i)];
    }
    return out;
  }

  Solid cube(const csg::Node& n) const {
    const Vec3 s = sizes(n, 3);
    if (!(s.x > 0 && s.y > 0 && s.z > 0)) return {};
    const Expression box = implicit::box(s.x, s.y, s.z);
    return n.truth("center", false) ? box : implicit::translate(box, 0.5 * s);
  }
  Solid square(const csg::Node& n) const {
    const Vec3 s = sizes(n, 2);
    if (!(s.x > 0 && s.y > 0)) return {};
    const Expression f = implicit::max(implicit::abs(Expression::x()) - 0.5 * s.x,
                                       implicit::abs(Expression::y()) - 0.5 * s.y);
    return n.truth("center", false) ? f : implicit::translate(f, Vec3(0.5 * s.x, 0.5 * s.y, 0));
  }

  /// Few corners are meant where $fn asks for them.
  bool is_round(const csg::Node& n, double radius) const {
    const csg::Fineness fineness = csg::fineness_of(n);
    return !(fineness.fn > 0) || csg::fragments(radius, fineness) >= csg::kFewestRound;
  }
  Solid sphere(const csg::Node& n) const {
    const double r = n.number("r", 1);
    if (!(r > 0)) return {};
    if (!is_round(n, r)) has_none(n, " with so few facets");
    return implicit::sphere(r);
  }
  Solid circle(const csg::Node& n) const {
    const double r = n.number("r", 1);
    if (!(r > 0)) return {};
    if (!is_round(n, r)) return prism(n, r, r, 0);
    return axis_distance() - r;
  }
  Solid cylinder(const csg::Node& n) const {
    const double h = n.number("h", 1), r1 = n.number("r1", 1), r2 = n.number("r2", 1);
    if (!(h > 0) || !(r1 >= 0) || !(r2 >= 0) || !(r1 + r2 > 0)) return {};
    const double low = n.truth("center", false) ? -0.5 * h : 0;
    const double r = std::max(r1, r2);
    // The box gives bounds; none of its sides is a face but the two ends.
    const Expression ends =
        implicit::translate(implicit::box(2 * r, 2 * r, h), Vec3(0, 0, low + 0.5 * h));
    if (!is_round(n, r)) return implicit::intersect(*prism(n, r1, r2, h, low), ends);
    const Expression side = (axis_distance() - r1 - (r2 - r1) / h * (Expression::z() - low)) *
                            (h / std::hypot(h, r2 - r1));
    return implicit::intersect(side, ends);
  }

  /// Without its ends: a polygon of few corners, r1 at z = low and r2 at low + h; h = 0: upright.
  Solid prism(const csg::Node& n, double r1, double r2, double h, double low = 0) const {
    const int corners = csg::fragments(std::max(r1, r2), csg::fineness_of(n));
    const double share = std::cos(std::numbers::pi / corners);  // of the radius, to the sides
    const double rise = h > 0 ? (r2 - r1) * share / h : 0;
    Solid out;
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * std::numbers::pi * (i + 0.5) / corners;
      const Expression side = (std::cos(a) * Expression::x() + std::sin(a) * Expression::y() -
                               r1 * share - rise * (Expression::z() - low)) /
                              std::hypot(1, rise);
      out = out ? implicit::max(*out, side) : side;
    }
    return out;
  }

  /// Convex ones alone.
  Solid polygon(const csg::Node& n) const {
    const csg::Value* points = n.argument("points");
    const csg::Value* paths = n.argument("paths");
    if (!points || points->list.size() < 3) return {};
    if (paths && paths->list.size() > 1) has_none(n, " with several paths");
    std::vector<Vec2> corners;
    const auto add = [&](const csg::Value& p) {
      if (p.list.size() >= 2) corners.emplace_back(p.list[0].number, p.list[1].number);
    };
    if (paths && !paths->list.empty()) {
      for (const csg::Value& i : paths->list[0].list) {
        if (i.number >= 0 && i.number < static_cast<double>(points->list.size())) {
          add(points->list[static_cast<std::size_t>(i.number)]);
        }
      }
    } else {
      for (const csg::Value& p : points->list) add(p);
    }
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      area += cross2(corners[i], corners[(i + 1) % corners.size()]);
    }
    Solid out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()],
                 c = corners[(i + 2) % corners.size()];
      if (cross2(b - a, c - b) * area < 0) has_none(n, " that is not convex");
      if (a == b) continue;
      const Vec2 along = glm::normalize(b - a) * (area > 0 ? 1.0 : -1.0);
      const Expression side = along.y * (Expression::x() - a.x) - along.x * (Expression::y() - a.y);
      out = out ? implicit::max(*out, side) : side;
    }
    return out;
  }

  Solid extruded(const csg::Node& n, const Solid& flat) const {
    if (!flat) return {};
    if (n.number("twist", 0) != 0) has_none(n, " with a twist");
    for (const double s : csg::top_scale(n)) {
      if (s != 1) has_none(n, " with a scale");
    }
    const double h = n.number("height", 100);
    if (!(h > 0)) return {};
    const double low = n.truth("center", false) ? -0.5 * h : 0;
    return implicit::intersect(*flat, slab(low, low + h));
  }
  Solid turned(const csg::Node& n, const Solid& flat) const {
    if (!flat) return {};
    if (n.number("angle", 360) != 360) has_none(n, " of less than a whole turn");
    return implicit::substitute(*flat, axis_distance(), Expression::z(), Expression(0.));
  }

  static Expression axis_distance() {
    return implicit::sqrt(implicit::square(Expression::x()) + implicit::square(Expression::y()));
  }
  static Expression slab(double low, double high) {
    return implicit::abs(Expression::z() - 0.5 * (low + high)) - 0.5 * (high - low);
  }

  const csg::Tree& tree_;
  const RunContext& context_;
};

}  // namespace

Expression function_of(const csg::Tree& tree, const TreePart& part, const RunContext& context) {
  Builder builder(tree, context);
  Solid all;
  for (const TreePart::Piece& piece : part.pieces) {
    const Solid one = Builder::moved(builder.of(piece.node), piece.at);
    if (one) all = all ? implicit::unite(*all, *one) : *one;
  }
  if (!all) throw InputError(fmt::format("{} is empty", part.name), tree.file);
  return *all;
}

}  // namespace burin::detail
