// Laws of strokes that are formulas: each against what the formula says.
#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>

#include "burin_test/horn.h"
#include "burin_test/ink.h"
#include "burin_test/nurbs_shapes.h"
#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace burin {
namespace {

Scene law_ball() {
  Scene scene;
  scene.parts.push_back(
      {"ball", "ball", std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 96, 48))});
  return scene;
}

// Even ink by strokes along z.
Style placed_style(const char* placing) {
  Style style = builtin_style("engraving");
  style.hatch.placing = placing;
  style.hatch.cross_from = 2;
  style.hatch.field.name = "fixed";
  style.tone = {.law = "constant", .ambient = 0.7, .highlight = 1, .rim = 0};
  style.hatch.tone_min = 0.02;
  style.hatch.length_min = 0.5;
  style.hatch.taper = 0;
  style.hatch.width_max = 0.4;
  return style;
}

Drawing draw_laws(const Scene& scene, const Style& style, const char* view = "front",
                  std::uint64_t seed = 1) {
  RunContext context;
  const NamedView v = named_view(view);
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {90, 90}});
  return illustrate(scene, camera, style, {.seed = seed}, context);
}

std::vector<Path> law_strokes(const Drawing& drawing) {
  std::vector<Path> strokes;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == LineClass::Stroke) strokes.push_back(path);
    }
  }
  return strokes;
}

double length_of(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += glm::length(path.points[i] - path.points[i - 1]);
  }
  return sum;
}

TEST(StrokeLaws, AMaskKeepsStrokesWhereItIsPositive) {
  for (const char* placing : {"even", "points", "discs", "dots"}) {
    SCOPED_TRACE(placing);
    Style style = placed_style(placing);
    const std::size_t whole = law_strokes(draw_laws(law_ball(), style)).size();
    for (const char* key : {"hatch.density_law", "hatch.ink_law"}) {
      Style masked = style;
      set_style_key(masked, key, key[6] == 'd' ? "step(x - 2)" : "ink * step(x - 2)");
      const Drawing drawing = draw_laws(law_ball(), masked);
      const auto strokes = law_strokes(drawing);
      EXPECT_GT(strokes.size(), whole / 5);
      EXPECT_LT(strokes.size(), whole / 2);
      for (const Path& path : strokes) {
        // A step of the tracer, 0.4 mm of paper, is as exact as an end is.
        for (const Vec3& p : path.points3) EXPECT_GT(p.x, 2 - 0.5 / drawing.view.scale);
      }
    }
  }
}

// Mean ink in the middle of the ball.
double length_of_ink(const Drawing& drawing) {
  test::Sheet sheet(90, 90, 0.05);
  for (const Path& path : law_strokes(drawing)) sheet.paint(path);
  const std::vector<float> shares = sheet.shares(20);  // 1 mm
  const int nx = sheet.nx() / 20;
  double sum = 0;
  int count = 0;
  for (int y = 35; y < 55; ++y) {
    for (int x = 35; x < 55; ++x, ++count) sum += shares[static_cast<std::size_t>(y * nx + x)];
  }
  return sum / count;
}

TEST(StrokeLaws, TheInkIsWhatItsLawSays) {
  for (const char* placing : {"even", "discs", "dots"}) {
    Style style = placed_style(placing);
    if (placing == std::string("dots")) style.hatch.spacing_min = 0.3;
    for (const double ink : {0.2, 0.45}) {
      SCOPED_TRACE(placing + std::to_string(ink));
      Style lawful = style, plain = style;
      set_style_key(lawful, "hatch.ink_law", std::to_string(ink));
      plain.tone.ambient = 1 - ink;
      const double have = length_of_ink(draw_laws(law_ball(), lawful));
      EXPECT_NEAR(have, length_of_ink(draw_laws(law_ball(), plain)),
                  0.01);  // as where the light asks for it
      EXPECT_NEAR(have, ink, placing == std::string("discs") ? 0.03 : 0.06);
    }
  }
}

Scene sheet_scene() {
  Scene scene;
  scene.parts.push_back({"sheet", "sheet",
                         std::make_shared<ParametricForm>(std::vector<std::shared_ptr<const Chart>>{
                             make_nurbs_chart(test::front_sheet())})});
  return scene;
}

// On a plane strokes have one length; short and wide ones reach little beyond their discs, long and
// thin ones lie over many.
TEST(StrokeLaws, OnDiscsStrokesOfAnyLengthLayTheInkThatIsAskedFor) {
  const Scene scene = sheet_scene();
  for (const double length : {2.0, 6.0}) {
    for (const double ink : {0.2, 0.45, 0.7}) {
      SCOPED_TRACE(std::to_string(length) + " " + std::to_string(ink));
      Style style = placed_style("discs");
      style.hatch.length = length;
      style.hatch.length_min = 0;
      style.hatch.taper = 0.4;
      style.tone.ambient = 1 - ink;
      EXPECT_NEAR(length_of_ink(draw_laws(scene, style)), ink, 0.02);
    }
  }
}

