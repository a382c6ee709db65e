#pragma once
/// Symmetric tensors of tangent planes.

#include <burin/base/vec.h>

namespace burin {

/// A symmetric 2x2 tensor in some tangent frame (u, v), as its mean and its deviator: the matrix
/// [mean + dx, dy; dy, mean - dx]. The deviator turns by twice the angle of the frame, like a
/// complex number.
struct Tensor {
  double mean = 0;
  double dx = 0;
  double dy = 0;

  Tensor& operator+=(const Tensor& t) {
    mean += t.mean;
    dx += t.dx;
    dy += t.dy;
    return *this;
  }
  friend Tensor operator*(double s, const Tensor& t) { return {s * t.mean, s * t.dx, s * t.dy}; }
  double deviation() const { return glm::length(Vec2(dx, dy)); }
};

/// A unit normal and two unit tangents, right-handed.
struct TangentFrame {
  Vec3 u, v, n;
};

inline TangentFrame tangent_frame(Vec3 n) {
  const Vec3 u = any_orthogonal(n);
  return {u, glm::cross(n, u), n};
}

/// Cosine and sine of twice the angle by which frame `from`, carried by the smallest rotation that
/// joins the normals, is turned against frame `to`.
inline Vec2 double_turn(const TangentFrame& from, const TangentFrame& to) {
  const Vec3 u = transport(from.u, from.n, to.n);
  const double c = glm::dot(u, to.u), s = glm::dot(u, to.v);
  return {c * c - s * s, 2 * c * s};
}

/// The tensor of frame `from` seen in frame `to`.
inline Tensor carried(const Tensor& t, const TangentFrame& from, const TangentFrame& to) {
  const Vec2 turn = double_turn(from, to);
  return {t.mean, t.dx * turn.x - t.dy * turn.y, t.dx * turn.y + t.dy * turn.x};
}

}  // namespace burin
