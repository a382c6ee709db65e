#include <burin/surface/scene.h>
#include <burin/surface/shape_measure.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>

namespace burin {
namespace {

/// Share of a form's size that the triangles may be off by which it is measured.
constexpr double kMeasured = 1e-3;

/// Below it, shapes are their own mirror images but for rounding.
constexpr double kHanded = 1e-6;
/// Share of the size from which on the way between two middles has a direction.
constexpr double kApart = 1e-5;

bool alike(double a, double b, double allowed) { return std::abs(a - b) <= allowed; }

}  // namespace

bool Definition::same(const Definition& other) const {
  constexpr double kRounding = 2e-9;  // 1e-9 of a scale
  if (shape != other.shape || mirrored() != other.mirrored()) return false;
  const Mat3 a = metric(), b = other.metric();
  const double size = std::max({a[0][0], a[1][1], a[2][2]});
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!alike(a[i][k], b[i][k], kRounding * size)) return false;
    }
  }
  return true;
}

bool ShapeMeasure::handed() const { return std::abs(handedness) > kHanded; }

bool ShapeMeasure::same(const ShapeMeasure& other, double relative) const {
  if (faces != other.faces || edges != other.edges) return false;
  if (handed() && other.handed() && (handedness > 0) != (other.handedness > 0)) return false;
  const double size = std::max(area, other.area);
  const double spread = std::max(moments.z, other.moments.z);
  return alike(area, other.area, relative * size) &&
         alike(volume, other.volume, relative * std::pow(size, 1.5)) &&
         alike(moments.x, other.moments.x, relative * spread) &&
         alike(moments.y, other.moments.y, relative * spread) &&
         alike(moments.z, other.moments.z, relative * spread);
}

ShapeMeasure ShapeMeasure::scaled(double scale, bool mirrored) const {
  ShapeMeasure m = *this;
  m.area *= scale * scale;
  m.volume *= scale * scale * scale;
  m.moments *= scale * scale * scale * scale;
  if (mirrored) m.handedness = -m.handedness;
  return m;
}

ShapeMeasure shape_measure(double area, Vec3 area_middle, const Mat3& second_moments, double volume,
                           Vec3 volume_middle) {
  ShapeMeasure m;
  m.area = area;
  m.volume = volume;
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) matrix(i, k) = second_moments[k][i];
  }
  const Eigen::Vector3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  m.moments = {axes(0), axes(1), axes(2)};
  const double trace = axes.sum();
  if (volume == 0 || !(area > 0) || !(trace > 0)) return m;
  const Vec3 way = area_middle - volume_middle;
  if (glm::length(way) < kApart * std::sqrt(trace / area)) return m;
  const Mat3 unit = second_moments / trace;
  const Vec3 v = glm::normalize(way);
  m.handedness = glm::determinant(Mat3(v, unit * v, unit * (unit * v)));
  return m;
}

ShapeMeasure shape_measure(const ProxyMesh& proxy) {
  const TriMesh& mesh = proxy.mesh;
  if (mesh.triangles.empty()) return {};
  const auto corners = [&](const Triangle& t, Vec3 o) {
    return std::array<Vec3, 3>{mesh.positions[t[0]] - o, mesh.positions[t[1]] - o,
                               mesh.positions[t[2]] - o};
  };
  // About a point of the shape: far from the origin nothing is lost.
  const Vec3 about = mesh.positions[mesh.triangles.front()[0]];
  double area = 0, volume = 0;
  Vec3 middle(0), body(0);
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = corners(t, about);
    const double piece = 0.5 * glm::length(glm::cross(b - a, c - a));
    const double cone = glm::dot(a, glm::cross(b, c)) / 6;
    area += piece, volume += cone;
    middle += piece / 3 * (a + b + c);
    body += cone / 4 * (a + b + c);
  }
  if (!(area > 0)) return {};
  middle /= area;
  Mat3 second(0);
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = corners(t, about + middle);
    const double piece = 0.5 * glm::length(glm::cross(b - a, c - a));
    const Vec3 sum = a + b + c;
    for (const Vec3& p : {a, b, c, sum}) second += piece / 12 * glm::outerProduct(p, p);
  }
  const auto& closed = proxy.topology.component_closed;
  const bool is_closed = std::ranges::all_of(closed, [](auto c) { return c != 0; });
  if (!is_closed) volume = 0;
  ShapeMeasure m =
      shape_measure(area, middle, second, volume, volume != 0 ? body / volume : Vec3(0));
  m.faces = proxy.source_face.empty()
                ? proxy.region_count
                : std::ssize(std::set(proxy.source_face.begin(), proxy.source_face.end()));
  std::set<std::int32_t> edges(proxy.source_edge.begin(), proxy.source_edge.end());
  edges.erase(-1);
  m.edges = std::ssize(edges);
  return m;
}

ShapeMeasure measure_realised(const Form& form, RunContext& context) {
  RealiseOptions options;
  const double size = form.bounds(Mat3(1)).diagonal();
  options.tolerance = size > 0 ? kMeasured * size : kMeasured;
  options.curvature = false;
  return shape_measure(form.realise(options, context)->proxy());
}

}  // namespace burin