TEST(StrokeLaws, DensitySetsStrokesCloserAndLeavesTheTone) {
  Style style = placed_style("even");
  const Drawing plain = draw_laws(law_ball(), style);
  style.hatch.density_law = "1.6";
  const Drawing close = draw_laws(law_ball(), style);
  const auto lines = [](const Drawing& d) {
    double length = 0;
    for (const Path& path : law_strokes(d)) length += length_of(path);
    return length;
  };
  EXPECT_NEAR(lines(close) / lines(plain), 1.6, 0.15);
  EXPECT_NEAR(length_of_ink(close), length_of_ink(plain), 0.04);
}

TEST(StrokeLaws, WidthsAreMultiplied) {
  for (const char* placing : {"even", "points", "dots"}) {
    SCOPED_TRACE(placing);
    Style style = placed_style(placing);
    const auto plain = law_strokes(draw_laws(law_ball(), style));
    style.hatch.width_law = "0.5";
    const auto half = law_strokes(draw_laws(law_ball(), style));
    ASSERT_EQ(half.size(), plain.size());
    for (std::size_t i = 0; i < half.size(); ++i) {
      EXPECT_NEAR(half[i].width.front(), 0.5 * plain[i].width.front(), 0.006);
    }
  }
  // Along the stroke: it grows from nothing to all.
  Style style = placed_style("points");
  style.hatch.width_law = "t";
  int grown = 0;
  for (const Path& path : law_strokes(draw_laws(law_ball(), style))) {
    if (path.width.size() < 2 || length_of(path) < 2.5) continue;
    grown += path.width.front() < 0.02 && path.width.back() > 0.05;
  }
  EXPECT_GT(grown, 100);
}

// Elber's figure 5: the less of the direction lies in the surface, the shorter the stroke.
TEST(StrokeLaws, LengthsFollowTheAngleBetweenDirectionAndNormal) {
  Style style = placed_style("points");
  style.hatch.length = 3;
  style.hatch.length_law = "lean";
  style.hatch.length_min = 0;
  int near_pole = 0;
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  // From above: the direction z stands on the middle of the picture.
  for (const Path& path : law_strokes(draw_laws(law_ball(), style, "top"))) {
    const Vec3 p = path.points3[path.points3.size() / 2];
    const double lean = std::hypot(p.x, p.y) / 10;
    if (lean > 0.9) continue;  // cut at the outline
    // 4/3 of the length at the most, and a last step.
    EXPECT_LE(length_of(path), 4.0 / 3 * 3 * (lean + 0.08) + 0.1);
    near_pole += lean < 0.2;
    const int bin = lean < 0.45 ? 0 : 1;
    sum[bin] += length_of(path) / std::max(lean, 0.1);
    ++count[bin];
  }
  EXPECT_GT(near_pole, 5);
  EXPECT_NEAR(sum[0] / count[0], 3, 0.35);
  EXPECT_NEAR(sum[1] / count[1], 3, 0.35);
}

TEST(StrokeLaws, PresenceIsAChanceThatFollowsTheSeed) {
  for (const char* placing : {"even", "points", "dots"}) {
    SCOPED_TRACE(placing);
    Style style = placed_style(placing);
    const auto all = static_cast<double>(law_strokes(draw_laws(law_ball(), style)).size());
    style.hatch.presence_law = "0.3";
    const auto some = law_strokes(draw_laws(law_ball(), style));
    // Four standard deviations.
    EXPECT_NEAR(static_cast<double>(some.size()), 0.3 * all, 4 * std::sqrt(0.21 * all));
    const auto again = law_strokes(draw_laws(law_ball(), style));
    ASSERT_EQ(some.size(), again.size());
    EXPECT_EQ(some.front().points3, again.front().points3);
    style.hatch.presence_law = "0";
    EXPECT_TRUE(law_strokes(draw_laws(law_ball(), style)).empty());
  }
}

TEST(StrokeLaws, ARandomWidthIsUniformAndOneAStroke) {
  Style style = placed_style("points");
  const auto plain = law_strokes(draw_laws(law_ball(), style));
  style.hatch.width_law = "random";
  const auto random = law_strokes(draw_laws(law_ball(), style));
  ASSERT_EQ(plain.size(), random.size());
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double by = random[i].width.front() / plain[i].width.front();
    sum += by;
    squares += by * by;
  }
  const auto n = static_cast<double>(plain.size());
  EXPECT_NEAR(sum / n, 1.0 / 2, 4 * std::sqrt(1 / (12 * n)));
  EXPECT_NEAR(squares / n, 1.0 / 3, 4 * std::sqrt(4 / (45 * n)));
}

