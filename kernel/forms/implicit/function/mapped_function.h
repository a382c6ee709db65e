#pragma once
// A function of space where a placement takes it.

#include <burin/base/placement.h>
#include <burin/forms/implicit/implicit_function.h>

#include <map>
#include <memory>
#include <mutex>

namespace burin {

/// f(A^-1 (p - b)): its zero set is that of f, placed. Pieces have the names that they have in f.
class MappedFunction final : public ImplicitFunction {
 public:
  /// The placement is invertible; `function` outlives what is made of it.
  MappedFunction(std::shared_ptr<const ImplicitFunction> function, const Placement& placement);
  ~MappedFunction() override;

  void values(std::span<const Vec3> points, std::span<double> out) const override;
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override;
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override;
  Interval range(const Box3& box) const override;
  Interval slope(const Box3& box, Vec3 direction) const override;
  bool has_slopes() const override { return function_->has_slopes(); }
  Box3 bounds() const override;
  std::uint64_t piece(Vec3 p) const override { return function_->piece(back_.point(p)); }
  const ImplicitFunction& piece_function(Vec3 p) const override;
  bool has_pieces() const override { return function_->has_pieces(); }
  std::shared_ptr<const ImplicitFunction> restricted(const Box3& box) const override;
  double cost() const override;

  /// What a piece of f becomes: one for each, however often it is asked for.
  const ImplicitFunction& mapped(const ImplicitFunction& piece) const;

 private:
  std::shared_ptr<const ImplicitFunction> function_;
  Placement to_, back_;
  mutable std::mutex mutex_;
  mutable std::map<const ImplicitFunction*, std::unique_ptr<const ImplicitFunction>> pieces_;
};

}  // namespace burin
