#include <burin/base/error.h>
#include <burin/surface/placed_form.h>

#include <optional>
#include <utility>

namespace burin {
namespace {

// The placement, and the way back.
struct Place {
  Placement to, from;
  double scale;

  explicit Place(const Placement& placement) : to(placement), scale(placement.scale()) {
    from.linear = glm::transpose(to.linear) / (scale * scale);
    from.offset = -(from.linear * to.offset);
  }
  // Of a unit vector, a unit vector.
  Vec3 turned(Vec3 v) const { return to.linear * v / scale; }
};

ProxyMesh placed_proxy(ProxyMesh proxy, const Place& place) {
  for (Vec3& p : proxy.mesh.positions) p = place.to.point(p);
  for (Vec3& n : proxy.wedge_normal) n = place.turned(n);
  for (float& s : proxy.wedge_sagitta) s *= static_cast<float>(place.scale);
  proxy.tolerance *= place.scale;
  return proxy;
}

class PlacedSurface final : public Surface {
 public:
  PlacedSurface(std::shared_ptr<const Surface> surface, const Place& place)
      : surface_(std::move(surface)),
        place_(place),
        proxy_(placed_proxy(surface_->proxy(), place)) {}

  std::vector<SurfacePoint> cover(const CoverRequest& request,
                                  const RunContext& context) const override {
    CoverRequest inner = request;
    if (request.weight) {
      inner.weight = [&](Vec3 p, Vec3 n) {
        return request.weight(place_.to.point(p), place_.turned(n));
      };
    }
    if (request.among) {
      inner.among = [&](Vec3 a, Vec3 b, Vec3 c) {
        return request.among(place_.to.point(a), place_.to.point(b), place_.to.point(c));
      };
    }
    std::vector<SurfacePoint> points = surface_->cover(inner, context);
    for (SurfacePoint& p : points) p.position = place_.to.point(p.position);
    return points;
  }

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    MarchStep step =
        surface_->march(inside(from), place_.from.vector(tangent), length / place_.scale);
    step.end.position = place_.to.point(step.end.position);
    step.direction = place_.turned(step.direction);
    step.length *= place_.scale;
    return step;
  }

  Frame frame(const SurfacePoint& point) const override {
    Frame f = placed_frame(surface_->frame(inside(point)));
    f.position = point.position;  // to the last bit, as of every form
    return f;
  }
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    return surface_->to_proxy(inside(point));
  }
  SurfacePoint lift(const ProxyPoint& point) const override {
    SurfacePoint lifted = surface_->lift(point);
    lifted.position = place_.to.point(lifted.position);
    return lifted;
  }
  bool exact() const override { return surface_->exact(); }
  Vec3 drawn_position(const SurfacePoint& point) const override {
    return place_.to.point(surface_->drawn_position(inside(point)));
  }
  std::vector<Frame> wedge_frames(const RunContext& context) const override {
    std::vector<Frame> frames = surface_->wedge_frames(context);
    for (Frame& f : frames) f = placed_frame(f);
    return frames;
  }

 private:
  SurfacePoint inside(SurfacePoint point) const {
    point.position = place_.from.point(point.position);
    return point;
  }
  Frame placed_frame(Frame f) const {
    f.position = place_.to.point(f.position);
    f.normal = place_.turned(f.normal);
    f.k1 /= place_.scale, f.k2 /= place_.scale;
    f.d1 = place_.turned(f.d1), f.d2 = place_.turned(f.d2);
    f.du = place_.to.vector(f.du), f.dv = place_.to.vector(f.dv);
    return f;
  }

  std::shared_ptr<const Surface> surface_;
  Place place_;
  ProxyMesh proxy_;
};

class PlacedForm final : public Form {
 public:
  PlacedForm(std::shared_ptr<const Form> form, const Placement& placement)
      : form_(std::move(form)), place_(placement) {}

  Box3 bounds(const Mat3& axes) const override {
    Box3 box = form_->bounds(axes * place_.to.linear);
    const Vec3 by = axes * place_.to.offset;
    box.min += by, box.max += by;
    return box;
  }

  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    RealiseOptions inner = options;
    inner.tolerance /= place_.scale;
    std::optional<Camera> view;
    if (options.view) {
      view = options.view->inside(place_.to);
      inner.view = &*view;
    }
    return std::make_shared<PlacedSurface>(form_->realise(inner, context), place_);
  }

 private:
  std::shared_ptr<const Form> form_;
  Place place_;
};

// Whether `linear` turns and scales, and does no more.
bool turns(const Placement& placement) {
  constexpr double kOff = 1e-9;
  const double scale = placement.scale();
  if (!(scale > 0) || placement.mirrors()) return false;
  const Mat3 unit = glm::transpose(placement.linear) * placement.linear / (scale * scale);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(unit[i][j] - (i == j ? 1 : 0)) <= kOff)) return false;
    }
  }
  return true;
}

}  // namespace

std::shared_ptr<const Form> placed(std::shared_ptr<const Form> form, const Placement& placement) {
  if (!placement.moves()) return form;
  if (!turns(placement)) throw UsageError("a placement turns, scales by one factor and moves");
  return std::make_shared<PlacedForm>(std::move(form), placement);
}

}  // namespace burin
