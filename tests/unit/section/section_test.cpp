/// Forms cut open by planes: closed again, with the area that the plane runs through, and with the
/// surface of the form everywhere else.

#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/section/hatch_cuts.h>
#include <burin/section/section.h>

#include <burin_test/charts.h>
#include <burin_test/irregular.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string_view>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;

std::shared_ptr<const Form> mesh(TriMesh m) { return std::make_shared<MeshForm>(std::move(m)); }

std::shared_ptr<const Surface> realised(const std::shared_ptr<const Form>& form,
                                        Diagnostics* diagnostics = nullptr,
                                        double tolerance = 0.01) {
  RunContext context;
  return form->realise({.tolerance = tolerance, .diagnostics = diagnostics}, context);
}

bool closed(const ProxyMesh& proxy) {
  return std::ranges::all_of(proxy.topology.component_closed, [](auto c) { return c != 0; });
}

double cut_area(const ProxyMesh& proxy, std::int32_t number = 0) {
  double area = 0;
  if (proxy.cut_plane.empty()) return 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    const auto region = static_cast<std::size_t>(proxy.face_region[f]);
    if (proxy.cut_plane[region] == number) area += proxy.mesh.area(f);
  }
  return area;
}

double volume(const TriMesh& m) {
  double six = 0;
  for (const Triangle& t : m.triangles) {
    six += glm::dot(m.positions[t[0]], glm::cross(m.positions[t[1]], m.positions[t[2]]));
  }
  return six / 6;
}

TEST(Section, ABoxKeepsItsHalf) {
  const auto cut = cut_form(mesh(test::box({0, 0, 0}, {2, 3, 4})), {{1, 0, 0}, 0.5}, 7, "box");
  const auto surface = realised(cut);
  const ProxyMesh& proxy = surface->proxy();
  EXPECT_TRUE(closed(proxy));
  EXPECT_NEAR(cut_area(proxy, 7), 12, 1e-12);
  EXPECT_NEAR(volume(proxy.mesh), 6, 1e-12);
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (proxy.is_cut(f)) {
      EXPECT_LT(glm::distance(proxy.mesh.normal(f), Vec3(1, 0, 0)), 1e-12);
    }
  }
  const Box3 box = cut->bounds(Mat3(1));
  EXPECT_EQ(box.max, Vec3(0.5, 3, 4));
  EXPECT_EQ(box.min, Vec3(0));
}

TEST(Section, WhatClosesAPlaneIsOneFaceOfAMesh) {
  const TriMesh both =
      test::joined(test::box({0, 0, 0}, {2, 3, 4}), test::box({0, 5, 0}, {2, 8, 4}));
  const auto surface = realised(cut_form(mesh(both), {{1, 0, 0}, 0.5}, 1, "boxes"));
  const ProxyMesh& proxy = surface->proxy();
  std::set<std::int32_t> kept, closing;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    (proxy.is_cut(f) ? closing : kept).insert(proxy.face_source(f));
  }
  EXPECT_EQ(kept.size(), 10u);
  EXPECT_EQ(closing.size(), 1u) << "two regions, in whatever order";
  EXPECT_FALSE(kept.contains(*closing.begin()));
}

TEST(Section, CornersBesideThePlaneLieOnTheFaceThatClosesIt) {
  // A bar with a ring of corners in its middle, which stand a little before and behind the plane,
  // as rounding leaves them.
  TriMesh bar;
  const std::array<Vec2, 4> square{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  for (const double x : {-2.0, 0.0, 2.0}) {
    double off = x == 0 ? 1e-6 : 0;
    for (const Vec2& p : square) bar.positions.push_back({x + (off = -off), p.x, p.y});
  }
  for (std::uint32_t from : {0u, 4u}) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = from + k, b = from + (k + 1) % 4;
      bar.triangles.push_back({a, b, b + 4});
      bar.triangles.push_back({a, b + 4, a + 4});
    }
  }
  for (const Triangle& t : {Triangle{0, 2, 1}, {0, 3, 2}, {8, 9, 10}, {8, 10, 11}}) {
    bar.triangles.push_back(t);
  }
  ASSERT_NEAR(std::abs(volume(bar)), 4, 1e-4);
  if (volume(bar) < 0) {
    for (Triangle& t : bar.triangles) std::swap(t[1], t[2]);
  }
  const auto surface = realised(cut_form(mesh(bar), {{1, 0, 0}, 0}, 1, "bar"));
  const ProxyMesh& proxy = surface->proxy();
  std::size_t closing = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (!proxy.is_cut(f)) continue;
    ++closing;
    for (const std::uint32_t v : proxy.mesh.triangles[f]) {
      EXPECT_EQ(proxy.mesh.positions[v].x, 0);
    }
  }
  EXPECT_EQ(closing, 2u);
}

