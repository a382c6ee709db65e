#pragma once
/// Spans as a plain SVG: visible lines black (the outer outline thick), hidden ones pale red if
/// asked for. For debugging a module.

#include <burin_test/view.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace burin::test {

struct SvgLook {
  bool hidden = false;
  /// Red dots of this radius (paper mm) at the ends of visible spans; 0 for none.
  double dots = 0;
  double width = 0.25;
};

inline void dump_visible(const std::filesystem::path& path, const Camera& camera,
                         std::span<const Curve3> curves, std::span<const std::vector<Span>> spans,
                         const SvgLook& look = {}) {
  std::ofstream out(path);
  const Paper& paper = camera.paper();
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\"><rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      paper.width, paper.height);
  const auto xy = [&](Vec3 p) {
    const Vec2 q = camera.to_paper(p);
    return fmt::format("{:.4f} {:.4f}", q.x, paper.height - q.y);
  };
  for (const bool visible : {false, true}) {
    if (!visible && !look.hidden) continue;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (const Span& s : spans[c]) {
        if (s.visible != visible) continue;
        const Curve3 part = slice(curves[c], s.begin, s.end);
        std::string d = "M" + xy(part.points[0]);
        for (std::size_t i = 1; i < part.points.size(); ++i) d += "L" + xy(part.points[i]);
        if (part.closed) d += "Z";
        const bool crease = part.kind != LineClass::Contour && part.kind != LineClass::Boundary;
        const double width = look.width * (!visible                         ? 0.4
                                           : s.outer                        ? 2
                                           : part.kind == LineClass::Stroke ? 0.5
                                                                            : 1);
        out << fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", d,
                           !visible ? "#f99"
                           : crease ? "#048"
                                    : "#000",
                           width);
        if (!visible || look.dots <= 0 || part.closed) continue;
        for (const Vec3& p : {part.points.front(), part.points.back()}) {
          const Vec2 q = camera.to_paper(p);
          out << fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{}\" fill=\"#d00\"/>\n", q.x,
                             paper.height - q.y, look.dots);
        }
      }
    }
  }
  out << "</g></svg>\n";
}

}  // namespace burin::test
