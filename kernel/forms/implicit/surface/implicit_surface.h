#pragma once
// The surface behind ImplicitForm.

#include <burin/forms/implicit/implicit_function.h>
#include <burin/surface/surface.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// Positions lie on f = 0, coords are the place in the triangle next to them.
class ImplicitSurface final : public Surface {
 public:
  /// `side`: for each triangle that touches a crease the piece it belongs to, else nullptr.
  ImplicitSurface(std::shared_ptr<const ImplicitFunction> function, ProxyMesh proxy,
                  std::vector<const ImplicitFunction*> side, double step, double size);

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override;
  Frame frame(const SurfacePoint& point) const override;
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    return {point.triangle, point.coords};
  }
  SurfacePoint lift(const ProxyPoint& point) const override;
  std::vector<Frame> wedge_frames(const RunContext& context) const override;

 private:
  // The way of a point over the triangles.
  struct Walk {
    ProxyPoint place;
    bool by_crease = false;  // it came by a triangle that touches a crease
    bool reached = false;    // else a crease is in the way
    bool lost = false;       // no triangle is near: a sheet that the proxy has not
  };
  struct State;

  const ImplicitFunction& function_at(std::uint32_t face) const;
  void find_locals();
  Gradient2 known_hessian(const ImplicitFunction& f, Vec3 p) const;
  Walk walk(std::uint32_t face, Vec3 p) const;
  bool advance(const ImplicitFunction& f, const State& from, double length, State& to) const;
  bool stays(const ImplicitFunction& piece, std::uint32_t face, Vec3 p) const;

  std::shared_ptr<const ImplicitFunction> function_;
  ProxyMesh proxy_;
  std::vector<const ImplicitFunction*> side_;
  // The function restricted to boxes of some cells, which is shorter: for each triangle its entry,
  // -1 = none. They hold up to kLocalReach steps from the triangle.
  static constexpr double kLocalReach = 2;
  std::vector<std::shared_ptr<const ImplicitFunction>> locals_;
  std::vector<std::int32_t> local_of_;
  double step_, size_, accuracy_;
  // Of all surfaces that ever were, see known_hessian.
  std::uint64_t name_;
};

}  // namespace burin
