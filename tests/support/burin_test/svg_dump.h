#pragma once
/// Curves as a plain SVG, coloured by what they are, for debugging a module.

#include <burin/base/curve.h>
#include <burin/camera/camera.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace burin::test {

/// Contours black, creases blue, boundaries green, intersections red; self-hidden segments pale.
/// Red dots at the ends of open curves of `dots` mm (0: none).
inline void dump_svg(const std::filesystem::path& path, const Camera& camera,
                     std::span<const Curve3> curves, double dots = 0, double width = 0.25) {
  const auto colour = [](LineClass kind) {
    if (kind == LineClass::Contour) return "#000";
    if (kind == LineClass::Crease) return "#06c";
    if (kind == LineClass::Boundary) return "#080";
    return "#d00";
  };
  std::ofstream out(path);
  const Paper& paper = camera.paper();
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\"><rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<g fill=\"none\" stroke-linecap=\"round\">\n",
      paper.width, paper.height);
  const auto xy = [&](Vec3 p) {
    const Vec2 q = camera.to_paper(p);
    return fmt::format("{:.4f} {:.4f}", q.x, paper.height - q.y);
  };
  for (const bool hidden : {true, false}) {
    for (const Curve3& c : curves) {
      std::string d;
      for (std::size_t i = 0; i < c.segment_count(); ++i) {
        if ((!c.self_hidden.empty() && c.self_hidden[i] != 0) != hidden) continue;
        d += "M" + xy(c.points[i]) + "L" + xy(c.points[c.next(i)]);
      }
      if (d.empty()) continue;
      out << fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" opacity=\"{}\"/>\n", d,
                         colour(c.kind), hidden ? width * 0.6 : width, hidden ? 0.3 : 1);
    }
  }
  for (const Curve3& c : curves) {
    if (dots <= 0 || c.closed) continue;
    for (const Vec3& p : {c.points.front(), c.points.back()}) {
      const Vec2 q = camera.to_paper(p);
      out << fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{}\" fill=\"#d00\"/>\n", q.x,
                         paper.height - q.y, dots);
    }
  }
  out << "</g></svg>\n";
}

}  // namespace burin::test
