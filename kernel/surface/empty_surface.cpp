#include <burin/surface/empty_surface.h>

namespace burin {
namespace {

class EmptySurface final : public Surface {
 public:
  std::vector<SurfacePoint> cover(const CoverRequest&, const RunContext&) const override {
    return {};
  }
  MarchStep march(const SurfacePoint& from, Vec3, double) const override {
    return {.end = from, .stop = MarchStop::Boundary};
  }
  Frame frame(const SurfacePoint&) const override { return {}; }
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint&) const override { return {}; }
  SurfacePoint lift(const ProxyPoint&) const override { return {}; }

 private:
  ProxyMesh proxy_;
};

}  // namespace

std::shared_ptr<const Surface> empty_surface() {
  static const auto surface = std::make_shared<const EmptySurface>();
  return surface;
}

}  // namespace burin
