#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/surface/placed_form.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

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
  std::optional<Vec2> parameters(const SurfacePoint& point) const override {
    return surface_->parameters(inside(point));
  }
  bool exact() const override { return surface_->exact(); }
  bool holds_for_coarser() const override { return surface_->holds_for_coarser(); }
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

}  // namespace

/// A form, the surfaces of it that live, and what it becomes where it is stretched or mirrored.
class Instances {
 public:
  explicit Instances(std::shared_ptr<const Form> form) : form_(std::move(form)) {}

  const std::shared_ptr<const Form>& form() const { return form_; }

  std::shared_ptr<const Surface> realise(const RealiseOptions& options, RunContext& context) {
    context.check();
    if (options.view && options.view->perspective()) return form_->realise(options, context);
    if (auto known = find(options)) return known;
    Diagnostics said;
    RealiseOptions asked = options;
    if (options.diagnostics) asked.diagnostics = &said;
    auto surface = form_->realise(asked, context);
    if (options.diagnostics) options.diagnostics->append(said);
    const std::lock_guard lock(mutex_);
    std::erase_if(made_, [](const Made& made) { return made.surface.expired(); });
    made_.push_back({key_of(options), surface, std::move(said)});
    return surface;
  }

  /// The form after a linear map that does more than turn and scale: made once, as long as a form
  /// of it lives.
  std::shared_ptr<Instances> mapped(const Mat3& linear) {
    const std::lock_guard lock(mutex_);
    std::erase_if(mapped_, [](const Mapped& m) { return m.instances.expired(); });
    for (const Mapped& known : mapped_) {
      if (known.linear != linear) continue;
      if (auto instances = known.instances.lock()) return instances;
    }
    auto form = form_->mapped({linear, Vec3(0)});
    if (!form) throw GeometryError("this form can be turned, scaled and moved, but not stretched");
    auto made = std::make_shared<Instances>(std::move(form));
    mapped_.push_back({linear, made});
    return made;
  }

 private:
  /// What a surface depends on, of the view all but where it looks from.
  struct Key {
    double tolerance, crease_angle;
    bool curvature, reported, seen;
    Vec3 right, up;
    double scale;
    bool operator==(const Key&) const = default;
  };
  struct Made {
    Key key;
    std::weak_ptr<const Surface> surface;
    Diagnostics said;
  };

  static Key key_of(const RealiseOptions& o) {
    const bool seen = o.view != nullptr;
    return {o.tolerance,
            o.crease_angle,
            o.curvature,
            o.diagnostics != nullptr,
            seen,
            seen ? o.view->right() : Vec3(0),
            seen ? o.view->up() : Vec3(0),
            seen ? o.view->scale() : 0};
  }

  std::shared_ptr<const Surface> find(const RealiseOptions& options) {
    const Key key = key_of(options);
    const std::lock_guard lock(mutex_);
    for (const Made& made : made_) {
      if (made.key != key) continue;
      auto surface = made.surface.lock();
      if (surface && options.diagnostics) options.diagnostics->append(made.said);
      if (surface) return surface;
    }
    return nullptr;
  }

  std::shared_ptr<const Form> form_;
  std::mutex mutex_;
  std::vector<Made> made_;
  struct Mapped {
    Mat3 linear;
    std::weak_ptr<Instances> instances;
  };
  std::vector<Mapped> mapped_;
};

namespace {

// Whether `linear` turns and scales, and does no more.
bool turns(const Placement& placement) {
  constexpr double kOff = 1e-9;
  const double scale = placement.scale();
  if (!(scale > 0) || placement.mirrors()) return false;
  return off_rotation(placement.linear / scale) <= kOff;
}

class PlacedForm final : public Form {
 public:
  PlacedForm(std::shared_ptr<Instances> root, const Placement& placement)
      : root_(std::move(root)),
        placement_(placement),
        shown_(turns(placement) ? root_ : root_->mapped(placement.linear)),
        place_(shown_ == root_ ? placement : Placement{Mat3(1), placement.offset}) {}

  Box3 bounds(const Mat3& axes) const override {
    Box3 box = shown_->form()->bounds(axes * place_.to.linear);
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
    return std::make_shared<PlacedSurface>(shown_->realise(inner, context), place_);
  }
  std::shared_ptr<const Form> mapped(const Placement& by) const override {
    return std::make_shared<PlacedForm>(root_, after(by, placement_));
  }
  bool looks_at_view() const override { return root_->form()->looks_at_view(); }
  bool realised_beside_others() const override { return root_->form()->realised_beside_others(); }
  bool same_as(const Form& other) const override {
    const auto* placed = dynamic_cast<const PlacedForm*>(&other);
    return placed && placed->placement_ == placement_ &&
           placed->root_->form()->same_as(*root_->form());
  }

  const std::shared_ptr<Instances>& root() const { return root_; }
  const Placement& placement() const { return placement_; }
  Definition definition() const override {
    Definition of = root_->form()->definition();
    of.linear = placement_.linear * of.linear;
    return of;
  }
  ShapeMeasure measure(RunContext& context) const override {
    if (!is_similar(placement_)) return shown_->form()->measure(context);
    return root_->form()->measure(context).scaled(placement_.scale(), placement_.mirrors());
  }

 private:
  /// What was placed, and where it stands.
  std::shared_ptr<Instances> root_;
  Placement placement_;
  /// What is realised: the root itself, or what it became, and where that stands.
  std::shared_ptr<Instances> shown_;
  Place place_;
};

}  // namespace

Placer::Placer(std::shared_ptr<const Form> form) : form_(std::move(form)) {
  if (const auto* already = dynamic_cast<const PlacedForm*>(form_.get())) {
    instances_ = already->root();
    before_ = already->placement();
  } else {
    instances_ = std::make_shared<Instances>(form_);
  }
}

std::shared_ptr<const Form> Placer::at(const Placement& placement) const {
  if (!placement.moves()) return form_;
  if (!is_invertible(placement)) {
    throw UsageError(
        "a placement must not flatten what it places, and its numbers must be finite: scale each "
        "direction by more than 0");
  }
  return std::make_shared<PlacedForm>(instances_, after(placement, before_));
}

std::shared_ptr<const Form> placed(std::shared_ptr<const Form> form, const Placement& placement) {
  return Placer(std::move(form)).at(placement);
}

}  // namespace burin
