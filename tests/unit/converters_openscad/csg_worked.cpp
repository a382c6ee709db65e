#include "csg_worked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace burin::csg::test {
namespace {

using std::numbers::pi;

std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges(const Solid& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> out;
  for (const auto& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      auto& [balance, count] = out[std::minmax(a, b)];
      balance += a < b ? 1 : -1;
      ++count;
    }
  }
  return out;
}

}  // namespace

bool Worked::reported(const std::string& code) const {
  return std::ranges::any_of(diagnostics.entries(),
                             [&](const Diagnostic& d) { return d.code == code; });
}

Worked work_out(const std::string& text, std::uint32_t node, const std::filesystem::path& folder) {
  RunContext run;
  const Tree tree = parse(text, "test.csg", run);
  Evaluation e{.tree = tree, .folder = folder, .run = run};
  const std::vector<std::uint32_t> nodes{node};
  Worked out;
  out.solid = evaluate(e, nodes, [](double) {})[0];
  out.diagnostics = e.diagnostics;
  out.cuts = e.cuts;
  return out;
}

std::size_t open_edges(const Solid& solid) {
  const auto all = edges(solid);
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [](const auto& e) { return e.second.first != 0; }));
}

std::size_t shared_edges(const Solid& solid) {
  const auto all = edges(solid);
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [](const auto& e) { return e.second.second > 2; }));
}

std::string cube(double x, double y, double z) {
  return fmt::format("cube(size = [{}, {}, {}], center = false);\n", x, y, z);
}
std::string cylinder(double h, double r1, double r2, int fn) {
  return fmt::format(
      "cylinder($fn = {}, $fa = 12, $fs = 2, h = {}, r1 = {}, r2 = {}, center = true);\n", fn, h,
      r1, r2);
}
std::string sphere(double r, int fn) {
  return fmt::format("sphere($fn = {}, $fa = 12, $fs = 2, r = {});\n", fn, r);
}
std::string moved(double x, double y, double z, const std::string& what) {
  return fmt::format(
      "multmatrix([[1, 0, 0, {}], [0, 1, 0, {}], [0, 0, 1, {}], [0, 0, 0, 1]]) {{ {} }}\n", x, y, z,
      what);
}
std::string turned(double degrees, const std::string& what) {
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  return fmt::format(
      "multmatrix([[{}, {}, 0, 0], [{}, {}, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {{ {} }}\n", c, -s,
      s, c, what);
}
std::string scaled(double x, double y, double z, const std::string& what) {
  return fmt::format(
      "multmatrix([[{}, 0, 0, 0], [0, {}, 0, 0], [0, 0, {}, 0], [0, 0, 0, 1]]) {{ {} }}\n", x, y, z,
      what);
}

double polygon_area(double r, int n) { return n / 2.0 * std::sin(2 * pi / n) * r * r; }

double sphere_volume(double r, int n) {
  const int rings = (n + 1) / 2;
  const auto angle = [&](int k) { return pi * (k + 0.5) / rings; };
  double sum = 0;
  for (int k = 0; k + 1 < rings; ++k) {
    const double a = std::sin(angle(k)), b = std::sin(angle(k + 1));
    sum += (std::cos(angle(k)) - std::cos(angle(k + 1))) * (a * a + a * b + b * b) / 3;
  }
  return sum * r * polygon_area(r, n);
}

}  // namespace burin::csg::test
