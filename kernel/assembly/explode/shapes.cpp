#include "shapes.h"

#include <burin/assembly/select.h>
#include <burin/assembly/things.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/surface/empty_surface.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace burin::detail {
namespace {

// Chord tolerance as a share of the assembly's diagonal: holes and shafts that fit stay apart by
// more than it in what is seen as one product.
constexpr double kTolerance = 5e-4;
constexpr double kMerge = 2 * 3.14159265358979323846 / 180;  // radians
// Directions whose weight is looked at for the axes of the assembly.
constexpr std::size_t kMostFaces = 2000;

Vec3 normal_of(const TriMesh& mesh, const Triangle& t, double& area) {
  const Vec3 n = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                            mesh.positions[t[2]] - mesh.positions[t[0]]);
  const double length = glm::length(n);
  area = 0.5 * length;
  return length > 0 ? n / length : Vec3(0);
}

Signature signature_of(const TriMesh& mesh) {
  Signature s;
  Vec3 middle(0);
  for (const Triangle& t : mesh.triangles) {
    double area = 0;
    normal_of(mesh, t, area);
    s.area += area;
    middle += area / 3 * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
  }
  if (s.area > 0) middle /= s.area;
  for (const Triangle& t : mesh.triangles) {
    double area = 0;
    normal_of(mesh, t, area);
    const Vec3 a = mesh.positions[t[0]] - middle, b = mesh.positions[t[1]] - middle,
               c = mesh.positions[t[2]] - middle;
    s.volume += glm::dot(a, glm::cross(b, c)) / 6;
    s.spread += area * (glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c)) / 3;
  }
  return s;
}

// Axes of the faces of a part.
std::vector<WeightedAxis> face_axes(const ProxyMesh& proxy) {
  std::map<std::int32_t, NormalSum> faces;
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    double area = 0;
    const Vec3 n = normal_of(proxy.mesh, proxy.mesh.triangles[f], area);
    if (area > 0) faces[proxy.face_source(f)].add(n, area);
  }
  std::vector<WeightedAxis> axes;
  for (const auto& [face, sum] : faces) {
    const Vec3 axis = sum.axis();
    if (axis != Vec3(0)) axes.push_back({axis, sum.weight});
  }
  return axes;
}

// A direction that rounding alone keeps from an axis of the model is that axis.
Vec3 cleaned(Vec3 v) {
  constexpr double kRounding = 1e-6;  // radians
  for (int k = 0; k < 3; ++k) {
    if (std::abs(v[k]) < kRounding) v[k] = 0;
  }
  return glm::normalize(v);
}

// Which of both ways is ahead: that of the middle of all faces, or by the model's axes.
Vec3 ahead(Vec3 axis, Vec3 lean, double diagonal) {
  constexpr double kEven = 1e-6;
  double way = glm::dot(axis, lean);
  if (std::abs(way) < kEven * diagonal) {
    way = 0;
    for (int k = 2; k >= 0 && std::abs(way) < kEven; --k) way = axis[k];
  }
  return way < 0 ? -axis : axis;
}

Mat3 frame_of(const Shapes& shapes) {
  std::vector<WeightedAxis> axes;
  double area = 0;
  Box3 box;
  Vec3 middle(0);
  for (const std::size_t part : shapes.parts) {
    const ProxyMesh& proxy = *shapes.proxies[part];
    for (const WeightedAxis& axis : face_axes(proxy)) axes.push_back(axis);
    area += shapes.signatures[part].area;
    const Box3 one = proxy.mesh.bounds();
    box.add(one);
    middle += shapes.signatures[part].area * one.center();
  }
  axes = merged_axes(std::move(axes));
  // Bodies without any flat or round faces to speak of have the model's axes.
  constexpr double kSpeaks = 0.05;
  if (axes.empty() || !(axes.front().weight > kSpeaks * area)) return Mat3(1);
  const Vec3 lean = middle / area - box.center();
  const Vec3 first = ahead(cleaned(axes.front().axis), lean, box.diagonal());
  Vec3 second(0);
  for (const WeightedAxis& axis : axes) {
    if (std::abs(glm::dot(axis.axis, first)) > std::sin(kMerge)) continue;
    second = cleaned(glm::normalize(reject(axis.axis, first)));
    break;
  }
  if (second == Vec3(0)) second = any_orthogonal(first);
  second = ahead(second, lean, box.diagonal());
  return {first, second, glm::cross(first, second)};
}

}  // namespace

Signature& Signature::operator+=(const Signature& other) {
  area += other.area;
  volume += other.volume;
  spread += other.spread;
  return *this;
}

