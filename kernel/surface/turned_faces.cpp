#include <burin/surface/face_samples.h>
#include <burin/surface/tangent_basis.h>
#include <burin/surface/turned_faces.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace burin {
namespace {

/// Points of a face that are asked, about.
constexpr std::size_t kPoints = 96;
/// Root mean square of how fast a motion may leave the face, over the size of the face a radian.
struct Speeds {
  /// At the most; and up to which all are as slow.
  double most, slow;
};
/// Of exact forms the slowest are rounding; those of others as large as estimates of normals are
/// off.
constexpr Speeds kExact{1e-3, 1e-6}, kEstimated{1e-2, 1e-2};
/// How much faster than the slowest another motion may leave the face and still keep it.
constexpr double kAsSlow = 10;
/// Share of a turn that a motion may advance along its axis: below it is no screw.
constexpr double kPitch = 1e-3;

using Motion = Eigen::Matrix<double, 6, 1>;  // of translation and rotation

Vec3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The motions that keep points on their surface, about `middle` and in units of `size`.
class Slippage {
 public:
  Slippage(const std::vector<SampledPoint>& samples, Vec3 middle, double size,
           const Speeds& speeds) {
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (const SampledPoint& s : samples) {
      const Vec3 turned = glm::cross((s.position - middle) / size, s.normal);
      Motion row;
      row << s.normal.x, s.normal.y, s.normal.z, turned.x, turned.y, turned.z;
      sum += row * row.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solved(
        sum / static_cast<double>(samples.size()));
    const auto speed = [&](int i) { return std::sqrt(std::max(0.0, solved.eigenvalues()[i])); };
    if (speed(0) > speeds.most) return;
    const double most = std::min(speeds.most, std::max(kAsSlow * speed(0), speeds.slow));
    for (int i = 0; i < 6 && speed(i) <= most; ++i) {
      motions_.emplace_back(solved.eigenvectors().col(i));
    }
  }

  /// The turn of a surface of revolution or a cylinder, in units of the size.
  std::optional<Axis> axis() const {
    if (motions_.empty() || motions_.size() > 2) return std::nullopt;
    // A cylinder slides along its axis, too: the rotations of both motions are one direction.
    Eigen::Matrix<double, 3, Eigen::Dynamic> turns(3, motions_.size());
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      turns.col(static_cast<Eigen::Index>(i)) = motions_[i].tail<3>();
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turns, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const auto& values = svd.singularValues();
    if (values[0] < kPitch || (motions_.size() == 2 && values[1] > kPitch * values[0])) {
      return std::nullopt;
    }
    Motion turn = Motion::Zero();
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      turn += svd.matrixV()(static_cast<Eigen::Index>(i), 0) * motions_[i];
    }
    turn /= values[0];
    const Eigen::Vector3d w = turn.tail<3>(), v = turn.head<3>();
    if (motions_.size() == 1 && std::abs(w.dot(v)) > kPitch * w.squaredNorm()) return std::nullopt;
    return Axis{vec(w.cross(v) / w.squaredNorm()), vec(w.normalized())};
  }

  /// The centre of a sphere, in units of the size.
  std::optional<Vec3> center() const {
    if (motions_.size() != 3) return std::nullopt;
    Eigen::Matrix3d turns, moves;
    for (int i = 0; i < 3; ++i) {
      turns.col(i) = motions_[static_cast<std::size_t>(i)].tail<3>();
      moves.col(i) = motions_[static_cast<std::size_t>(i)].head<3>();
    }
    // All turns of a plane are about its normal.
    if (std::abs(turns.determinant()) < kPitch * kPitch * kPitch) return std::nullopt;
    // A turn w about c moves the middle by -w x c: moves = [c]x turns.
    const Eigen::Matrix3d cross = moves * turns.inverse();
    return Vec3(cross(2, 1) - cross(1, 2), cross(0, 2) - cross(2, 0), cross(1, 0) - cross(0, 1)) *
           0.5;
  }

 private:
  std::vector<Motion> motions_;
};

void mark(double from, double to, std::bitset<360>& turn) {
  constexpr double kTurn = 2 * std::numbers::pi;
  double way = std::remainder(to - from, kTurn);
  if (way < 0) {
    from += way;
    way = -way;
  }
  const double first = from / kTurn * 360, last = (from + way) / kTurn * 360;
  for (double at = std::floor(first); at < last; ++at) {
    turn.set(static_cast<std::size_t>(static_cast<int>(at + 720) % 360));
  }
}

}  // namespace

void TurnedExtent::add(const TurnedExtent& other) {
  turn |= other.turn;
  low = std::min(low, other.low);
  high = std::max(high, other.high);
  radius = std::max(radius, other.radius);
}

TurnedExtent extent_about(const Axis& axis, const ProxyMesh& proxy,
                          std::span<const std::uint32_t> triangles) {
  TurnedExtent out;
  out.low = std::numeric_limits<double>::infinity();
  out.high = -out.low;
  const TangentBasis across(axis.along);
  for (const std::uint32_t triangle : triangles) {
    std::array<double, 3> angles{};
    std::array<double, 3> radii{};
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = proxy.mesh.positions[proxy.mesh.triangles[triangle][k]] - axis.point;
      const double height = glm::dot(p, axis.along);
      out.low = std::min(out.low, height);
      out.high = std::max(out.high, height);
      const Vec2 flat = across.coords(p);
      radii[k] = glm::length(flat);
      angles[k] = std::atan2(flat.y, flat.x);
      out.radius = std::max(out.radius, radii[k]);
    }
    const double near = 1e-6 * *std::ranges::max_element(radii);  // the axis has no angle
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (radii[k] > near && radii[next] > near) mark(angles[k], angles[next], out.turn);
    }
  }
  return out;
}

std::optional<TurnedFace> turned_face(const Surface& surface,
                                      const std::vector<std::uint32_t>& triangles) {
  const std::vector<SampledPoint> samples = face_samples(surface, triangles, kPoints);
  Vec3 middle(0);
  for (const SampledPoint& s : samples) middle += s.position / static_cast<double>(samples.size());
  double size = 0;
  for (const SampledPoint& s : samples) size = std::max(size, glm::distance(s.position, middle));
  // A strip of two triangles tells nothing.
  if (samples.size() < 3 || !(size > 0)) return std::nullopt;
  const Slippage slippage(samples, middle, size, surface.exact() ? kExact : kEstimated);
  TurnedFace out;
  if (const auto axis = slippage.axis()) {
    out.axis = {middle + size * axis->point, axis->along};
  } else if (const auto center = slippage.center()) {
    out.axis.point = middle + size * *center;
    out.sphere = true;
  } else {
    return std::nullopt;
  }
  double outward = 0;
  for (const SampledPoint& s : samples) {
    const Vec3 from_axis = out.sphere ? s.position - out.axis.point : out.axis.to(s.position);
    outward += glm::dot(from_axis, s.normal);
  }
  out.hollow = outward < 0;
  out.triangles = triangles;
  return out;
}

std::vector<TurnedFace> turned_faces(const Surface& surface, const RunContext& context) {
  std::vector<TurnedFace> out;
  for (const auto& [number, triangles] : triangles_of_faces(surface.proxy())) {
    context.check();
    if (auto face = turned_face(surface, triangles)) {
      face->face = number;
      out.push_back(std::move(*face));
    }
  }
  return out;
}

}  // namespace burin
