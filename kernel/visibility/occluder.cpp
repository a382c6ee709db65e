#include <burin/base/box.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/visibility/occluder.h>

#include "embree.h"
#include "flush_denormals.h"
#include "sheared_ray.h"
#include "triangle_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace burin {
namespace {

using detail::FlushDenormals;

// Two units in the last place of a coordinate in [-1, 1], the scene's size as Embree sees it: below
// it single precision cannot tell two places apart.
constexpr double kUnitResolution = 0x1.0p-22;
// How far Embree's boxes stand out around triangles, and its ends of a ray beyond the true ones, in
// the same unit. A ray of a length up to 4 is rounded by up to 2^-22 at its origin, as much by its
// direction, and its way through a box by up to 2^-20 (a reciprocal, two products and a difference;
// not the same on every processor). So no triangle that doubles meet is missed.
constexpr double kMargin = 0x1.0p-18;
// Share of the scene's diagonal within which places on the line of sight are one: far above what
// doubles are rounded by, far below what can be seen. More would lose what lies right behind, where
// planes of two files cross in their rounding.
constexpr double kTie = 1e-10;

// A part as Embree's callbacks see it.
struct Part {
  const TriMesh* mesh;
  std::int32_t index;
  detail::UnitFrame frame;  // of the scene
  detail::TriangleRuns runs;
};

// The foremost of the hits that it is shown, in whatever order: of those that are within `tie` of
// the nearest the one of the part that comes first in `order`, and of its lowest triangle.
class Foremost {
 public:
  // `order`: the place of each part; empty: its number.
  Foremost(double tie, std::span<const std::int32_t> order) : tie_(tie), order_(order) {
    kept_.reserve(4);
  }

  // No farther hit can be the one.
  double reach() const { return nearest_ + tie_; }
  void show(const Hit& hit) {
    if (hit.distance > reach()) return;
    nearest_ = std::min(nearest_, hit.distance);
    // What is both farther and of a later name than another is never asked for again.
    if (std::ranges::any_of(kept_, [&](const Hit& k) { return beats(k, hit); })) return;
    std::erase_if(kept_, [&](const Hit& k) { return beats(hit, k) || k.distance > reach(); });
    kept_.push_back(hit);
  }
  std::optional<Hit> get() const {
    if (kept_.empty()) return std::nullopt;
    return *std::ranges::min_element(kept_, {}, [&](const Hit& hit) { return name(hit); });
  }

 private:
  std::pair<std::int32_t, std::uint32_t> name(const Hit& hit) const {
    const std::int32_t part = hit.where.part;
    return {order_.empty() ? part : order_[static_cast<std::size_t>(part)], hit.where.face};
  }
  bool beats(const Hit& a, const Hit& b) const {
    return a.distance <= b.distance && name(a) < name(b);
  }