TEST(Section, AreasOfATorusAreThoseOfTheFormulas) {
  const auto torus = mesh(test::torus(10, 4, 400, 200));
  EXPECT_NEAR(cut_area(realised(cut_form(torus, {{0, 1, 0}, 0}, 0, ""))->proxy()), 2 * kPi * 16,
              0.1);
  EXPECT_NEAR(cut_area(realised(cut_form(torus, {{0, 0, 1}, 0}, 0, ""))->proxy()),
              kPi * (14 * 14 - 6 * 6), 0.5);
}

TEST(Section, ExactFormsAreCutTooAndKeepTheirEquations) {
  const auto torus = std::make_shared<ParametricForm>(std::vector{test::torus_chart(10, 4)});
  const auto surface = realised(cut_form(torus, {{0, 1, 0}, 2}, 0, "torus"));
  EXPECT_TRUE(closed(surface->proxy()));
  EXPECT_TRUE(surface->exact());
  const auto& proxy = surface->proxy();
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); f += 17) {
    if (proxy.is_cut(f)) continue;
    const SurfacePoint p = surface->lift({f, Vec3(1.0 / 3)});
    const double ring = std::hypot(p.position.x, p.position.y) - 10;
    EXPECT_NEAR(std::hypot(ring, p.position.z), 4, 1e-9);
    EXPECT_EQ(p.triangle, f);
    const ProxyPoint back = surface->to_proxy(p);
    EXPECT_LT(glm::distance(proxy.position(back.face, back.bary), p.position), 0.02);
  }
}

// Planes through vertices, along edges and in faces: the loops close all the same.
TEST(Section, LoopsCloseWhereverThePlaneLies) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const TriMesh meshes[] = {test::box({-1, -1, -1}, {1, 1, 1}), test::torus(3, 1, 24, 12),
                            test::irregular_ellipsoid({3, 2, 1}, 400), test::cylinder(2, 4, 12)};
  for (const TriMesh& coarse : meshes) {
    const auto form = mesh(coarse);
    const auto whole_surface = realised(form);
    const TriMesh& m = whole_surface->proxy().mesh;  // with its facets rounded
    for (int i = 0; i < 75; ++i) {
      const auto vertex = [&] { return m.positions[random() % m.positions.size()]; };
      Vec3 n(any(random), any(random), any(random));
      if (i % 3 == 1) n = glm::cross(vertex() - vertex(), vertex() - vertex());  // three vertices
      if (i % 3 == 2) n = m.normal(static_cast<std::uint32_t>(random() % m.triangles.size()));
      if (glm::length(n) < 1e-9) continue;
      n = glm::normalize(n);
      const double offset = glm::dot(n, vertex());
      Diagnostics said;
      const auto one = realised(cut_form(form, {n, offset}, 0, ""), &said);
      const auto other = realised(cut_form(form, {-n, -offset}, 0, ""), &said);
      for (const Diagnostic& d : said.entries()) {
        EXPECT_NE(d.code, "section.open")
            << i << ": " << n.x << "," << n.y << "," << n.z << " = " << offset;
      }
      EXPECT_TRUE(one->proxy().mesh.triangles.empty() || closed(one->proxy()));
      EXPECT_TRUE(other->proxy().mesh.triangles.empty() || closed(other->proxy()));
      const double whole = volume(m);
      EXPECT_NEAR(volume(one->proxy().mesh) + volume(other->proxy().mesh), whole, 1e-4 * whole);
    }
  }
}

TEST(Section, TwoPlanesLeaveAQuarterOfTheirOwn) {
  auto form = cut_form(mesh(test::box({0, 0, 0}, {2, 2, 2})), {{1, 0, 0}, 1}, 0, "");
  form = cut_form(form, {{0, 1, 0}, 0.5}, 1, "");
  const auto surface = realised(form);
  EXPECT_TRUE(closed(surface->proxy()));
  EXPECT_NEAR(volume(surface->proxy().mesh), 1, 1e-12);
  EXPECT_NEAR(cut_area(surface->proxy(), 0), 1, 1e-12);
  EXPECT_NEAR(cut_area(surface->proxy(), 1), 2, 1e-12);
}

