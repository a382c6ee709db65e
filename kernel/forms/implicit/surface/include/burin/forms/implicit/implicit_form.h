#pragma once
/// The zero set of a function as a form.

#include <burin/base/box.h>
#include <burin/forms/implicit/implicit_function.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <memory>
#include <optional>

namespace burin {

/// The `smallest_part` for volumes of measured data.
constexpr double kSmallestVolumePart = 0.02;

/// How the triangles of an implicit form are made. Lines and strokes are exact with either.
enum class Mesher {
  /// Nets where their even triangles hold the tolerance within the bound, else Delaunay if it does
  /// with a quarter of the bound.
  Auto,
  /// Dual nets on a grid: even triangles, 0.5 s for 350,000.
  Nets,
  /// Delaunay refinement: triangles as large as the curvature lets them be and no slivers, but
  /// 10 to 60 times slower; nets where no closed surface comes of it ("implicit.delaunay_failed").
  Delaunay
};

struct ImplicitProxyOptions {
  Mesher mesher = Mesher::Auto;
  /// What the proxy may have before its triangles become larger than the tolerance asks
  /// ("implicit.proxy_coarse").
  std::size_t max_triangles = 400'000;
};

/// The surface f = 0, closed: where it reaches the domain it is clipped by the domain's box, and a
/// diagnostic ("implicit.clipped") says so. Without a domain the function's own bounds are taken.
/// The constructor looks over the domain in 128 steps, and between them where the function tells
/// its slopes and a tenth of the look's work suffices: components larger than a 300th of the domain
/// are found then, else those of two steps. What may be missing is told once ("implicit.may_miss"):
/// a warning where there is evidence, a note where not all was searched. Those smaller than
/// `smallest_part`, a share of the largest one's diagonal, are left out ("implicit.specks"): the
/// noise of measured data. Throws GeometryError in one line where the
/// function has no surface there, or one so fine that it fills the domain. The functions of
/// realised surfaces are shared with the form. Cost: 0.1 s to look, 0.5 s to realise 300,000
/// triangles on 2 cores.
class ImplicitForm final : public Form {
 public:
  ImplicitForm(std::shared_ptr<const ImplicitFunction> function, std::optional<Box3> domain,
               const RunContext& context, double smallest_part = 0,
               const ImplicitProxyOptions& proxy = {});
  ~ImplicitForm() override;

  Box3 bounds(const Mat3& axes) const override;
  /// Triangles hold `tolerance`, with nets but for a fiftieth of the surface, and are 400,000 at
  /// most ("implicit.proxy_coarse"). They are cut along creases and along the contours of
  /// `options.view`; positions, normals and curvature of the surface are exact in any case.
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  bool realised_beside_others() const override { return true; }

 private:
  struct Impl;
  ImplicitForm(std::shared_ptr<const Impl> impl, const Placement& placement);
  Box3 bounds_as_read(const Mat3& axes) const;

  std::shared_ptr<const Impl> impl_;
  Placement placement_;
};

}  // namespace burin