  double tie_, nearest_ = std::numeric_limits<double>::infinity();
  std::span<const std::int32_t> order_;
  // Several are rare: no memory is asked for.
  std::array<std::byte, 4 * sizeof(Hit)> buffer_;
  std::pmr::monotonic_buffer_resource pool_{buffer_.data(), buffer_.size()};
  std::pmr::vector<Hit> kept_{&pool_};
};

// A ray in double precision beside the one that Embree sees.
struct Query {
  detail::ShearedRay ray;
  double near, far;
  const std::function<bool(FaceRef)>* ignore = nullptr;
  const std::function<bool(const Hit&)>* counts = nullptr;
  Foremost* foremost = nullptr;
  // Embree's ray once more; `skipped`: the model mm before its start.
  detail::UnitRay unit_ray = {};
  double skipped = 0;
};

// Embree's context comes first, so that a pointer to it is a pointer to the whole.
struct Context {
  detail::EmbreeContext base;
  const Query* query;
};

// Whether the ray meets a triangle between its ends.
std::optional<Hit> meet(const Query& q, const Part& part, std::uint32_t face) {
  const Triangle& t = part.mesh->triangles[face];
  const std::vector<Vec3>& p = part.mesh->positions;
  const auto met = q.ray.meets(p[t[0]], p[t[1]], p[t[2]]);
  if (!met || !(met->distance >= q.near && met->distance <= q.far)) return std::nullopt;
  return Hit{{part.index, face}, met->bary, met->distance};
}

void bound(const RTCBoundsFunctionArguments* args) {
  const Part& part = *static_cast<const Part*>(args->geometryUserPtr);
  const Box3 own = part.runs.box(args->primID);
  const Vec3 low = part.frame.of(own.min) - kMargin, high = part.frame.of(own.max) + kMargin;
  RTCBounds& box = *args->bounds_o;
  box.lower_x = static_cast<float>(low.x), box.upper_x = static_cast<float>(high.x);
  box.lower_y = static_cast<float>(low.y), box.upper_y = static_cast<float>(high.y);
  box.lower_z = static_cast<float>(low.z), box.upper_z = static_cast<float>(high.z);
}

const Query& query_of(const detail::EmbreeContext* context) {
  return *reinterpret_cast<const Context*>(context)->query;
}

// Calls `take` with the hits of the run; until it returns true.
template <typename Take>
void each_hit(const Query& q, const Part& part, std::uint32_t run, const Take& take) {
  for (unsigned int left = part.runs.may_meet(run, q.unit_ray); left != 0; left &= left - 1) {
    const auto which = static_cast<std::uint32_t>(std::countr_zero(left));
    const auto hit = meet(q, part, part.runs.face(run, which));
    if (hit && take(*hit)) return;
  }
}

// Rays are asked one by one: N is 1.
void find_foremost(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const Query& q = query_of(args->context);
  const Part& part = *static_cast<const Part*>(args->geometryUserPtr);
  each_hit(q, part, args->primID, [&](const Hit& hit) {
    q.foremost->show(hit);
    float& end = RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
    end = std::min(
        end, static_cast<float>((q.foremost->reach() - q.skipped) / part.frame.half + kMargin));
    return false;
  });
}

void find_any(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const Query& q = query_of(args->context);
  const Part& part = *static_cast<const Part*>(args->geometryUserPtr);
  each_hit(q, part, args->primID, [&](const Hit& hit) {
    if ((q.ignore && (*q.ignore)(hit.where)) || (q.counts && !(*q.counts)(hit))) return false;
    // Embree's mark of an occluded ray.
    RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
    return true;
  });
}

// The place of each part among those that lie on each other: higher ranks before lower ones, of
// equal ones the lower number. Empty where that is the number itself.
std::vector<std::int32_t> order_of(std::size_t parts, std::vector<double> ranks) {
  ranks.resize(parts, 0);
  if (std::ranges::is_sorted(ranks, std::ranges::greater{})) return {};
  std::vector<std::size_t> sorted(parts);
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::ranges::stable_sort(sorted, std::ranges::greater{}, [&](std::size_t i) { return ranks[i]; });
  std::vector<std::int32_t> order(parts);
  for (std::size_t i = 0; i < parts; ++i) order[sorted[i]] = static_cast<std::int32_t>(i);
  return order;
}

}  // namespace

struct Occluder::Impl {
  std::vector<Part> parts;
  std::vector<std::int32_t> order;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  detail::UnitFrame frame;
  double diagonal = 0;  // model mm
  const RunContext* building = nullptr;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void measure() {
    Box3 box;
    for (const Part& part : parts) box.add(part.mesh->bounds());
    if (box.empty()) return;
    const Vec3 size = box.size();
    frame.center = box.center();
    diagonal = box.diagonal();
    const double largest = 0.5 * std::max({size.x, size.y, size.z});
    if (largest > 0 && std::isfinite(largest)) frame.half = largest;
    for (Part& part : parts) part.frame = frame;
  }

