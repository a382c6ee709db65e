#include <burin/base/box.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/visibility/occluder.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

namespace burin {
namespace {

// Two units in the last place of a coordinate in [-1, 1], the scene's size as Embree sees it: below
// it single precision cannot tell two places apart.
constexpr double kUnitResolution = 0x1.0p-22;

// Embree asks for flushed denormals; the mode belongs to the thread and goes back to what it was.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned int saved_;
};

// A ray in double precision beside the one that Embree sees.
struct Query {
  Vec3 origin, direction;
  double near, far;
  std::span<const ProxyMesh* const> proxies;
  const std::function<bool(FaceRef)>* ignore = nullptr;
  const std::function<bool(const Hit&)>* counts = nullptr;
};

// Embree's context comes first, so that a pointer to it is a pointer to the whole.
struct Context {
  RTCIntersectContext base;
  const Query* query;
};

struct PlaneHit {
  double distance;
  Vec3 bary;
};

// Distance and barycentrics on the triangle's plane; nothing where the ray is parallel to it in
// double precision.
std::optional<PlaneHit> intersect_plane(const ProxyMesh& proxy, std::uint32_t face, Vec3 origin,
                                        Vec3 direction) {
  const Triangle& t = proxy.mesh.triangles[face];
  const Vec3 a = proxy.mesh.positions[t[0]] - origin;
  const Vec3 ab = proxy.mesh.positions[t[1]] - proxy.mesh.positions[t[0]];
  const Vec3 ac = proxy.mesh.positions[t[2]] - proxy.mesh.positions[t[0]];
  const Vec3 n = glm::cross(ab, ac);
  const double det = glm::dot(n, direction);
  if (det == 0) return std::nullopt;
  const double distance = glm::dot(n, a) / det;
  const Vec3 p = direction * distance - a;
  const double nn = glm::dot(n, n);
  const double v = glm::dot(glm::cross(p, ac), n) / nn, w = glm::dot(glm::cross(ab, p), n) / nn;
  return PlaneHit{distance, {1 - v - w, v, w}};
}

// Lets a hit stand or passes the ray through it.
void filter_hit(const RTCFilterFunctionNArguments* args) {
  const Query& q = *reinterpret_cast<const Context*>(args->context)->query;
  const FaceRef where{static_cast<std::int32_t>(RTCHitN_geomID(args->hit, args->N, 0)),
                      RTCHitN_primID(args->hit, args->N, 0)};
  bool stands = !q.ignore || !(*q.ignore)(where);
  if (stands) {
    const auto hit = intersect_plane(*q.proxies[static_cast<std::size_t>(where.part)], where.face,
                                     q.origin, q.direction);
    stands = hit && hit->distance >= q.near && hit->distance <= q.far &&
             (!q.counts || (*q.counts)({where, hit->bary, hit->distance}));
  }
  if (!stands) args->valid[0] = 0;
}

}  // namespace

struct Occluder::Impl {
  std::vector<const ProxyMesh*> proxies;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Vec3 center{0};
  double half = 1;  // largest half extent in model mm
  double diagonal = 0;
  const RunContext* building = nullptr;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  void measure() {
    Box3 box;
    for (const ProxyMesh* proxy : proxies) box.add(proxy->mesh.bounds());
    if (box.empty()) return;
    const Vec3 size = box.size();
    center = box.center();
    diagonal = box.diagonal();
    const double largest = 0.5 * std::max({size.x, size.y, size.z});
    if (largest > 0 && std::isfinite(largest)) half = largest;
  }

