#include "tree.h"

#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace burin::csg {
namespace {

constexpr std::array<std::string_view, 24> kNames = {
    "cube",       "sphere",       "cylinder", "polyhedron", "square",         "circle",
    "polygon",    "text",         "import",   "surface",    "linear_extrude", "rotate_extrude",
    "projection", "offset",       "resize",   "minkowski",  "hull",           "union",
    "difference", "intersection", "group",    "render",     "color",          "multmatrix"};

[[noreturn]] void is_no(const Node& node, std::string_view name, std::string_view what) {
  throw InputError(fmt::format("{} of {}() is no {}", name, name_of(node.module), what));
}

}  // namespace

std::string_view name_of(Module module) { return kNames[static_cast<std::size_t>(module)]; }

bool makes_solid(Module module) {
  switch (module) {
    case Module::Cube:
    case Module::Sphere:
    case Module::Cylinder:
    case Module::Polyhedron:
    case Module::Surface:
    case Module::LinearExtrude:
    case Module::RotateExtrude:
      return true;
    default:
      return false;
  }
}

bool makes_flat(Module module) {
  switch (module) {
    case Module::Square:
    case Module::Circle:
    case Module::Polygon:
    case Module::Text:
    case Module::Offset:
    case Module::Projection:
      return true;
    default:
      return false;
  }
}

const Value* Node::argument(std::string_view name) const {
  const auto at = std::ranges::find(arguments, name, &Argument::name);
  return at == arguments.end() ? nullptr : &at->value;
}

double Node::number(std::string_view name, double fallback) const {
  const Value* v = argument(name);
  if (!v || v->kind == Value::Kind::Undef) return fallback;
  if (v->kind != Value::Kind::Number) is_no(*this, name, "number");
  return v->number;
}

bool Node::truth(std::string_view name, bool fallback) const {
  const Value* v = argument(name);
  if (!v || v->kind == Value::Kind::Undef) return fallback;
  if (v->kind != Value::Kind::Bool && v->kind != Value::Kind::Number)
    is_no(*this, name, "true or false");
  return v->number != 0;
}

std::string Node::text(std::string_view name) const {
  const Value* v = argument(name);
  if (!v || v->kind == Value::Kind::Undef) return {};
  if (v->kind != Value::Kind::String) is_no(*this, name, "text");
  return v->text;
}

std::vector<double> Node::numbers(std::string_view name) const {
  const Value* v = argument(name);
  std::vector<double> out;
  if (!v || v->kind == Value::Kind::Undef) return out;
  if (!v->is_list()) is_no(*this, name, "list of numbers");
  for (const Value& item : v->list) {
    if (item.kind != Value::Kind::Number) is_no(*this, name, "list of numbers");
    out.push_back(item.number);
  }
  return out;
}

std::int64_t Tree::line_of(std::uint32_t node) const {
  const auto end = source.begin() + static_cast<std::ptrdiff_t>(nodes[node].begin);
  return 1 + std::count(source.begin(), end, '\n');
}

Matrix Matrix::operator*(const Matrix& other) const {
  Matrix out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = j == 3 ? row[i][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += row[i][k] * other.row[k][j];
      out.row[i][j] = sum;
    }
  }
  return out;
}

std::array<double, 3> Matrix::operator*(const std::array<double, 3>& p) const {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = row[i][0] * p[0] + row[i][1] * p[1] + row[i][2] * p[2] + row[i][3];
  }
  return out;
}

double Matrix::determinant() const {
  const auto minor = [&](std::size_t a, std::size_t b) {
    return row[1][a] * row[2][b] - row[1][b] * row[2][a];
  };
  return row[0][0] * minor(1, 2) - row[0][1] * minor(0, 2) + row[0][2] * minor(0, 1);
}

std::array<double, 2> top_scale(const Node& node) {
  const Value* scale = node.argument("scale");
  if (!scale || !scale->is_list()) {
    const double both = node.number("scale", 1);
    return {both, both};
  }
  const std::vector<double> two = node.numbers("scale");
  return two.size() < 2 ? std::array{1.0, 1.0} : std::array{two[0], two[1]};
}

