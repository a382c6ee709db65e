#include <burin/forms/implicit/implicit_function.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace burin {

double ImplicitFunction::value(Vec3 p) const {
  double v = 0;
  values({&p, 1}, {&v, 1});
  return v;
}
Gradient1 ImplicitFunction::gradient(Vec3 p) const {
  Gradient1 g;
  gradients({&p, 1}, {&g, 1});
  return g;
}
Gradient2 ImplicitFunction::hessian(Vec3 p) const {
  Gradient2 h;
  hessians({&p, 1}, {&h, 1});
  return h;
}

namespace {

// One face of the clipping box, as a function.
class BoxFace final : public ImplicitFunction {
 public:
  BoxFace(int axis, double sign, double at) : at_(at) { normal_[axis] = sign; }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = glm::dot(normal_, points[i]) - at_;
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      out[i] = {glm::dot(normal_, points[i]) - at_, normal_};
    }
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      out[i] = {glm::dot(normal_, points[i]) - at_, normal_};
    }
  }

 private:
  Vec3 normal_{0};
  double at_;
};

class Clipped final : public ImplicitFunction {
 public:
  Clipped(std::shared_ptr<const ImplicitFunction> function, const Box3& box)
      : function_(std::move(function)), box_(box) {
    for (int axis = 0; axis < 3; ++axis) {
      faces_.push_back(std::make_unique<BoxFace>(axis, -1, -box.min[axis]));
      faces_.push_back(std::make_unique<BoxFace>(axis, 1, box.max[axis]));
    }
  }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    function_->values(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = faces_[nearest(points[i])]->value(points[i]);
      if (d > out[i]) out[i] = d;  // what is not a number stays so
    }
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    function_->gradients(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Gradient1 g = faces_[nearest(points[i])]->gradient(points[i]);
      if (g.value > out[i].value) out[i] = g;
    }
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    function_->hessians(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Gradient2 g = faces_[nearest(points[i])]->hessian(points[i]);
      if (g.value > out[i].value) out[i] = g;
    }
  }
  Interval range(const Box3& box) const override {
    const Interval f = function_->range(box);
    double min = -std::numeric_limits<double>::infinity(), max = min;
    for (int axis = 0; axis < 3; ++axis) {
      min = std::max({min, box_.min[axis] - box.max[axis], box.min[axis] - box_.max[axis]});
      max = std::max({max, box_.min[axis] - box.min[axis], box.max[axis] - box_.max[axis]});
    }
    return {std::max(f.min, min), std::max(f.max, max)};
  }
  Box3 bounds() const override { return box_; }
  std::uint64_t piece(Vec3 p) const override {
    const std::size_t face = nearest(p);
    return on_face(p, face) ? face + 1 : function_->piece(p) + 7;
  }
  const ImplicitFunction& piece_function(Vec3 p) const override {
    const std::size_t face = nearest(p);
    return on_face(p, face) ? *faces_[face] : function_->piece_function(p);
  }
  bool has_pieces() const override { return true; }
  std::shared_ptr<const ImplicitFunction> restricted(const Box3& box) const override {
    for (int axis = 0; axis < 3; ++axis) {
      if (box.min[axis] <= box_.min[axis] || box.max[axis] >= box_.max[axis]) return nullptr;
    }
    // Strictly inside: the box cuts nothing, unless the function is deep below zero there, where
    // only the sign matters.
    auto inner = function_->restricted(box);
    return inner ? inner : function_;
  }

 private:
  std::size_t nearest(Vec3 p) const {
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box_.min[axis] - p[axis], high = p[axis] - box_.max[axis];
      const auto k = static_cast<std::size_t>(2 * axis);
      if (low > most) most = low, best = k;
      if (high > most) most = high, best = k + 1;
    }
    return best;
  }
  bool on_face(Vec3 p, std::size_t face) const {
    return !(function_->value(p) >= faces_[face]->value(p));
  }

  std::shared_ptr<const ImplicitFunction> function_;
  Box3 box_;
  std::vector<std::unique_ptr<const BoxFace>> faces_;
};

}  // namespace

std::shared_ptr<const ImplicitFunction> clip(std::shared_ptr<const ImplicitFunction> function,
                                             const Box3& box) {
  return std::make_shared<Clipped>(std::move(function), box);
}

}  // namespace burin
