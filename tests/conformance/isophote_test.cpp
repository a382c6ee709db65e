/// Strokes of constant angle to the view on every form: the angle stays along them and changes
/// across, whatever the surface is made of.

#include <burin/field/field.h>

#include "forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace burin {
namespace {

using test::FormCase;

class IsophotesOnAnyForm : public testing::TestWithParam<FormCase> {};

TEST_P(IsophotesOnAnyForm, KeepTheAngleAlongAndChangeItAcross) {
  RunContext context;
  const auto& surface = test::realised(GetParam()).surface;
  const double size = surface->proxy().mesh.bounds().diagonal();
  const Vec3 view = glm::normalize(Vec3(0.6, -1, 0.8));
  // Bends of less than a radius of 20 sizes: elsewhere there is no angle to keep.
  const field::AngleOptions options{.flat = 0.05 / size};
  const Field field = field::isophote(view, options);
  const double step = 0.003 * size;
  std::vector<double> shares;
  for (const SurfacePoint& p : surface->cover({.count = 500, .seed = 3}, context)) {
    const Frame f = surface->frame(p);
    const auto cross = field.cross({0, p, f});
    if (!cross || cross->certainty < 0.2) continue;
    const Vec3 along = cross->first;
    const auto change = [&](Vec3 t) -> std::optional<double> {
      const MarchStep forth = surface->march(p, t, step), back = surface->march(p, -t, step);
      if (forth.stop != MarchStop::Completed || back.stop != MarchStop::Completed) return {};
      return glm::dot(surface->frame(forth.end).normal - surface->frame(back.end).normal, view);
    };
    const auto kept = change(along), across = change(glm::cross(f.normal, along));
    if (!kept || !across) continue;
    shares.push_back(std::abs(*kept) / std::max(std::abs(*across), 1e-12));
    EXPECT_NEAR(glm::dot(along, f.normal), 0, 1e-9);
  }
  // Boxes are flat; elsewhere nearly every point has a direction.
  if (shares.size() < 20) return;
  std::sort(shares.begin(), shares.end());
  const bool is_mesh = GetParam().name.starts_with("Mesh");
  EXPECT_LT(shares[shares.size() / 2], is_mesh ? 0.35 : 0.01) << "in the median";
  EXPECT_LT(shares[shares.size() * 4 / 5], is_mesh ? 1.0 : 0.1);
}

INSTANTIATE_TEST_SUITE_P(Forms, IsophotesOnAnyForm, testing::ValuesIn(test::form_cases()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace burin