std::string not_known_in(const Tree& tree) {
  for (const Node& n : tree.nodes) {
    if (n.module == Module::LinearExtrude) {
      const std::vector<double> way = n.numbers("v");
      const bool up = way.empty() || (way.size() == 3 && way[0] == 0 && way[1] == 0 && way[2] > 0);
      if (!up) return "linear_extrude() along a vector";
      if (n.number("segments", 0) > 0) return "linear_extrude() in segments";
    } else if (n.module == Module::RotateExtrude) {
      // A whole turn begins at 180 degrees: where it begins shows in its facets alone.
      const double angle = n.number("angle", 360);
      const bool whole = angle <= -360 || angle >= 360;
      if (whole && n.number("start", 180) != 180) return "rotate_extrude() with a start";
    } else if (n.module == Module::Import) {
      const bool svg = lowered(n.text("file")).ends_with(".svg");
      if (!n.text("id").empty() || (svg && !n.text("layer").empty())) {
        return "import() of a part of a file";
      }
    }
  }
  return {};
}

bool is_canonical(const Tree& tree) {
  const auto has = [](const Node& n, std::initializer_list<std::string_view> names) {
    return std::ranges::all_of(names, [&](std::string_view name) { return n.argument(name); });
  };
  return std::ranges::all_of(tree.nodes, [&](const Node& n) {
    switch (n.module) {
      case Module::Cube:
      case Module::Square:
        return has(n, {"size", "center"}) && n.argument("size")->is_list();
      case Module::Sphere:
      case Module::Circle:
        return has(n, {"$fn", "$fa", "$fs", "r"});
      case Module::Cylinder:
        return has(n, {"$fn", "$fa", "$fs", "h", "r1", "r2", "center"});
      case Module::Polyhedron:
        return has(n, {"points", "faces"});
      case Module::Polygon:
        return has(n, {"points", "paths"});
      case Module::Text:
        return has(n, {"text", "size", "font", "halign", "valign", "$fn"});
      case Module::Import:
      case Module::Surface:
        return has(n, {"file"});
      case Module::LinearExtrude:
        return has(n, {"height", "center", "scale"}) || has(n, {"height", "$fn", "$fa", "$fs"});
      case Module::RotateExtrude:
        return has(n, {"angle", "$fn"});
      case Module::Projection:
        return has(n, {"cut"});
      case Module::Offset:
        return n.argument("r") || n.argument("delta");
      case Module::Resize:
        return has(n, {"newsize", "auto"});
      case Module::Multmatrix:
      case Module::Color:
        return n.arguments.size() == 1 && n.arguments[0].value.is_list();
      default:
        return true;
    }
  });
}

Matrix matrix_of(const Tree& tree, std::uint32_t node) {
  const Node& n = tree.nodes[node];
  if (n.module != Module::Multmatrix) return {};
  const auto fail = [&] {
    throw InputError("multmatrix() without four rows of four numbers", tree.file,
                     tree.line_of(node));
  };
  if (n.arguments.empty() || n.arguments[0].value.list.size() != 4) fail();
  Matrix out;
  for (std::size_t i = 0; i < 4; ++i) {
    const Value& row = n.arguments[0].value.list[i];
    if (row.list.size() != 4) fail();
    for (std::size_t j = 0; j < 4; ++j) {
      const Value& v = row.list[j];
      if (v.kind != Value::Kind::Number) fail();
      if (!std::isfinite(v.number)) return {.row = {}};
      // OpenSCAD divides by the last number of the last row.
      if (i < 3) out.row[i][j] = v.number;
    }
  }
  const double w = n.arguments[0].value.list[3].list[3].number;
  if (w != 1 && w != 0) {
    for (auto& row : out.row) {
      for (double& v : row) v /= w;
    }
  }
  return out;
}

}  // namespace burin::csg
