#pragma once
// Where a ray meets a triangle, decided in double precision; internal to the module.

#include <burin/base/vec.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace burin::detail {

/// Of the largest of three magnitudes: along it a ray of that direction runs fastest.
inline std::size_t fastest_axis(double x, double y, double z) {
  return x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
}

/// A place on a ray and in a triangle; barycentric coordinates are not negative and add up to 1.
struct Meeting {
  double distance;  // in lengths of the direction
  Vec3 bary;
};

/// A ray sheared onto the axis along which it runs fastest, so that a triangle is met where it
/// holds the origin of the plane. Edges that two triangles share have the same function in both, up
/// to its sign: no ray passes between them. @cite Woop2013, but with a tolerance: what passes
/// beside a triangle by less meets it, and one that is seen as narrow as that is met by nothing. So
/// a ray that runs through an edge or a wall seen edge-on but for rounding has one answer, whatever
/// the rounding.
class ShearedRay {
 public:
  /// `tolerance`: model mm across the ray; `size`: the longest edge of any triangle, or more.
  ShearedRay(Vec3 origin, Vec3 direction, double tolerance, double size)
      : origin_{origin.x, origin.y, origin.z},
        tolerance_(tolerance),
        coarse_(kStretch * tolerance * size) {
    const Vec3 d = glm::abs(direction);
    along_ = fastest_axis(d.x, d.y, d.z);
    x_ = (along_ + 1) % 3;
    y_ = (along_ + 2) % 3;
    const auto at = [&](std::size_t axis) { return glm::value_ptr(direction)[axis]; };
    scale_ = 1 / at(along_);
    shear_x_ = at(x_) * scale_;
    shear_y_ = at(y_) * scale_;
  }

  std::optional<Meeting> meets(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Corner p = sheared(a), q = sheared(b), r = sheared(c);
    std::array<double, 3> w{cross(q, r), cross(r, p), cross(p, q)};
    const double least = std::min({w[0], w[1], w[2]}), most = std::max({w[0], w[1], w[2]});
    if (least < -coarse_ && most > coarse_) return std::nullopt;
    double area = w[0] + w[1] + w[2];
    if (std::abs(area) <= coarse_ && std::abs(area) <= tolerance_ * longest(p, q, r)) {
      return std::nullopt;
    }
    if (least < 0 && most > 0) {  // beside it, or all but inside
      const double sign = area > 0 ? 1 : -1;
      if (sign * w[0] < -tolerance_ * length(q, r) || sign * w[1] < -tolerance_ * length(r, p) ||
          sign * w[2] < -tolerance_ * length(p, q)) {
        return std::nullopt;
      }
      for (double& weight : w) weight = std::max(sign * weight, 0.0);
      area = w[0] + w[1] + w[2];
    }
    const double inverse = 1 / area;
    const Vec3 bary(w[0] * inverse, w[1] * inverse, w[2] * inverse);
    return Meeting{scale_ * (bary.x * p.along + bary.y * q.along + bary.z * r.along), bary};
  }

 private:
  // Shearing makes an edge at most sqrt(3) times as long, and length() 1.5 times.
  static constexpr double kStretch = 3;

  struct Corner {
    double x, y, along;
  };
  Corner sheared(const Vec3& corner) const {
    const double* p = glm::value_ptr(corner);
    const double along = p[along_] - origin_[along_];
    return {p[x_] - origin_[x_] - shear_x_ * along, p[y_] - origin_[y_] - shear_y_ * along, along};
  }
  static double cross(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }
  // At least the length of an edge, at most 1.5 times it.
  static double length(const Corner& a, const Corner& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y);
  }
  static double longest(const Corner& a, const Corner& b, const Corner& c) {
    return std::max({length(a, b), length(b, c), length(c, a)});
  }

  std::array<double, 3> origin_;
  double tolerance_, coarse_, scale_, shear_x_, shear_y_;
  std::size_t along_, x_, y_;
};

}  // namespace burin::detail