TEST(Section, HollowsStayHollow) {
  TriMesh inner = test::box({1, 1, 1}, {3, 3, 3});
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  const auto form = mesh(test::joined(test::box({0, 0, 0}, {4, 4, 4}), inner));
  const auto surface = realised(cut_form(form, {{0, 0, 1}, 2}, 0, ""));
  EXPECT_TRUE(closed(surface->proxy()));
  EXPECT_NEAR(cut_area(surface->proxy()), 12, 1e-12);
}

TEST(Section, OpenFormsAreCutOpenAndItIsSaid) {
  TriMesh sheet = test::box({0, 0, 0}, {1, 1, 1});
  sheet.triangles.erase(sheet.triangles.begin());
  Diagnostics said;
  const Vec3 n = glm::normalize(Vec3(1, 1, 1));
  const auto surface = realised(cut_form(mesh(sheet), {n, 0.3 * std::sqrt(3.0)}, 0, "lid"), &said);
  EXPECT_FALSE(surface->proxy().mesh.triangles.empty());
  const auto surface2 =
      realised(cut_form(mesh(sheet), {-n, -0.3 * std::sqrt(3.0)}, 0, "lid"), &said);
  ASSERT_FALSE(said.entries().empty());
  EXPECT_EQ(said.entries()[0].code, "section.open");
  EXPECT_NE(said.entries()[0].message.find("lid"), std::string::npos);
  EXPECT_EQ(cut_area(surface2->proxy()), 0);
}

// A hole in one body of a part leaves the others closed.
TEST(Section, LoopsThatCloseAreClosedBesideOthers) {
  TriMesh lid = test::box({3, 0, 0}, {4, 1, 1});
  lid.triangles.erase(lid.triangles.begin());
  const Vec3 n = glm::normalize(Vec3(0.1, 1, 1));
  const auto form = mesh(test::joined(test::box({0, 0, 0}, {1, 1, 1}), lid));
  Diagnostics said;
  double area = 0;
  for (const double side : {1.0, -1.0}) {
    const auto surface = realised(cut_form(form, {side * n, side * 0.75}, 0, "two"), &said);
    area += cut_area(surface->proxy());
  }
  ASSERT_FALSE(said.entries().empty());
  EXPECT_EQ(said.entries()[0].code, "section.open");
  const auto alone = realised(cut_form(mesh(test::box({0, 0, 0}, {1, 1, 1})), {n, 0.75}, 0, ""));
  EXPECT_GE(area, 2 * cut_area(alone->proxy()) - 1e-9);
}

TEST(Section, PlanesThatMissLeaveAllOrNothing) {
  const auto box = mesh(test::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(realised(cut_form(box, {{0, 0, 1}, 2}, 0, ""))->proxy().mesh.triangles.size(), 12U);
  EXPECT_TRUE(realised(cut_form(box, {{0, 0, 1}, -1}, 0, ""))->proxy().mesh.triangles.empty());
  // In a face it takes nothing away and closes nothing.
  const auto touched = realised(cut_form(box, {{0, 0, 1}, 1}, 0, ""));
  EXPECT_TRUE(touched->proxy().cut_plane.empty());
}

TEST(Section, MarchesEndAtThePlane) {
  const auto ball = mesh(test::ellipsoid(Vec3(5), 120, 60));
  const Vec3 n(0, 0, 1);
  const auto surface = realised(cut_form(ball, {n, 2}, 0, ""));
  const auto& proxy = surface->proxy();
  int tried = 0, ended = 0;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); f += 31) {
    const SurfacePoint p = surface->lift({f, Vec3(1.0 / 3)});
    const MarchStep up = surface->march(p, proxy.is_cut(f) ? Vec3(1, 0, 0) : n, 30);
    ++tried;
    EXPECT_LE(glm::dot(n, up.end.position), 2 + 1e-9);
    ASSERT_LT(up.end.triangle, proxy.mesh.triangles.size());
    if (proxy.is_cut(f)) {
      EXPECT_EQ(up.stop, MarchStop::Crease);
      EXPECT_NEAR(std::hypot(up.end.position.x, up.end.position.y), std::sqrt(21.0), 0.02);
      EXPECT_NEAR(up.end.position.z, 2, 1e-12);
    } else {
      ended += up.stop == MarchStop::Crease && up.end.position.z > 1.99 ? 1 : 0;
    }
    if (proxy.is_cut(f) || p.position.z > 1.9) continue;  // its end may be nearer
    const MarchStep down = surface->march(p, Vec3(0.3, 1, 0), 0.01);
    EXPECT_EQ(down.stop, MarchStop::Completed);
    EXPECT_NEAR(down.length, 0.01, 1e-12);
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(ended, tried / 2);
}

