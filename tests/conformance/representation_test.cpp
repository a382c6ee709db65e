/// The same shape as mesh, as rational surfaces and as the zero set of a function draws the same.

#include <burin/drawing/one_line.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>

#include "forms.h"

#include <burin_test/exact.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using test::line_angle;

struct Made {
  std::string name;
  std::shared_ptr<const Form> form;
  /// Its frames are exact.
  bool exact = true;
};

struct Shape {
  std::string name;
  /// Share of the lines of a mesh that may lie more than 0.03 mm off, and how far.
  double loose = 0, farthest = 0.03;
  std::function<std::vector<Made>()> forms;
};

void PrintTo(const Shape& s, std::ostream* out) { *out << s.name; }

std::shared_ptr<const Chart> stretched(NurbsData data, Vec3 by, Vec3 moved = Vec3(0)) {
  for (Vec3& p : data.points) p = by * p + moved;
  return make_nurbs_chart(std::move(data));
}

/// A closed cylinder about z: wall and two discs.
std::vector<std::shared_ptr<const Chart>> cylinder_patches(double radius, double height) {
  const double h = 0.5 * height;
  const auto disc = [&](Vec2 from, Vec2 to) {
    return make_nurbs_chart(test::revolve({{from, to}, {1, 1}, {0, 0, 1, 1}}, 1));
  };
  return {stretched(test::cone_nurbs(radius, radius, height), Vec3(1), {0, 0, -h}),
          disc({0, -h}, {radius, -h}), disc({radius, h}, {0, h})};
}

/// The implicit form, and its own proxy as a mesh.
std::vector<Made> implicit_and_mesh(const Expression& f, double tolerance) {
  auto form = test::implicit_form(f);
  RunContext context;
  TriMesh mesh = form->realise({.tolerance = tolerance}, context)->proxy().mesh;
  return {{"Implicit", form}, {"Mesh", test::mesh_form(std::move(mesh)), false}};
}

std::vector<Shape> shapes() {
  return {
      {"Torus", 0, 0.03,
       [] {
         return std::vector<Made>{
             {"Implicit", test::implicit_form(implicit::torus(3, 1))},
             {"Nurbs", test::parametric_form({make_nurbs_chart(test::torus_nurbs(3, 1))})},
             {"Mesh", test::mesh_form(test::torus(3, 1, 360, 180)), false}};
       }},
      {"Ellipsoid", 0, 0.03,
       [] {
         const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();
         auto made = implicit_and_mesh(x * x / 9 + y * y / 4 + z * z - 1, 0.0005);
         made.push_back(
             {"Nurbs", test::parametric_form({stretched(test::sphere_nurbs(1), {3, 2, 1})})});
         return made;
       }},
      {"Cylinder", 0, 0.03,
       [] {
         return std::vector<Made>{
             {"Implicit", test::implicit_form(implicit::cylinder(2, 5))},
             {"Nurbs", test::parametric_form(cylinder_patches(2, 5))},
             {"Mesh",
              test::mesh_form(test::mapped(test::cylinder(2, 5, 480),
                                           [](Vec3 p) { return p - Vec3(0, 0, 2.5); })),
              false}};
       }},
      // Where a fillet begins the curvature jumps. Where a contour passes there nearly along the
      // view, a thousandth of a radian of a mesh's normals moves it by tenths of a millimetre.
      {"Blend", 0.02, 0.5, [] { return implicit_and_mesh(test::implicit_blend(), 0.0006); }},
  };
}

Camera camera(Vec3 direction) {
  ViewOptions view;
  view.direction = direction;
  view.scale = 16;
  view.center = Vec3(0);
  view.paper = {200, 150};
  return Camera::fit([](const Mat3&) { return Box3{Vec3(-4), Vec3(4)}; }, view);
}

/// Feature lines, hidden ones too: where a line is hidden differs by how long it takes two lines to
/// part by the tolerance.
using Lines = std::vector<std::vector<Vec2>>;
struct Picture {
  Lines all;
  double visible = 0;  // mm
};

Picture features(const std::shared_ptr<const Form>& form, const Camera& eye) {
  Scene scene;
  scene.parts.push_back({"shape", "", form});
  RunContext context;
  const Drawing drawing =
      illustrate(scene, eye, builtin_style("outline"), {.hidden = HiddenLines::Dashed}, context);
  Picture out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind != LineClass::Contour && path.kind != LineClass::Crease) continue;
      out.all.push_back(path.points);
      if (path.closed) out.all.back().push_back(path.points.front());
      for (std::size_t i = 0; path.visible && i + 1 < out.all.back().size(); ++i) {
        out.visible += glm::distance(out.all.back()[i], out.all.back()[i + 1]);
      }
    }
  }
  return out;
}

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double dd = glm::dot(d, d);
  const double s = dd > 0 ? std::clamp(glm::dot(p - a, d) / dd, 0.0, 1.0) : 0;
  return glm::distance(p, a + s * d);
}

/// The farthest that a point of `of` lies from `from`, looked at every 0.2 mm, and the share of
/// points farther than 0.03 mm.
struct Gap {
  double farthest = 0, loose = 0;
  Vec2 where{0};
};
Gap gap(const Lines& of, const Lines& from) {
  Gap out;
  double points = 0;
  for (const auto& line : of) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double length = glm::distance(line[i], line[i + 1]);
      const int n = std::max(1, static_cast<int>(length / 0.2));
      for (int k = 0; k <= n; ++k) {
        const Vec2 p = line[i] + (static_cast<double>(k) / n) * (line[i + 1] - line[i]);
        double nearest = 1e9;
        for (const auto& other : from) {
          for (std::size_t j = 0; j + 1 < other.size() && nearest > 1e-3; ++j) {
            nearest = std::min(nearest, distance(p, other[j], other[j + 1]));
          }
        }
        ++points;
        out.loose += nearest > 0.03;
        if (nearest > out.farthest) {
          out.farthest = nearest;
          out.where = p;
        }
      }
    }
  }
  out.loose /= points;
  return out;
}

