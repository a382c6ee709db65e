#include "mapped_function.h"

#include <burin/base/affine.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace burin {
namespace {

std::vector<Vec3> moved(std::span<const Vec3> points, const Placement& by) {
  std::vector<Vec3> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back(by.point(p));
  return out;
}

/// The box of a box elsewhere. Sides without end stay so only where nothing is mixed: else all do.
Box3 box_of(const Box3& box, const Placement& by) {
  if (box.empty()) return box;
  Box3 out{by.offset, by.offset};
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double m = by.linear[column][row];
      if (m == 0) continue;  // times infinity it would be no number
      const double a = m * box.min[column], b = m * box.max[column];
      out.min[row] += std::min(a, b);
      out.max[row] += std::max(a, b);
    }
  }
  return out;
}

}  // namespace

MappedFunction::MappedFunction(std::shared_ptr<const ImplicitFunction> function,
                               const Placement& placement)
    : function_(std::move(function)), to_(placement), back_(inverse(placement)) {}
MappedFunction::~MappedFunction() = default;

void MappedFunction::values(std::span<const Vec3> points, std::span<double> out) const {
  function_->values(moved(points, back_), out);
}

void MappedFunction::gradients(std::span<const Vec3> points, std::span<Gradient1> out) const {
  function_->gradients(moved(points, back_), out);
  const Mat3 transposed = glm::transpose(back_.linear);
  for (Gradient1& g : out) g.gradient = transposed * g.gradient;
}

void MappedFunction::hessians(std::span<const Vec3> points, std::span<Gradient2> out) const {
  function_->hessians(moved(points, back_), out);
  const Mat3 transposed = glm::transpose(back_.linear);
  for (Gradient2& g : out) {
    Mat3 h;
    for (int i = 0; i < 3; ++i) h[i] = transposed * g.hessian_times(back_.linear[i]);
    g.gradient = transposed * g.gradient;
    g.xx = h[0][0], g.yy = h[1][1], g.zz = h[2][2];
    g.xy = h[1][0], g.xz = h[2][0], g.yz = h[2][1];
  }
}

Interval MappedFunction::range(const Box3& box) const {
  return function_->range(box_of(box, back_));
}

Interval MappedFunction::slope(const Box3& box, Vec3 direction) const {
  return function_->slope(box_of(box, back_), back_.linear * direction);
}

Box3 MappedFunction::bounds() const { return box_of(function_->bounds(), to_); }

const ImplicitFunction& MappedFunction::piece_function(Vec3 p) const {
  return mapped(function_->piece_function(back_.point(p)));
}

const ImplicitFunction& MappedFunction::mapped(const ImplicitFunction& piece) const {
  if (&piece == function_.get()) return *this;
  const std::lock_guard lock(mutex_);
  std::unique_ptr<const ImplicitFunction>& known = pieces_[&piece];
  if (!known) {
    // The piece belongs to the function, which this one holds.
    known = std::make_unique<MappedFunction>(
        std::shared_ptr<const ImplicitFunction>(function_, &piece), to_);
  }
  return *known;
}

std::shared_ptr<const ImplicitFunction> MappedFunction::restricted(const Box3& box) const {
  auto inner = function_->restricted(box_of(box, back_));
  return inner ? std::make_shared<MappedFunction>(std::move(inner), to_) : nullptr;
}

double MappedFunction::cost() const {
  constexpr double kMap = 20;
  return function_->cost() + kMap;
}

}  // namespace burin