// Hatching is all the ink of a cut: strokes of any placing stay off it.
TEST(Section, StrokesStayOffTheCut) {
  RunContext context;
  Scene scene;
  scene.parts.push_back(
      {"ball", "", cut_form(mesh(test::ellipsoid(Vec3(5), 120, 60)), {{0, -1, 0}, 0}, 0, "ball")});
  const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); },
                                    {.direction = {0.5, -1, 0.5}});
  for (const char* style : {"engraving", "stipple", "stipple by a law"}) {
    Style own = builtin_style(std::string_view(style).starts_with("stipple") ? "stipple" : style);
    if (std::string_view(style).ends_with("law")) set_style_key(own, "hatch.ink_law", "0.5");
    const Drawing drawing = illustrate(scene, camera, own, {}, context);
    std::size_t strokes = 0, hatching = 0;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        if (path.kind == LineClass::Pattern) ++hatching;
        if (path.kind != LineClass::Stroke) continue;
        ++strokes;
        // In the middle of the cut, which is seen: what is there would lie on it.
        for (const Vec3& p : path.points3) {
          EXPECT_FALSE(std::abs(p.y) < 1e-6 && std::hypot(p.x, p.z) < 4.9) << style;
        }
      }
    }
    EXPECT_GT(strokes, 20U) << style;
    EXPECT_GT(hatching, 10U) << style;
  }
}

/// The lines over cut areas of these parts, by part.
std::map<std::int32_t, std::vector<Curve3>> hatched(
    const std::vector<std::shared_ptr<const Form>>& forms, const Camera& camera,
    double magnified = 1, const std::vector<double>& ranks = {}) {
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::vector<const ProxyMesh*> proxies;
  for (const auto& form : forms) {
    surfaces.push_back(realised(form));
    proxies.push_back(&surfaces.back()->proxy());
  }
  std::map<std::int32_t, std::vector<Curve3>> out;
  for (Curve3& line : hatch_cuts(proxies, camera, RunContext(), magnified, ranks)) {
    out[line.source.part].push_back(std::move(line));
  }
  return out;
}

Camera from_front(double scale) {
  return Camera::fit(
      [](const Mat3&) {
        return Box3{{-20, -20, -20}, {20, 20, 20}};
      },
      {.direction = {0, -1, 0}, .up = {0, 0, 1}, .scale = scale});
}

double angle_of(const Curve3& line) {
  const Vec3 e = line.points[1] - line.points[0];
  return std::remainder(std::atan2(e.z, e.x) * 180 / kPi - 90, 180.0) + 90;
}

TEST(HatchedCuts, ADetailHasTheLinesOfItsView) {
  const CutPlane plane{{0, -1, 0}, 0};
  const std::vector<std::shared_ptr<const Form>> forms{
      cut_form(mesh(test::box({0, -5, 0}, {20, 5, 20})), plane, 0, ""),
      cut_form(mesh(test::box({20, -5, 0}, {30, 5, 20})), plane, 0, "")};
  // Where each line stands across its direction.
  const auto places = [](const std::vector<Curve3>& lines) {
    std::set<long> at;
    for (const Curve3& line : lines) {
      const Vec3 way = glm::normalize(line.points[1] - line.points[0]);
      const Vec3 across(-way.z, 0, way.x);
      at.insert(std::lround(1e6 * std::abs(glm::dot(across, line.points[0]))));
    }
    return at;
  };
  const auto whole = hatched(forms, from_front(1));
  for (const double times : {2.0, 5.0, 20.0}) {
    const auto detail = hatched(forms, from_front(times), times);
    for (const auto& [part, lines] : whole) {
      const std::set<long> few = places(lines), many = places(detail.at(part));
      EXPECT_TRUE(std::ranges::includes(many, few)) << part << ", " << times;
      EXPECT_NEAR(std::abs(angle_of(lines[0])), std::abs(angle_of(detail.at(part)[0])), 1e-9);
      // 1.7 and 2.4 mm apart: more than 3.5 mm on paper at 5:1 and above, halved once or more.
      if (times > 2) {
        EXPECT_GE(many.size(), 2 * few.size() - 2);
      }
    }
  }
}