TEST(StrokeLaws, KnowUAndVOfPatches) {
  Scene scene;
  scene.parts.push_back({"horn", "horn",
                         std::make_shared<ParametricForm>(std::vector<std::shared_ptr<const Chart>>{
                             make_nurbs_chart(test::horn_nurbs())})});
  Style style = placed_style("points");
  style.hatch.density_law = "0.5 - v";
  const Drawing drawing = draw_laws(scene, style, "iso");
  const auto strokes = law_strokes(drawing);
  ASSERT_GT(strokes.size(), 50u);
  for (const Path& path : strokes) {
    for (const Vec3& p : path.points3) {
      double nearest = std::numeric_limits<double>::infinity(), at = 0;
      for (double t = 0; t <= 1; t += 0.002) {
        const test::HornSection s = test::horn_section({}, t);
        const double off = std::abs(glm::distance(p, s.center) - s.radius) +
                           std::abs(glm::dot(p - s.center, glm::cross(s.normal, s.binormal)));
        if (off < nearest) {
          nearest = off;
          at = t;
        }
      }
      EXPECT_LT(at, 0.5 + 0.01);
    }
  }
  EXPECT_TRUE(drawing.diagnostics.entries().empty());
}

TEST(StrokeLaws, APartWithoutUAndVSaysSo) {
  Style style = placed_style("even");
  const auto plain = law_strokes(draw_laws(law_ball(), style));
  style.hatch.width_law = "u";
  const Drawing drawing = draw_laws(law_ball(), style);
  int reported = 0;
  for (const auto& entry : drawing.diagnostics.entries()) {
    reported +=
        entry.code == "strokes.no_parameters" && entry.message.find("'ball'") != std::string::npos;
  }
  EXPECT_EQ(reported, 1);
  EXPECT_EQ(law_strokes(drawing).size(), plain.size());
}

TEST(StrokeLaws, ThatAreNoneAreRefusedByTheirKeyInOneLine) {
  const auto refused = [](const char* key, const std::string& law) {
    Style style = placed_style("points");
    try {
      set_style_key(style, key, law);
      draw_laws(law_ball(), style);
    } catch (const UsageError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      return std::string(e.what());
    }
    return std::string("it was drawn");
  };
  const auto expect = [&](const char* key, const std::string& law, const char* part) {
    const std::string reported = refused(key, law);
    EXPECT_NE(reported.find(key), std::string::npos) << reported;
    EXPECT_NE(reported.find(part), std::string::npos) << reported;
  };
  for (const char* name : {"ink", "density", "width", "length", "presence"}) {
    const std::string key = std::string("hatch.") + name + "_law";
    expect(key.c_str(), "", "expected");
    expect(key.c_str(), "1 +", "column 4");
    expect(key.c_str(), "sqrt(-1)", "no finite number");
    expect(key.c_str(), "1 / 0", "no finite number");
    expect(key.c_str(), std::string(5000, '1'), "longer");
  }
  expect("hatch.density_law", "random", "unknown name 'random'");
  expect("hatch.length_law", "t", "unknown name 't'");
  expect("strokes.2.width_law", "t +", "column 4");
  expect("strokes.2.width_law", "log(-1)", "no finite number");
}

TEST(StrokeLaws, KnowAPictureByItsLightness) {
  const Scene scene = sheet_scene();
  // Black where u is under a half; u runs along x.
  std::vector<float> pixels(100, 1.0f);
  std::fill(pixels.begin(), pixels.begin() + 50, 0.0f);
  RunContext context;
  const NamedView v = named_view("front");
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = v.direction, .up = v.up, .paper = {90, 90}});
  Style style = placed_style("discs");
  style.hatch.length = 1;
  style.hatch.length_min = 0;
  style.hatch.image = "halves";
  style.hatch.ink_law = "0.5 * (1 - image(u, v))";
  IllustrateOptions options;
  try {
    illustrate(scene, camera, style, options, context);
    FAIL() << "the picture was not there";
  } catch (const UsageError& e) {
    EXPECT_EQ(std::string(e.what()), "style key 'hatch.image': no picture 'halves' was read");
  }
  options.images["halves"] = std::make_shared<const Image>(Image{100, 1, pixels});
  const auto strokes = law_strokes(illustrate(scene, camera, style, options, context));
  ASSERT_GT(strokes.size(), 100U);
  for (const Path& path : strokes) {
    // Over half a pixel it fades, at the right border too, where it begins anew.
    const double x = 0.5 * (path.points3.front().x + path.points3.back().x);
    EXPECT_TRUE(x < 0.3 || x > 19.7) << x;
  }
  style.hatch.image = "none";
  try {
    illustrate(scene, camera, style, options, context);
    FAIL() << "it was drawn";
  } catch (const UsageError& e) {
    EXPECT_EQ(std::string(e.what()),
              "style key 'hatch.ink_law': image(u, v) asks for a picture; name one by hatch.image");
  }
}

}  // namespace
}  // namespace burin