  void check(const char* doing) const {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_CANCELLED) throw Cancelled();
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw Error(
        fmt::format("Embree failed with error {} while {}", static_cast<int>(error), doing));
  }

  void add(const Part& part) {
    if (part.mesh->triangles.empty()) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(part.runs.size()));
    // Embree takes the parts as what may change; none of the callbacks changes them.
    rtcSetGeometryUserData(geometry, const_cast<Part*>(&part));
    rtcSetGeometryBoundsFunction(geometry, &bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry, &find_foremost);
    rtcSetGeometryOccludedFunction(geometry, &find_any);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, static_cast<unsigned int>(part.index));
    rtcReleaseGeometry(geometry);
  }

  void build(const std::string& configuration, const RunContext& context) {
    const FlushDenormals flush;
#ifdef BURIN_THREAD_SANITIZER
    const ThreadLimit alone(1);  // it does not see what orders Embree's own tasks
#endif
    device = rtcNewDevice(configuration.empty() ? BURIN_EMBREE : configuration.c_str());
    if (!device) {
      // Any processor of today has what Embree asks for; else it lacks memory for its threads.
      if (rtcGetDeviceError(nullptr) != RTC_ERROR_UNSUPPORTED_CPU) throw std::bad_alloc();
      throw Error("this processor lacks the instructions (SSE2) that Embree needs");
    }
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    for (Part& part : parts) {
      context.check();
      part.runs = detail::TriangleRuns(*part.mesh, part.frame, context);
      add(part);
    }
    building = &context;
    rtcSetSceneProgressMonitorFunction(
        scene, [](void* self, double) { return !static_cast<Impl*>(self)->building->cancelled(); },
        this);
    rtcCommitScene(scene);
    check("building its tree");
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
    building = nullptr;
  }

  Query query(Vec3 origin, Vec3 direction, double near, double far) const {
    return {{origin, direction, kTie * diagonal, diagonal}, near, far};
  }

  // The ray in unit coordinates, cut to the scene's bounding sphere so that a far origin costs no
  // precision. False where the ray misses the sphere.
  bool shorten(Vec3 origin, Vec3 direction, Query& q, RTCRay& ray) const {
    const double half = frame.half;
    const Vec3 o = origin - frame.center;
    const double radius =
        0.5 * diagonal + half * 1e-3;  // model mm; the margin keeps hits on the hull inside
    const double along = -glm::dot(o, direction);
    const Vec3 nearest = o + direction * along;
    const double reach2 = radius * radius - glm::dot(nearest, nearest);
    if (!(reach2 > 0)) return false;
    const double reach = std::sqrt(reach2);
    q.skipped = std::max(0.0, along - reach);
    const double slack = kMargin * half;
    const double from = std::max(q.near - slack, q.skipped),
                 to = std::min(q.far + slack, along + reach);
    if (!(from <= to)) return false;
    const double per_half = 1 / half;
    const Vec3 start = (o + direction * q.skipped) * per_half;
    ray.org_x = static_cast<float>(start.x);
    ray.org_y = static_cast<float>(start.y);
    ray.org_z = static_cast<float>(start.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = static_cast<float>(std::max(0.0, from - q.skipped) * per_half);
    ray.tfar = static_cast<float>((to - q.skipped) * per_half);
    ray.time = 0;
    ray.mask = ~0u;
    ray.id = 0;
    ray.flags = 0;
    q.unit_ray = {{ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}};
    return true;
  }

  bool occluded(Vec3 origin, Vec3 direction, Query q) const {
    RTCRay ray;
    if (!shorten(origin, direction, q, ray)) return false;
    const FlushDenormals flush;
    Context context{{}, &q};
    detail::init(context.base);
    detail::occlude(scene, context.base, ray);
    return ray.tfar < 0;
  }
};

Occluder::Occluder(std::span<const ProxyMesh* const> proxies, const RunContext& context,
                   const OccluderOptions& options)
    : impl_(std::make_unique<Impl>()) {
  for (const ProxyMesh* proxy : proxies) {
    impl_->parts.push_back({&proxy->mesh, static_cast<std::int32_t>(impl_->parts.size()), {}, {}});
  }
  impl_->order = order_of(proxies.size(), options.ranks);
  impl_->measure();
  impl_->build(options.embree, context);
}

Occluder::~Occluder() = default;

std::optional<Hit> Occluder::first_hit(Vec3 origin, Vec3 direction, double near, double far) const {
  Foremost foremost(kTie * impl_->diagonal, impl_->order);
  Query query = impl_->query(origin, direction, near, far);
  query.foremost = &foremost;
  RTCRayHit ray;
  if (!impl_->shorten(origin, direction, query, ray.ray)) return std::nullopt;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  const FlushDenormals flush;
  Context context{{}, &query};
  detail::init(context.base);
  detail::intersect(impl_->scene, context.base, ray);
  return foremost.get();
}

bool Occluder::occluded(Vec3 origin, Vec3 direction, double near, double far,
                        const std::function<bool(FaceRef)>& ignore) const {
  Query query = impl_->query(origin, direction, near, far);
  if (ignore) query.ignore = &ignore;
  return impl_->occluded(origin, direction, query);
}

bool Occluder::occluded_by(Vec3 origin, Vec3 direction, double near, double far,
                           const std::function<bool(const Hit&)>& counts) const {
  Query query = impl_->query(origin, direction, near, far);
  if (counts) query.counts = &counts;
  return impl_->occluded(origin, direction, query);
}

double Occluder::resolution() const { return kUnitResolution * impl_->frame.half; }

double Occluder::diagonal() const { return impl_->diagonal; }

double Occluder::tie() const { return kTie * impl_->diagonal; }

Vec3 Occluder::center() const { return impl_->frame.center; }

}  // namespace burin