TEST(HatchedCuts, KeepTheirDistanceAndTheirAngle) {
  const CutPlane plane{{0, -1, 0}, 0};
  const auto lines =
      hatched({cut_form(mesh(test::box({0, -5, 0}, {20, 5, 20})), plane, 0, "")}, from_front(1))[0];
  // 0.12 times the root of 400 mm2.
  ASSERT_GT(lines.size(), 5U);
  double length = 0;
  std::set<long> across;
  for (const Curve3& line : lines) {
    EXPECT_EQ(line.kind, LineClass::Pattern);
    EXPECT_NEAR(angle_of(line), 45, 1e-9);
    for (const Vec3& p : line.points) {
      EXPECT_NEAR(p.y, 0, 1e-12);
      EXPECT_GT(std::min(p.x, p.z), -1e-9);
      EXPECT_LT(std::max(p.x, p.z), 20 + 1e-9);
    }
    length += glm::distance(line.points[0], line.points[1]);
    const double at = (line.points[0].z - line.points[0].x) / std::sqrt(2.0) / 2.4;
    EXPECT_NEAR(at, std::round(at), 1e-9);
    across.insert(std::lround(at));
  }
  EXPECT_EQ(across.size(), lines.size());
  EXPECT_NEAR(length * 2.4, 400, 12);  // each stands for a strip
}

TEST(HatchedCuts, OfPartsThatTouchDiffer) {
  const CutPlane plane{{0, -1, 0}, 0};
  const auto box = [&](double x0, double x1) {
    return cut_form(mesh(test::box({x0, -5, 0}, {x1, 5, 10})), plane, 0, "");
  };
  auto lines = hatched({box(0, 5), box(5, 10), box(10, 15), box(17, 20)}, from_front(2));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NEAR(angle_of(lines[0][0]), 45, 1e-9);
  EXPECT_NEAR(angle_of(lines[1][0]), 135, 1e-9);
  EXPECT_NEAR(angle_of(lines[2][0]), 45, 1e-9);
  EXPECT_NEAR(angle_of(lines[3][0]), 45, 1e-9);
}

/// The least and the largest x of lines.
std::pair<double, double> reach(const std::vector<Curve3>& lines) {
  std::pair out{1e300, -1e300};
  for (const Curve3& line : lines) {
    for (const Vec3& p : line.points) {
      out = {std::min(out.first, p.x), std::max(out.second, p.x)};
    }
  }
  return out;
}

TEST(HatchedCuts, OfPartsThatOverlapOneIsHatchedThere) {
  const CutPlane plane{{0, -1, 0}, 0};
  const auto box = [&](double x0, double x1, double half) {
    return cut_form(mesh(test::box({x0, -5, -half}, {x1, 5, half})), plane, 0, "");
  };
  // They cross, and no corner of one lies in the other.
  const std::vector<std::shared_ptr<const Form>> forms{box(0, 20, 10), box(15, 30, 8)};
  const auto first = hatched(forms, from_front(2));
  EXPECT_NEAR(reach(first.at(0)).second, 20, 1e-9);
  EXPECT_NEAR(reach(first.at(1)).first, 20, 1e-9);
  EXPECT_NEAR(reach(first.at(1)).second, 30, 1e-9);
  EXPECT_NE(angle_of(first.at(0)[0]), angle_of(first.at(1)[0]));
  const auto second = hatched(forms, from_front(2), 1, {0, 1});
  for (const Curve3& line : second.at(0)) {
    const Vec3 middle = 0.5 * (line.points[0] + line.points[1]);
    EXPECT_FALSE(middle.x > 15 && std::abs(middle.z) < 8);
  }
  EXPECT_NEAR(reach(second.at(1)).first, 15, 1e-9);
  // One within the other, far from its outline.
  const auto inner = hatched({box(0, 30, 15), box(10, 20, 5)}, from_front(1));
  EXPECT_FALSE(inner.contains(1));
  const auto filled = hatched({box(0, 30, 15), box(10, 20, 5)}, from_front(1), 1, {0, 1});
  EXPECT_NE(angle_of(filled.at(0)[0]), angle_of(filled.at(1)[0]));
  for (const Curve3& line : filled.at(0)) {
    const Vec3 middle = 0.5 * (line.points[0] + line.points[1]);
    EXPECT_FALSE(middle.x > 10 && middle.x < 20 && std::abs(middle.z) < 5);
  }
}

