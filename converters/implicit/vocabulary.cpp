#include "vocabulary.h"

#include <algorithm>

namespace burin::implicit_text {
namespace {

using F = std::span<const Expression>;
using N = std::span<const double>;

// Many operands are joined in pairs, as a balanced tree.
Expression joined(F f, Expression (*join)(const Expression&, const Expression&)) {
  if (f.size() == 1) return f[0];
  const std::size_t half = f.size() / 2;
  return join(joined(f.first(half), join), joined(f.subspan(half), join));
}

using namespace implicit;

const Word kWords[] = {
    {"sqrt", "sqrt(a)", 1, 1, false, [](F f, N) { return implicit::sqrt(f[0]); }},
    {"exp", "exp(a)", 1, 1, false, [](F f, N) { return implicit::exp(f[0]); }},
    {"log", "log(a)", 1, 1, false, [](F f, N) { return implicit::log(f[0]); }},
    {"sin", "sin(a), in radians", 1, 1, false, [](F f, N) { return implicit::sin(f[0]); }},
    {"cos", "cos(a), in radians", 1, 1, false, [](F f, N) { return implicit::cos(f[0]); }},
    {"tan", "tan(a), in radians", 1, 1, false, [](F f, N) { return implicit::tan(f[0]); }},
    {"asin", "asin(a)", 1, 1, false, [](F f, N) { return implicit::asin(f[0]); }},
    {"acos", "acos(a)", 1, 1, false, [](F f, N) { return implicit::acos(f[0]); }},
    {"atan", "atan(a)", 1, 1, false, [](F f, N) { return implicit::atan(f[0]); }},
    {"atan2", "atan2(y, x)", 2, 2, false, [](F f, N) { return implicit::atan2(f[0], f[1]); }},
    {"pow", "pow(a, b)", 2, 2, false, [](F f, N) { return implicit::pow(f[0], f[1]); }},
    {"abs", "abs(a)", 1, 1, false, [](F f, N) { return implicit::abs(f[0]); }},
    {"round", "round(a)", 1, 1, false, [](F f, N) { return implicit::round(f[0]); }},
    {"min", "min(a, b, ...)", 2, 2, true, [](F f, N) { return joined(f, implicit::min); }},
    {"max", "max(a, b, ...)", 2, 2, true, [](F f, N) { return joined(f, implicit::max); }},

    {"sphere", "sphere(r)", 0, 1, false, [](F, N n) { return sphere(n[0]); }},
    {"box", "box(sx, sy, sz)", 0, 3, false, [](F, N n) { return box(n[0], n[1], n[2]); }},
    {"round_box", "round_box(sx, sy, sz, r)", 0, 4, false,
     [](F, N n) { return round_box(n[0], n[1], n[2], n[3]); }},
    {"cylinder", "cylinder(r, h)", 0, 2, false, [](F, N n) { return cylinder(n[0], n[1]); }},
    {"cone", "cone(r1, r2, h)", 0, 3, false, [](F, N n) { return cone(n[0], n[1], n[2]); }},
    {"torus", "torus(R, r)", 0, 2, false, [](F, N n) { return torus(n[0], n[1]); }},
    {"capsule", "capsule(r, h)", 0, 2, false, [](F, N n) { return capsule(n[0], n[1]); }},
    {"plane", "plane(nx, ny, nz, d)", 0, 4, false,
     [](F, N n) { return plane(n[0], n[1], n[2], n[3]); }},
    {"gyroid", "gyroid(period, thickness)", 0, 2, false, [](F, N n) { return gyroid(n[0], n[1]); }},
    {"superquadric", "superquadric(a, b, c, e1, e2)", 0, 5, false,
     [](F, N n) { return superquadric(n[0], n[1], n[2], n[3], n[4]); }},
    {"blob", "blob(r)", 0, 1, false, [](F, N n) { return blob(n[0]); }},

    {"union", "union(f, g, ...)", 2, 2, true, [](F f, N) { return joined(f, unite); }},
    {"intersection", "intersection(f, g, ...)", 2, 2, true,
     [](F f, N) { return joined(f, intersect); }},
    {"difference", "difference(f, g, ...)", 2, 2, true,
     [](F f, N) { return subtract(f[0], joined(f.subspan(1), unite)); }},
    {"smooth_union", "smooth_union(f, g, radius)", 2, 3, false,
     [](F f, N n) { return smooth_unite(f[0], f[1], n[0]); }},
    {"smooth_intersection", "smooth_intersection(f, g, radius)", 2, 3, false,
     [](F f, N n) { return smooth_intersect(f[0], f[1], n[0]); }},
    {"smooth_difference", "smooth_difference(f, g, radius)", 2, 3, false,
     [](F f, N n) { return smooth_subtract(f[0], f[1], n[0]); }},

    {"translate", "translate(f, x, y, z)", 1, 4, false,
     [](F f, N n) {
       return translate(f[0], {n[0], n[1], n[2]});
     }},
    {"rotate", "rotate(f, ax, ay, az), in degrees", 1, 4, false,
     [](F f, N n) {
       return rotate(f[0], {n[0], n[1], n[2]});
     }},
    {"scale", "scale(f, s)", 1, 2, false, [](F f, N n) { return scale(f[0], n[0]); }},
    {"mirror", "mirror(f, nx, ny, nz)", 1, 4, false,
     [](F f, N n) {
       return mirror(f[0], {n[0], n[1], n[2]});
     }},
    {"shell", "shell(f, thickness)", 1, 2, false, [](F f, N n) { return shell(f[0], n[0]); }},
    {"offset", "offset(f, d)", 1, 2, false, [](F f, N n) { return offset(f[0], n[0]); }},
    {"twist", "twist(f, degrees_per_mm)", 1, 2, false, [](F f, N n) { return twist(f[0], n[0]); }},
    {"repeat", "repeat(f, px, py, pz)", 1, 4, false,
     [](F f, N n) {
       return repeat(f[0], {n[0], n[1], n[2]});
     }},
};

}  // namespace

const Word* find_word(std::string_view name) {
  const auto it = std::ranges::find(kWords, name, &Word::name);
  return it == std::end(kWords) ? nullptr : it;
}

std::vector<std::string> word_names() {
  std::vector<std::string> names;
  for (const Word& w : kWords) names.emplace_back(w.name);
  return names;
}

}  // namespace burin::implicit_text
