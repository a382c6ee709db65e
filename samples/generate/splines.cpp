#include "splines.h"

#include <fmt/format.h>
#include <fmt/os.h>

#include <array>
#include <numbers>

namespace burin::samples {
namespace {

/// Corners of the square about the unit circle and the middles of its sides, from +x on.
constexpr std::array<Vec2, 9> kCircle = {Vec2(1, 0),  Vec2(1, 1),  Vec2(0, 1),
                                         Vec2(-1, 1), Vec2(-1, 0), Vec2(-1, -1),
                                         Vec2(0, -1), Vec2(1, -1), Vec2(1, 0)};

std::vector<double> clamped_knots(int count, int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree + 1), 0);
  for (int i = 1; i < count - degree; ++i) knots.push_back(i);
  knots.insert(knots.end(), static_cast<std::size_t>(degree + 1), count - degree);
  return knots;
}

std::string knots_text(const std::vector<double>& knots) {
  std::string text = "[KV";
  for (const double k : knots) text += fmt::format(" {:.9g}", k);
  return text + "]";
}

}  // namespace

NurbsData sweep(const std::vector<Ring>& rings) {
  NurbsData data;
  data.degree_u = 3;
  data.degree_v = 2;
  data.count_u = static_cast<int>(rings.size());
  data.count_v = static_cast<int>(kCircle.size());
  data.knots_u = clamped_knots(data.count_u, 3);
  data.knots_v = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  for (const Ring& ring : rings) {
    for (std::size_t j = 0; j < kCircle.size(); ++j) {
      data.points.push_back(ring.center + kCircle[j].x * ring.a + kCircle[j].y * ring.b);
      data.weights.push_back(j % 2 == 0 ? 1 : std::numbers::sqrt2 / 2);
    }
  }
  return data;
}

NurbsData turn(const std::vector<Vec2>& profile) {
  std::vector<Ring> rings;
  for (const Vec2& p : profile) rings.push_back({{0, 0, p.y}, {p.x, 0, 0}, {0, p.x, 0}});
  return sweep(rings);
}

void write_irit(const std::vector<SplineObject>& objects, const std::filesystem::path& path) {
  auto out = fmt::output_file(path.string());
  std::string name = path.stem().string();
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const bool list = objects.size() > 1;
  if (list) out.print("[OBJECT {}\n", name);
  for (const SplineObject& object : objects) {
    const std::string rgb = object.rgb.empty() ? "" : fmt::format("[RGB \"{}\"] ", object.rgb);
    out.print("[OBJECT {}{}\n", rgb, object.name);
    for (const NurbsData& s : object.surfaces) {
      out.print("  [SURFACE BSPLINE {} {} {} {} P3\n", s.count_u, s.count_v, s.degree_u + 1,
                s.degree_v + 1);
      out.print("    {}\n    {}\n", knots_text(s.knots_u), knots_text(s.knots_v));
      for (int j = 0; j < s.count_v; ++j) {
        for (int i = 0; i < s.count_u; ++i) {
          const auto k = static_cast<std::size_t>(i * s.count_v + j);
          const double w = s.weights[k];
          const Vec3 p = w * s.points[k];
          out.print("    [{:.9g} {:.9g} {:.9g} {:.9g}]\n", w, p.x, p.y, p.z);
        }
      }
      out.print("  ]\n");
    }
    out.print("]\n");
  }
  if (list) out.print("]\n");
}

}  // namespace burin::samples