TEST(HatchedCuts, EndAtNoWallThatThePlaneCuts) {
  const CutPlane plane{{0, -1, 0}, 0};
  Scene scene;
  // The wall at x = 19.8 crosses lines of the first part just before their ends.
  for (const auto& [x0, x1] : {std::pair{0.0, 20.0}, {19.8, 39.8}}) {
    scene.parts.push_back(
        {"", "", cut_form(mesh(test::box({x0, -5, -10}, {x1, 5, 10})), plane, 0, "")});
  }
  const Camera camera = from_front(3);
  std::vector<std::shared_ptr<const Form>> forms;
  for (const Part& part : scene.parts) forms.push_back(part.form);
  std::map<std::int32_t, double> length, drawn;
  for (const auto& [part, lines] : hatched(forms, camera)) {
    for (const Curve3& line : lines) {
      length[part] += glm::distance(line.points[0], line.points[1]);
    }
  }
  RunContext context;
  const Drawing drawing = illustrate(scene, camera, builtin_style("outline"), {}, context);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Pattern) continue;
      drawn[path.source.part] += glm::distance(path.points3.front(), path.points3.back());
    }
  }
  EXPECT_NEAR(drawn[0], length[0], 1e-3 * length[0]);
  EXPECT_NEAR(drawn[1], length[1], 1e-3 * length[1]);
}

TEST(HatchedCuts, AreNotParallelToTheOutline) {
  // A square on its corner has its sides along 45 and 135 degrees.
  const double s = std::sqrt(0.5);
  TriMesh m = test::mapped(test::box({-5, -5, -5}, {5, 5, 5}),
                           [&](Vec3 p) { return Vec3(s * (p.x - p.z), p.y, s * (p.x + p.z)); });
  const auto square = hatched({cut_form(mesh(m), {{0, -1, 0}, 0}, 0, "")}, from_front(1))[0];
  ASSERT_FALSE(square.empty());
  // Half of it lies along either: no more than half is allowed.
  EXPECT_NEAR(angle_of(square[0]), 45, 1e-9);
  m = test::mapped(test::box({-9, -5, -2}, {9, 5, 2}),
                   [&](Vec3 p) { return Vec3(s * (p.x - p.z), p.y, s * (p.x + p.z)); });
  const auto bar = hatched({cut_form(mesh(m), {{0, -1, 0}, 0}, 0, "")}, from_front(1))[0];
  ASSERT_FALSE(bar.empty());
  EXPECT_NEAR(angle_of(bar[0]), 135, 1e-9);
}

/// How far from an x the nearest ends of lines lie to its left and to its right.
std::pair<double, double> nearest_beside(const std::vector<Curve3>& lines, double x) {
  double left = -1e300, right = 1e300;
  for (const Curve3& line : lines) {
    for (const Vec3& p : line.points) {
      if (p.x < x) left = std::max(left, p.x);
      if (p.x > x) right = std::min(right, p.x);
    }
  }
  return {x - left, right - x};
}

