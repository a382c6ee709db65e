#include "clipped.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

// One face of the clipping planes, as a function.
class PlaneFace final : public ImplicitFunction {
 public:
  explicit PlaneFace(HalfSpace plane) : plane_(plane) {}

  double at(Vec3 p) const { return glm::dot(plane_.normal, p) - plane_.at; }
  Vec3 normal() const { return plane_.normal; }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = at(points[i]);
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = {at(points[i]), plane_.normal};
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = {at(points[i]), plane_.normal};
  }
  Interval range(const Box3& box) const override {
    const Vec3 half = 0.5 * box.size();
    const double middle = at(box.center()), reach = glm::dot(glm::abs(plane_.normal), half);
    return {middle - reach, middle + reach};
  }

 private:
  HalfSpace plane_;
};

class Clipped final : public ImplicitFunction {
 public:
  Clipped(std::shared_ptr<const ImplicitFunction> function, const std::vector<HalfSpace>& planes,
          const Box3& bounds)
      : function_(std::move(function)), bounds_(bounds) {
    for (const HalfSpace& p : planes) faces_.push_back(std::make_unique<PlaneFace>(p));
  }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    function_->values(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = nearest(points[i]).value;
      if (d > out[i]) out[i] = d;  // what is not a number stays so
    }
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    function_->gradients(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Nearest n = nearest(points[i]);
      if (n.value > out[i].value) out[i] = {n.value, faces_[n.face]->normal()};
    }
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    function_->hessians(points, out);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Nearest n = nearest(points[i]);
      if (n.value > out[i].value) out[i] = {n.value, faces_[n.face]->normal()};
    }
  }
  Interval range(const Box3& box) const override {
    Interval r = function_->range(box);
    for (const auto& face : faces_) {
      const Interval f = face->range(box);
      r.min = std::max(r.min, f.min);
      r.max = std::max(r.max, f.max);
    }
    return r;
  }
  Interval slope(const Box3& box, Vec3 direction) const override {
    const Interval own = function_->range(box);
    double least = own.min;
    for (const auto& face : faces_) least = std::max(least, face->range(box).min);
    // Of those that are the largest somewhere.
    Interval r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto add = [&](Interval s) { r = {std::min(r.min, s.min), std::max(r.max, s.max)}; };
    if (!(own.max < least)) add(function_->slope(box, direction));
    for (const auto& face : faces_) {
      const double s = glm::dot(face->normal(), direction);
      if (!(face->range(box).max < least)) add({s, s});
    }
    return r;
  }
  bool has_slopes() const override { return function_->has_slopes(); }
  Box3 bounds() const override { return bounds_; }
  std::uint64_t piece(Vec3 p) const override {
    const Nearest n = nearest(p);
    return on_face(p, n) ? n.face + 1 : function_->piece(p) + faces_.size() + 1;
  }
  const ImplicitFunction& piece_function(Vec3 p) const override {
    const Nearest n = nearest(p);
    return on_face(p, n) ? *faces_[n.face] : function_->piece_function(p);
  }
  bool has_pieces() const override { return true; }
  double cost() const override { return function_->cost() + 30; }
  std::shared_ptr<const ImplicitFunction> restricted(const Box3& box) const override {
    for (const auto& face : faces_) {
      if (face->range(box).max >= 0) return nullptr;
    }
    // Strictly inside: the planes cut nothing, unless the function is deep below zero there, where
    // only the sign matters.
    auto inner = function_->restricted(box);
    return inner ? inner : function_;
  }

 private:
  struct Nearest {
    double value = -std::numeric_limits<double>::infinity();
    std::size_t face = 0;
  };
  Nearest nearest(Vec3 p) const {
    Nearest best;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const double d = faces_[k]->at(p);
      if (d > best.value) best = {d, k};
    }
    return best;
  }
  bool on_face(Vec3 p, const Nearest& n) const { return !(function_->value(p) >= n.value); }

  std::shared_ptr<const ImplicitFunction> function_;
  Box3 bounds_;
  std::vector<std::unique_ptr<const PlaneFace>> faces_;
};

}  // namespace

std::shared_ptr<const ImplicitFunction> clip(std::shared_ptr<const ImplicitFunction> function,
                                             const std::vector<HalfSpace>& planes,
                                             const Box3& bounds) {
  return std::make_shared<Clipped>(std::move(function), planes, bounds);
}

std::shared_ptr<const ImplicitFunction> clip(std::shared_ptr<const ImplicitFunction> function,
                                             const Box3& box) {
  std::vector<HalfSpace> planes;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 normal(0);
    normal[axis] = 1;
    planes.push_back({-normal, -box.min[axis]});
    planes.push_back({normal, box.max[axis]});
  }
  return clip(std::move(function), planes, box);
}

}  // namespace burin
