// The ink on paper is the tone that was asked for.
#include <burin/camera/camera.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/tone/tone.h>
#include <burin/visibility/occluder.h>

#include "burin_test/ink.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace burin {
namespace {

struct ToneReport {
  double mean_error = 0;             // mean |ink - target| over the cells measured
  std::size_t cells = 0;             // that were measured
  std::array<double, 10> by_tone{};  // mean ink in ten bins of the target
  std::array<std::size_t, 10> count{};
};

constexpr double kPitch = 0.05;  // paper mm of the fine grid
constexpr int kCoarse = 10;      // fine cells a coarse one: 0.5 mm
constexpr int kBlur = 2;         // coarse cells: a disc of 2 mm across

Camera camera_of_view(const Scene& scene, const char* view) {
  const NamedView v = named_view(view);
  return Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                     {.direction = v.direction, .up = v.up, .paper = {120, 90}});
}

// The darkness that the style asks for in each coarse cell, with the exponent that the drawing
// states; -1 where there is paper only.
std::vector<float> target_tone(const Scene& scene, const Camera& camera, const Style& style,
                               double gamma, int nx, int ny) {
  RunContext context;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::vector<const ProxyMesh*> proxies;
  for (const Part& part : scene.parts) {
    surfaces.push_back(part.form->realise({.curvature = false}, context));
    proxies.push_back(&surfaces.back()->proxy());
  }
  const Occluder occluder(proxies, context);
  const Tone tone = tone::make(camera, style.tone);
  std::vector<float> out(static_cast<std::size_t>(nx * ny), -1);
  const double back = 2 * occluder.diagonal();
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const ViewRay ray = camera.ray(kPitch * kCoarse * Vec2(x + 0.5, y + 0.5));
      const auto hit =
          occluder.first_hit(ray.origin - back * ray.direction, ray.direction, 0, 2 * back);
      if (!hit) continue;
      const ProxyMesh& proxy = *proxies[static_cast<std::size_t>(hit->where.part)];
      Vec3 n = proxy.normal(hit->where.face, hit->bary);
      if (glm::dot(n, camera.direction()) < 0) n = -n;
      out[static_cast<std::size_t>(y * nx + x)] = static_cast<float>(
          std::pow(1 - tone(proxy.position(hit->where.face, hit->bary), n), gamma));
    }
  }
  return out;
}

ToneReport measure(const Scene& scene, const char* view, const Style& style) {
  const Camera camera = camera_of_view(scene, view);
  RunContext context;
  const Drawing drawing = illustrate(scene, camera, style, {}, context);
  test::Sheet strokes(120, 90, kPitch), features(120, 90, kPitch);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      // 2 mm beside a feature line: its own ink and the end of the hatching there are not measured.
      path.kind == LineClass::Stroke ? strokes.paint(path) : features.paint(path, 2.0);
    }
  }
  const int nx = strokes.nx() / kCoarse, ny = strokes.ny() / kCoarse;
  const std::vector<float> ink = strokes.shares(kCoarse), near_line = features.shares(kCoarse);
  const std::vector<float> target =
      target_tone(scene, camera, style, drawing.stats.tone_gamma.value_or(1), nx, ny);
  std::vector<std::uint8_t> mask(target.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = target[i] >= 0;
  const std::vector<float> have = test::disc_mean(ink, mask, nx, ny, kBlur);
  const std::vector<float> want = test::disc_mean(target, mask, nx, ny, kBlur);
  ToneReport report;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i] || near_line[i] > 0 || want[i] < 0.05 || want[i] > 0.70) continue;
    report.mean_error += std::abs(have[i] - want[i]);
    ++report.cells;
    const auto bin = static_cast<std::size_t>(want[i] * 10);
    report.by_tone[bin] += have[i];
    ++report.count[bin];
  }
  report.mean_error /= static_cast<double>(std::max<std::size_t>(1, report.cells));
  for (std::size_t b = 0; b < 10; ++b) {
    if (report.count[b] > 0) report.by_tone[b] /= static_cast<double>(report.count[b]);
  }
  return report;
}

Scene scene_of_mesh(TriMesh mesh) {
  Scene scene;
  scene.parts.push_back({"part", "part.stl", std::make_shared<MeshForm>(std::move(mesh))});
  return scene;
}

void expect_tone(const Scene& scene, const char* view, const char* placing = "even",
                 double most = 0.05) {
  Style style = builtin_style(placing == std::string_view("dots") ? "stipple" : "engraving");
  style.hatch.placing = placing;
  const ToneReport report = measure(scene, view, style);
  ASSERT_GT(report.cells, 2000u);
  EXPECT_LE(report.mean_error, most);
  double last = -1;
  for (std::size_t b = 0; b < 10; ++b) {
    if (report.count[b] < 100) continue;  // too few cells for a mean
    EXPECT_GT(report.by_tone[b], last) << "tone " << 0.1 * static_cast<double>(b);
    last = report.by_tone[b];
  }
  ::testing::Test::RecordProperty("mean_error", std::to_string(report.mean_error));
}