TEST(HatchedCuts, AreFilledWhereTheyAreNarrow) {
  const CutPlane plane{{0, -1, 0}, 0};
  const auto box = [&](double x0, double x1, double z1) {
    return cut_form(mesh(test::box({x0, -5, 0}, {x1, 5, z1})), plane, 0, "");
  };
  // 0.9 mm wide on paper, then 1.1.
  auto narrow = hatched({box(0, 0.9, 12)}, from_front(1))[0];
  EXPECT_NEAR(static_cast<double>(narrow.size()), 9, 1);
  for (const Curve3& line : narrow) {
    EXPECT_EQ(line.kind, LineClass::Pattern);
    EXPECT_NEAR(std::abs(line.points[1].z - line.points[0].z), 12, 1e-9);
    EXPECT_NEAR(line.points[1].x, line.points[0].x, 1e-9);
  }
  const auto wide = hatched({box(0, 1.1, 12)}, from_front(1))[0];
  ASSERT_FALSE(wide.empty());
  EXPECT_NEAR(angle_of(wide[0]), 45, 1e-9);
  // What is narrow here is wide at another scale.
  EXPECT_NEAR(angle_of(hatched({box(0, 0.9, 12)}, from_front(2))[0][0]), 45, 1e-9);
  // A part with both keeps its hatching where it is wide.
  const auto both = hatched({cut_form(mesh(test::joined(test::box({0, -5, 0}, {0.9, 5, 12}),
                                                        test::box({5, -5, 0}, {15, 5, 12}))),
                                      plane, 0, "")},
                            from_front(1))[0];
  const auto upright = std::ranges::count_if(both, [](const Curve3& line) {
    return std::abs(line.points[1].x - line.points[0].x) < 1e-9;
  });
  EXPECT_NEAR(static_cast<double>(upright), 9, 1);
  EXPECT_GT(both.size(), 12U);
  // A round one: its lines fill it.
  const auto disc = hatched({cut_form(mesh(test::cylinder(0.45, 10, 48)), {{0, 0, 1}, 5}, 0, "")},
                            Camera::fit(
                                [](const Mat3&) {
                                  return Box3{{-20, -20, -20}, {20, 20, 20}};
                                },
                                {.direction = {0, 0, 1}, .up = {0, 1, 0}, .scale = 1}))[0];
  double length = 0;
  for (const Curve3& line : disc) length += glm::distance(line.points[0], line.points[1]);
  EXPECT_NEAR(0.1 * length, kPi * 0.45 * 0.45, 0.05);
}

TEST(HatchedCuts, StayWhiteBetweenNarrowNeighbours) {
  const CutPlane plane{{0, -1, 0}, 0};
  const auto box = [&](double x0, double x1) {
    return cut_form(mesh(test::box({x0, -5, 0}, {x1, 5, 12})), plane, 0, "");
  };
  auto lines = hatched({box(0, 0.95), box(0.95, 1.85), box(5, 5.9)}, from_front(1));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_GE(nearest_beside(lines[0], 0.95).first, 0.35 - 1e-9);
  EXPECT_LE(nearest_beside(lines[0], 0.95).first, 0.46);
  EXPECT_GE(nearest_beside(lines[1], 0.95).second, 0.35 - 1e-9);
  EXPECT_LE(nearest_beside(lines[1], 0.95).second, 0.46);
  EXPECT_LE(nearest_beside(lines[2], 5).second, 0.11);  // nobody beside it
}

TEST(HatchedCuts, OfTwoPlanesOfAPartFoldOntoEachOther) {
  const CutRegion region{{{1, 0, 0}, 0}, {{0, -1, 0}, 0}};
  const Camera iso = Camera::fit(
      [](const Mat3&) {
        return Box3{{-20, -20, -20}, {20, 20, 20}};
      },
      {.direction = {1, -1, 1}, .up = {0, 0, 1}, .scale = 1});
  const auto lines =
      hatched({cut_form(mesh(test::box({-10, -10, 0}, {10, 10, 10})), region, 0, "")}, iso)[0];
  std::set<int> slopes[2];
  for (const Curve3& line : lines) {
    const Vec3 e = line.points[1] - line.points[0];
    const bool across_x = std::abs(e.x) < 1e-9;
    // Away from the edge where they meet is -y in the one, +x in the other.
    slopes[across_x ? 0 : 1].insert((across_x ? -e.y : e.x) * e.z > 0 ? 1 : -1);
  }
  ASSERT_EQ(slopes[0].size(), 1U);
  EXPECT_EQ(slopes[0], slopes[1]);
  // None in a plane that is seen edge-on.
  const auto from_there = hatched(
      {cut_form(mesh(test::box({-10, -10, 0}, {10, 10, 10})), region, 0, "")}, from_front(1))[0];
  EXPECT_FALSE(from_there.empty());
  for (const Curve3& line : from_there) {
    EXPECT_NEAR(line.points[0].y, 0, 1e-9);
    EXPECT_NEAR(line.points[1].y, 0, 1e-9);
  }
}

}  // namespace
}  // namespace burin