/// The point of another form nearest to p, over its proxy.
SurfacePoint nearest(const Surface& surface, Vec3 p) {
  const ProxyMesh& proxy = surface.proxy();
  ProxyPoint best;
  double least = 1e9;
  for (std::uint32_t t = 0; t < proxy.wedges.size(); ++t) {
    const Triangle& tri = proxy.mesh.triangles[t];
    const Vec3 a = proxy.mesh.positions[tri[0]], u = proxy.mesh.positions[tri[1]] - a,
               v = proxy.mesh.positions[tri[2]] - a;
    if (glm::distance(p, a) > glm::length(u) + glm::length(v) + least) continue;
    const Vec3 n = glm::cross(u, v), w = p - a;
    const double nn = glm::dot(n, n);
    if (!(nn > 0)) continue;
    Vec3 bary;
    bary.y = glm::dot(glm::cross(w, v), n) / nn;
    bary.z = glm::dot(glm::cross(u, w), n) / nn;
    bary.x = 1 - bary.y - bary.z;
    bary = glm::max(bary, Vec3(0));
    bary /= bary.x + bary.y + bary.z;
    const double d = glm::distance(p, proxy.position(t, bary));
    if (d >= least) continue;
    least = d;
    best = {t, bary};
  }
  return surface.lift(best);
}

/// Whether the curvature jumps within `reach` of a point: a mesh smooths over that.
bool jumps(const Surface& surface, const SurfacePoint& p, const Frame& f, double reach) {
  for (int i = 0; i < 8; ++i) {
    const double a = i * test::kPi / 4;
    const MarchStep step = surface.march(p, std::cos(a) * f.d1 + std::sin(a) * f.d2, reach);
    if (step.stop != MarchStop::Completed) return true;
    const Frame g = surface.frame(step.end);
    const double change = std::abs(g.k1 - f.k1) + std::abs(g.k2 - f.k2);
    if (change > 0.2 * (std::abs(f.k1) + std::abs(f.k2))) return true;
  }
  return false;
}

class Representation : public testing::TestWithParam<Shape> {};

TEST_P(Representation, ContoursAreTheSameOnPaper) {
  const std::vector<Made> forms = GetParam().forms();
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0.3, -1, 0.5), Vec3(-1, 0.4, 0.2)}) {
    const Camera eye = camera(direction);
    const Picture exact = features(forms[0].form, eye);
    ASSERT_FALSE(exact.all.empty());
    for (std::size_t i = 1; i < forms.size(); ++i) {
      const Picture other = features(forms[i].form, eye);
      // Of lines that lie on each other one is drawn, and where they part is a matter of rounding.
      constexpr double kParted = kSameLine + 0.005, kLoose = 0.001;
      const double farthest = forms[i].exact ? kParted : std::max(kParted, GetParam().farthest),
                   loose = forms[i].exact ? kLoose : std::max(kLoose, GetParam().loose);
      for (const Gap& g : {gap(exact.all, other.all), gap(other.all, exact.all)}) {
        EXPECT_LT(g.farthest, farthest) << forms[i].name << " at " << g.where.x << "," << g.where.y;
        EXPECT_LE(g.loose, loose) << forms[i].name;
      }
      EXPECT_NEAR(other.visible / exact.visible, 1, 0.01) << forms[i].name;
    }
  }
}

TEST_P(Representation, PrincipalDirectionsAreTheSame) {
  // Directions have no meaning where the curvatures are nearly the same. Where curvature jumps,
  // between the pieces of the blend and at edges, meshes smooth over it within three of their
  // edges.
  const std::vector<Made> forms = GetParam().forms();
  RunContext context;
  const auto exact = forms[0].form->realise({.tolerance = 0.001}, context);
  for (std::size_t i = 1; i < forms.size(); ++i) {
    const auto other = forms[i].form->realise({.tolerance = 0.001}, context);
    const double most = forms[i].exact ? 0.5 : 2;
    int compared = 0, off = 0;
    double worst = 0;
    for (const SurfacePoint& p : exact->cover({.count = 300, .seed = 4}, context)) {
      const Frame a = exact->frame(p);
      if (a.umbilic || a.confidence < 0.2) continue;
      if (!forms[i].exact && jumps(*exact, p, a, 0.15)) continue;
      const Frame b = other->frame(nearest(*other, p.position));
      ++compared;
      const double angle = line_angle(a.d1, b.d1);
      worst = std::max(worst, angle);
      off += angle > most;
      if (angle > most) {
        ADD_FAILURE() << forms[i].name << ": " << angle << " degrees at " << p.position.x << ","
                      << p.position.y << "," << p.position.z << " k " << a.k1 << " " << a.k2;
      }
    }
    EXPECT_GT(compared, 100);
    EXPECT_EQ(off, 0) << forms[i].name << ": worst " << worst;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Representation, testing::ValuesIn(shapes()),
                         [](const auto& s) { return s.param.name; });

}  // namespace
}  // namespace burin