bool Signature::same(const Signature& other) const {
  // Copies that a CAD system turned; tessellations of one shape are the same to rounding.
  constexpr double kSame = 1e-3;
  const auto near = [](double a, double b) {
    return std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b));
  };
  return near(area, other.area) && near(volume, other.volume) && near(spread, other.spread);
}

double Shapes::least_extent(std::size_t part) const {
  const Vec3 size = boxes[part].size();
  return std::min({size.x, size.y, size.z});
}

Box3 Shapes::box_along(std::size_t part, const Mat3& rows) const {
  Box3 box;
  for (const Vec3& p : proxies[part]->mesh.positions) box.add(in_rows(rows, p));
  return box;
}

Shapes make_shapes(const Scene& scene, const std::vector<bool>& drawn, RunContext& context) {
  Shapes shapes;
  shapes.things = things_of(scene);
  Box3 all;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (drawn[i]) all.add(scene.parts[i].form->bounds(Mat3(1)));
  }
  RealiseOptions realise;
  realise.tolerance = std::max(kTolerance * all.diagonal(), 1e-12);
  realise.curvature = false;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Part& part = scene.parts[i];
    context.check();
    shapes.paths.push_back(path_of(part));
    shapes.names.push_back(part.assembly);
    shapes.surfaces.push_back(empty_surface());
    if (!drawn[i]) continue;
    try {
      const auto surface = part.form->realise(realise, context);
      if (surface->proxy().mesh.triangles.empty()) continue;
      shapes.surfaces.back() = surface;
      shapes.parts.push_back(i);
    } catch (const GeometryError&) {
      continue;  // drawing it says why
    }
  }
  context.end_stage();
  for (const auto& surface : shapes.surfaces) shapes.proxies.push_back(&surface->proxy());
  shapes.signatures.resize(scene.parts.size());
  shapes.boxes.resize(scene.parts.size());
  const auto each = [&](const std::function<void(std::size_t)>& body) {
    parallel_for(
        shapes.parts.size(), 1,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) body(shapes.parts[i]);
        },
        &context);
  };
  each([&](std::size_t p) { shapes.signatures[p] = signature_of(shapes.proxies[p]->mesh); });
  shapes.frame = frame_of(shapes);
  each([&](std::size_t p) { shapes.boxes[p] = shapes.box_along(p, shapes.frame); });
  Box3 box;
  for (const std::size_t p : shapes.parts) box.add(shapes.boxes[p]);
  shapes.diagonal = box.diagonal();
  return shapes;
}

void NormalSum::add(Vec3 unit_normal, double w) {
  weight += w;
  sum += w * unit_normal;
  outer += w * glm::outerProduct(unit_normal, unit_normal);
}

bool NormalSum::planar() const {
  constexpr double kFlat = 0.9999;  // of the cosine, 0.8 degrees
  return weight > 0 && glm::length(sum) > kFlat * weight;
}

Vec3 NormalSum::axis() const {
  if (!(weight > 0)) return Vec3(0);
  if (planar()) return glm::normalize(sum);
  const Vec3 mean = sum / weight;
  const Mat3 spread = outer / weight - glm::outerProduct(mean, mean);
  Eigen::Matrix3d m;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) m(r, c) = spread[c][r];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  // Normals of cylinders and cones lie on a circle: they spread in a plane across the axis.
  constexpr double kRound = 1e-3, kBends = 1e-2;
  if (!(solver.eigenvalues()[0] < kRound && solver.eigenvalues()[1] > kBends)) return Vec3(0);
  const Eigen::Vector3d e = solver.eigenvectors().col(0);
  return {e[0], e[1], e[2]};
}

bool same_axis(Vec3 a, Vec3 b) { return std::abs(glm::dot(a, b)) > std::cos(kMerge); }

std::vector<WeightedAxis> merged_axes(std::vector<WeightedAxis> axes) {
  const auto heavier = [](const WeightedAxis& a, const WeightedAxis& b) {
    return a.weight > b.weight;
  };
  std::ranges::stable_sort(axes, heavier);
  if (axes.size() > kMostFaces) axes.resize(kMostFaces);
  std::vector<WeightedAxis> merged;
  for (const WeightedAxis& axis : axes) {
    const auto found =
        std::ranges::find_if(merged, [&](const auto& m) { return same_axis(m.axis, axis.axis); });
    if (found == merged.end()) {
      merged.push_back(axis);
    } else {
      found->weight += axis.weight;
    }
  }
  std::ranges::stable_sort(merged, heavier);
  return merged;
}

Mat3 rows_along(Vec3 axis, const Mat3& frame) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(glm::dot(frame[k], axis)) < std::abs(glm::dot(frame[least], axis)) - 1e-9) {
      least = k;
    }
  }
  const Vec3 u = glm::normalize(reject(frame[least], axis));
  return {u, glm::cross(axis, u), axis};
}

}  // namespace burin::detail
