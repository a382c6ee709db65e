#include <burin/congruence/body.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// Moments closer than this share of the largest are one: a shape turned by its axis.
constexpr double kEqual = 1e-4;
/// Share of a shape's size within which corners may be each other's.
constexpr double kCorner = 1e-4;
constexpr std::size_t kMostCorners = 48;

/// Principal axes of a shape, with ascending moments; right-handed columns.
struct Axes {
  Mat3 axes{1};
  Vec3 moments{0};
};

Axes axes_of(const Mat3& spread) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) matrix(i, k) = spread[k][i];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Axes out;
  for (int k = 0; k < 3; ++k) {
    out.moments[k] = solver.eigenvalues()(k);
    for (int i = 0; i < 3; ++i) out.axes[k][i] = solver.eigenvectors()(i, k);
  }
  if (glm::determinant(out.axes) < 0) out.axes[2] = -out.axes[2];
  return out;
}

/// About a unit vector, by the formula of Rodrigues.
Mat3 turn_about(Vec3 axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Mat3 cross(Vec3(0, axis.z, -axis.y), Vec3(-axis.z, 0, axis.x), Vec3(axis.y, -axis.x, 0));
  return c * Mat3(1) + s * cross + (1 - c) * glm::outerProduct(axis, axis);
}

/// The least turn that takes one unit vector to another.
Mat3 turn_to(Vec3 from, Vec3 to) {
  const Vec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis), cosine = glm::dot(from, to);
  constexpr double kStraight = 1e-12;
  if (sine < kStraight)
    return cosine > 0 ? Mat3(1) : turn_about(any_orthogonal(from), std::acos(-1.0));
  return turn_about(axis / sine, std::atan2(sine, cosine));
}

double angle_of(const Mat3& turn) {
  return std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1), -1.0, 1.0));
}

/// Finds turns that may take a shape to its copy.
class Turns {
 public:
  Turns(const Body& before, const Body& after)
      : before_(before),
        after_(after),
        near_(kCorner * before.pose().box.diagonal() + before.tolerance() + after.tolerance()) {}

  std::vector<Mat3> find() {
    const Axes a = axes_of(before_.pose().spread), b = axes_of(after_.pose().spread);
    const double largest = a.moments.z;
    const bool low = a.moments.y - a.moments.x <= kEqual * largest,
               high = a.moments.z - a.moments.y <= kEqual * largest;
    if (!low && !high) {
      for (const Vec3& sign : {Vec3(1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
        const Mat3 to(sign.x * b.axes[0], sign.y * b.axes[1], sign.z * b.axes[2]);
        turns_.push_back(to * glm::transpose(a.axes));
      }
    } else if (low && high) {
      find_about_corners();
    } else {
      const int axis = low ? 2 : 0;
      for (const double sign : {1.0, -1.0}) find_about(a.axes[axis], sign * b.axes[axis]);
    }
    std::ranges::stable_sort(turns_, {}, angle_of);
    return std::move(turns_);
  }

 private:
  /// A corner about an axis through the middle.
  struct Off {
    double along = 0, radius = 0;
    Vec3 out{0};
  };
  static Off off(const Body& body, Vec3 axis, Vec3 corner) {
    const Vec3 from = corner - body.pose().middle;
    const double along = glm::dot(from, axis);
    return {along, glm::length(from - along * axis), from - along * axis};
  }

  /// Turns that take one axis to the other and, about it, the corner farthest from it to a corner
  /// of the other shape.
  void find_about(Vec3 from, Vec3 to) {
    const Mat3 base = turn_to(from, to);
    turns_.push_back(base);
    Off far;
    for (const Vec3& p : before_.mesh().positions) {
      const Off one = off(before_, from, p);
      if (one.radius > far.radius + 0.5 * near_) far = one;
    }
    if (far.radius <= near_) return;
    const Vec3 start = glm::normalize(base * far.out), side = glm::cross(to, start);
    std::vector<double> angles;
    for (const Vec3& p : after_.mesh().positions) {
      const Off one = off(after_, to, p);
      if (std::abs(one.along - far.along) > near_ || std::abs(one.radius - far.radius) > near_)
        continue;
      angles.push_back(std::atan2(glm::dot(one.out, side), glm::dot(one.out, start)));
    }
    std::ranges::sort(angles, {}, [](double angle) { return std::abs(angle); });
    const double apart = near_ / far.radius;
    std::vector<double> taken;
    for (const double angle : angles) {
      const auto known = [&](double other) { return std::abs(other - angle) <= apart; };
      if (taken.size() >= kMostCorners || std::ranges::any_of(taken, known)) continue;
      taken.push_back(angle);
      turns_.push_back(turn_about(to, angle) * base);
    }
  }

  /// Of a shape that no axis of inertia tells: its corner farthest from the middle goes to each
  /// that is as far.
  void find_about_corners() {
    const auto from_middle = [](const Body& body, Vec3 p) { return p - body.pose().middle; };
    Vec3 far(0);
    for (const Vec3& p : before_.mesh().positions) {
      const Vec3 one = from_middle(before_, p);
      if (glm::length(one) > glm::length(far) + 0.5 * near_) far = one;
    }
    if (glm::length(far) <= near_) return;
    std::vector<Vec3> taken;
    for (const Vec3& p : after_.mesh().positions) {
      const Vec3 one = from_middle(after_, p);
      const auto known = [&](Vec3 other) { return glm::distance(other, one) <= near_; };
      if (std::abs(glm::length(one) - glm::length(far)) > near_) continue;
      if (taken.size() >= kMostCorners || std::ranges::any_of(taken, known)) continue;
      taken.push_back(one);
      find_about(glm::normalize(far), glm::normalize(one));
    }
  }

  const Body& before_;
  const Body& after_;
  double near_;
  std::vector<Mat3> turns_;
};

}  // namespace

std::optional<Placement> rigid_move(const Body& before, const Body& after, double place,
                                    const RunContext& context) {
  const Vec3 from = before.pose().middle, to = after.pose().middle;
  const Placement shift{Mat3(1), to - from};
  if (coincide(before, after, shift, place)) return shift;
  for (const Mat3& turn : Turns(before, after).find()) {
    context.check();
    const Placement move{turn, to - turn * from};
    if (coincide(before, after, move, place)) return move;
  }
  return std::nullopt;
}

}  // namespace burin