  void check(const char* doing) const {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_CANCELLED) throw Cancelled();
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw Error(
        fmt::format("Embree failed with error {} while {}", static_cast<int>(error), doing));
  }

  void add(std::uint32_t part, const TriMesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
        std::max<std::size_t>(mesh.positions.size(), 1)));
    if (!vertices) {
      check("allocating the vertices");
      throw std::bad_alloc();
    }
    parallel_for(mesh.positions.size(), 65536, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Vec3 p = (mesh.positions[i] - center) / half;
        for (int k = 0; k < 3; ++k)
          vertices[3 * i + static_cast<std::size_t>(k)] = static_cast<float>(p[k]);
      }
    });
    if (!mesh.triangles.empty()) {
      rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                 mesh.triangles.data(), 0, sizeof(Triangle), mesh.triangles.size());
    }
    rtcSetGeometryOccludedFilterFunction(geometry, &filter_hit);
    rtcSetGeometryIntersectFilterFunction(geometry, &filter_hit);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, part);
    rtcReleaseGeometry(geometry);
  }

  void build(const RunContext& context) {
    const FlushDenormals flush;
#ifdef BURIN_THREAD_SANITIZER
    const ThreadLimit alone(1);  // it does not see what orders Embree's own tasks
#endif
    device = rtcNewDevice(nullptr);
    if (!device) {
      // Any processor of today has what Embree asks for; else it lacks memory for its threads.
      if (rtcGetDeviceError(nullptr) != RTC_ERROR_UNSUPPORTED_CPU) throw std::bad_alloc();
      throw Error("this processor lacks the instructions (SSE2) that Embree needs");
    }
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    for (std::size_t i = 0; i < proxies.size(); ++i) {
      context.check();
      add(static_cast<std::uint32_t>(i), proxies[i]->mesh);
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

  // The ray in unit coordinates, cut to the scene's bounding sphere so that a far origin costs no
  // precision. `skipped` is the part of the ray, in model mm, before its start. False where the ray
  // misses the sphere.
  bool shorten(const Query& q, RTCRay& ray, double& skipped) const {
    const Vec3 o = q.origin - center;
    const double radius =
        0.5 * diagonal + half * 1e-3;  // model mm; the margin keeps hits on the hull inside
    const double along = -glm::dot(o, q.direction);
    const Vec3 nearest = o + q.direction * along;
    const double reach2 = radius * radius - glm::dot(nearest, nearest);
    if (!(reach2 > 0)) return false;
    const double reach = std::sqrt(reach2);
    skipped = std::max(0.0, along - reach);
    const double slack = 4 * kUnitResolution * half;
    const double from = std::max(q.near - slack, skipped),
                 to = std::min(q.far + slack, along + reach);
    if (!(from <= to)) return false;
    const Vec3 start = (o + q.direction * skipped) / half;
    ray.org_x = static_cast<float>(start.x);
    ray.org_y = static_cast<float>(start.y);
    ray.org_z = static_cast<float>(start.z);
    ray.dir_x = static_cast<float>(q.direction.x);
    ray.dir_y = static_cast<float>(q.direction.y);
    ray.dir_z = static_cast<float>(q.direction.z);
    ray.tnear = static_cast<float>(std::max(0.0, from - skipped) / half);
    ray.tfar = static_cast<float>((to - skipped) / half);
    ray.time = 0;
    ray.mask = ~0u;
    ray.id = 0;
    ray.flags = 0;
    return true;
  }

  bool occluded(const Query& query) const {
    RTCRay ray;
    double skipped = 0;
    if (!shorten(query, ray, skipped)) return false;
    const FlushDenormals flush;
    Context context{{}, &query};
    rtcInitIntersectContext(&context.base);
    rtcOccluded1(scene, &context.base, &ray);
    return ray.tfar < 0;  // Embree's mark of an occluded ray: minus infinity
  }
};

Occluder::Occluder(std::span<const ProxyMesh* const> proxies, const RunContext& context)
    : impl_(std::make_unique<Impl>()) {
  impl_->proxies.assign(proxies.begin(), proxies.end());
  impl_->measure();
  impl_->build(context);
}

Occluder::~Occluder() = default;

std::optional<Hit> Occluder::first_hit(Vec3 origin, Vec3 direction, double near, double far) const {
  const Query query{origin, direction, near, far, impl_->proxies};
  RTCRayHit ray;
  double skipped = 0;
  if (!impl_->shorten(query, ray.ray, skipped)) return std::nullopt;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  {
    const FlushDenormals flush;
    Context context{{}, &query};
    rtcInitIntersectContext(&context.base);
    rtcIntersect1(impl_->scene, &context.base, &ray);
  }
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Hit hit{{static_cast<std::int32_t>(ray.hit.geomID), ray.hit.primID}, Vec3(0), 0};
  const auto exact =
      intersect_plane(*impl_->proxies[ray.hit.geomID], ray.hit.primID, origin, direction);
  hit.distance = exact->distance;
  // Single precision may see a ray inside that passes just beside the triangle.
  hit.bary = glm::max(exact->bary, Vec3(0));
  hit.bary /= hit.bary.x + hit.bary.y + hit.bary.z;
  return hit;
}

bool Occluder::occluded(Vec3 origin, Vec3 direction, double near, double far,
                        const std::function<bool(FaceRef)>& ignore) const {
  Query query{origin, direction, near, far, impl_->proxies};
  if (ignore) query.ignore = &ignore;
  return impl_->occluded(query);
}

bool Occluder::occluded_by(Vec3 origin, Vec3 direction, double near, double far,
                           const std::function<bool(const Hit&)>& counts) const {
  Query query{origin, direction, near, far, impl_->proxies};
  if (counts) query.counts = &counts;
  return impl_->occluded(query);
}

double Occluder::resolution() const { return kUnitResolution * impl_->half; }

double Occluder::diagonal() const { return impl_->diagonal; }

}  // namespace burin
