#pragma once
/// f(x,y,z) with its derivatives: what an implicit form is made from.

#include <burin/base/box.h>
#include <burin/base/vec.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

namespace burin {

/// A value with its gradient, in model units.
struct Gradient1 {
  double value = 0;
  Vec3 gradient{0};
};

/// A value with its gradient and its (symmetric) Hessian.
struct Gradient2 {
  double value = 0;
  Vec3 gradient{0};
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  Vec3 hessian_times(Vec3 v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
            xz * v.x + yz * v.y + zz * v.z};
  }
};

/// All numbers from `min` to `max`; the whole line where nothing is known.
struct Interval {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  bool contains(double v) const { return min <= v && v <= max; }
};

/// A function of space whose zero set is a surface, negative inside. Immutable; every function may
/// be called from many threads. Only the batches have to be written; they are also the cheap way to
/// call it. Values may be NaN or infinite where the function is not defined; these points count as
/// outside.
class ImplicitFunction {
 public:
  ImplicitFunction() = default;
  ImplicitFunction(const ImplicitFunction&) = delete;
  ImplicitFunction& operator=(const ImplicitFunction&) = delete;
  virtual ~ImplicitFunction() = default;

  /// Batches: `out` has the size of `points`.
  virtual void values(std::span<const Vec3> points, std::span<double> out) const = 0;
  virtual void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const = 0;
  virtual void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const = 0;

  double value(Vec3 p) const;
  Gradient1 gradient(Vec3 p) const;
  Gradient2 hessian(Vec3 p) const;

  /// An interval that holds all values over a box (whose sides may be infinite), up to rounding.
  /// The default is all numbers.
  virtual Interval range([[maybe_unused]] const Box3& box) const { return {}; }
  /// An interval that holds all derivatives along `direction` over a box, at creases those of all
  /// pieces that meet: where it does not hold zero, no component of the surface lies in the box
  /// alone. The default, and the answer where the function may jump or be no number, is all
  /// numbers.
  virtual Interval slope([[maybe_unused]] const Box3& box, [[maybe_unused]] Vec3 direction) const {
    return {};
  }
  /// Whether `slope` tells more than nothing.
  virtual bool has_slopes() const { return false; }
  /// A box that holds the zero set and its inside; infinite sides where nothing is known.
  virtual Box3 bounds() const { return everywhere(); }

  /// Functions that are put together by min, max and abs have PIECES, on each of which they are one
  /// smooth function; creases lie where pieces meet. `piece` names the one that is active at a
  /// point (equal names: same piece), `piece_function` continues it over all of space. The default
  /// is one piece: itself.
  virtual std::uint64_t piece([[maybe_unused]] Vec3 p) const { return 0; }
  virtual const ImplicitFunction& piece_function([[maybe_unused]] Vec3 p) const { return *this; }
  /// Whether there is more than one piece.
  virtual bool has_pieces() const { return false; }

  /// A function that equals this one inside the box and is cheaper there; nullptr = there is none.
  virtual std::shared_ptr<const ImplicitFunction> restricted(
      [[maybe_unused]] const Box3& box) const {
    return nullptr;
  }

  /// How many arithmetic operations a value takes, about: what bounds the work of meshing.
  virtual double cost() const { return 50; }

  static Box3 everywhere() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {Vec3(-kInfinity), Vec3(kInfinity)};
  }
};

/// max(f, box): the part of `function` inside a box, closed by the faces of the box.
std::shared_ptr<const ImplicitFunction> clip(std::shared_ptr<const ImplicitFunction> function,
                                             const Box3& box);

}  // namespace burin