TEST(Tone, InkOnATorusIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::torus(30, 12, 160, 80)), "iso");
}

TEST(Tone, InkOnASphereIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::ellipsoid({20, 20, 20}, 160, 80)), "front");
}

TEST(Tone, InkOnACylinderIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::cylinder(20, 50, 96)), "iso");
}

// Chance is uneven over the 2 mm of the eye: that is its look.
TEST(Tone, InkOfStrokesOnPointsOfATorusIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::torus(30, 12, 160, 80)), "iso", "points", 0.07);
}

TEST(Tone, InkOfStrokesOnPointsOfASphereIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::ellipsoid({20, 20, 20}, 160, 80)), "front", "points", 0.07);
}

TEST(Tone, InkOfStrokesOnDiscsOfATorusIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::torus(30, 12, 160, 80)), "iso", "discs");
}

TEST(Tone, InkOfStrokesOnDiscsOfASphereIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::ellipsoid({20, 20, 20}, 160, 80)), "front", "discs");
}

TEST(Tone, AnEngravingHasAsMuchInkOnALightPartAsOnADarkOne) {
  const Style style = builtin_style("engraving");
  for (const char* view : {"front", "iso", "0,-1,-1", "-1,1,0.2"}) {
    const Scene scene = scene_of_mesh(test::torus(30, 12, 160, 80));
    const Camera camera = camera_of_view(scene, view);
    RunContext context;
    const double gamma = *illustrate(scene, camera, style, {}, context).stats.tone_gamma;
    std::vector<float> asked = target_tone(scene, camera, style, gamma, 240, 180);
    std::erase_if(asked, [](float ink) { return ink < 0; });
    const auto middle = asked.begin() + static_cast<std::ptrdiff_t>(asked.size() / 2);
    std::nth_element(asked.begin(), middle, asked.end());
    EXPECT_GE(*middle, 0.28 - 0.01) << view;
    EXPECT_LE(*middle, 0.40 + 0.01) << view;
  }
  RunContext context;
  const Scene scene = scene_of_mesh(test::torus(30, 12, 40, 20));
  EXPECT_FALSE(
      illustrate(scene, camera_of_view(scene, "iso"), builtin_style("technical"), {}, context)
          .stats.tone_gamma);
}

// Every built-in style that carries tone.
TEST(Tone, OfEachStyleIsWhatTheLightAsks) {
  const Scene scene = scene_of_mesh(test::torus(30, 12, 160, 80));
  for (const char* name :
       {"engraving", "pencil", "stipple", "woodcut", "plotter", "scratchboard"}) {
    const ToneReport report = measure(scene, "iso", builtin_style(name));
    EXPECT_GT(report.cells, 1000u) << name;
    EXPECT_LE(report.mean_error, 0.05) << name;
    ::testing::Test::RecordProperty(name, std::to_string(report.mean_error));
  }
}

// Nothing but the distances of its lines carries the tone: from where one family is enough to where
// both are as dense as they may be.
TEST(Tone, OfOnePenIsAnyThatIsAsked) {
  Style style = builtin_style("plotter");
  for (const char* setting : {"law=constant", "highlight=1", "rim=0", "median_min=0",
                              "median_max=1", "contrast=0", "gradient=0"}) {
    const std::string word = setting;
    const std::size_t at = word.find('=');
    set_style_key(style, "tone." + word.substr(0, at), word.substr(at + 1));
  }
  const Scene round = scene_of_mesh(test::cylinder(20, 50, 96));
  const Scene torus = scene_of_mesh(test::torus(30, 12, 160, 80));
  for (const char* light : {"0.85", "0.75", "0.65", "0.58", "0.5", "0.42", "0.35"}) {
    set_style_key(style, "tone.ambient", light);
    for (const Scene* scene : {&round, &torus}) {
      const ToneReport report = measure(*scene, "iso", style);
      EXPECT_GT(report.cells, 1000u) << light;
      EXPECT_LE(report.mean_error, 0.05) << light << (scene == &round ? " cylinder" : " torus");
    }
  }
}

TEST(Tone, InkOfTwoKindsOfStrokesTogetherIsWhatTheLightAsks) {
  Style style = builtin_style("engraving");
  set_style_key(style, "strokes.2.kind", "dots");
  for (const char* share : {"0.5", "1"}) {
    set_style_key(style, "strokes.2.share", share);
    const ToneReport report = measure(scene_of_mesh(test::torus(30, 12, 160, 80)), "iso", style);
    EXPECT_GT(report.cells, 2000u);
    EXPECT_LE(report.mean_error, 0.05) << share;
    ::testing::Test::RecordProperty(share, std::to_string(report.mean_error));
  }
}

TEST(Tone, InkOfDotsOnATorusIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::torus(30, 12, 160, 80)), "iso", "dots");
}

TEST(Tone, InkOfDotsOnASphereIsWhatTheLightAsks) {
  expect_tone(scene_of_mesh(test::ellipsoid({20, 20, 20}, 160, 80)), "front", "dots");
}

}  // namespace
}  // namespace burin
