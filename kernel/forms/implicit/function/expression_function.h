#pragma once
// A compiled formula as an implicit function.

#include "program.h"
#include "tape.h"

#include <map>
#include <memory>
#include <mutex>

namespace burin {

class ExpressionFunction final : public ImplicitFunction {
 public:
  ExpressionFunction(Tape tape, const Box3& bounds);

  void values(std::span<const Vec3> points, std::span<double> out) const override;
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override;
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override;
  Interval range(const Box3& box) const override;
  Interval slope(const Box3& box, Vec3 direction) const override;
  bool has_slopes() const override { return true; }
  Box3 bounds() const override { return bounds_; }
  std::uint64_t piece(Vec3 p) const override;
  const ImplicitFunction& piece_function(Vec3 p) const override;
  bool has_pieces() const override { return has_pieces_; }
  double cost() const override { return cost_; }
  std::shared_ptr<const ImplicitFunction> restricted(const Box3& box) const override;

 private:
  Tape tape_;
  Program program_;
  Box3 bounds_;
  bool has_pieces_;
  double cost_;
  // Made when first asked for; there are few.
  mutable std::mutex mutex_;
  mutable std::map<std::uint64_t, std::unique_ptr<const ImplicitFunction>> pieces_;
};

}  // namespace burin
