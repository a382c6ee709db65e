#include "flat_patches.h"

#include <burin/base/parallel.h>

#include "flat_cross.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace burin::field {
namespace {

constexpr std::size_t kFlatGrain = 8192;
// A smooth region whose normals stay this near their mean (root mean square, radians) is flat as a
// whole.
constexpr double kFlatRegion = 0.01;
// Largest distance from the plane of a patch, as a share of the part's diagonal: the rounding of
// files with five digits, and less than any pen can show.
constexpr double kPlanar = 5e-5;
// Neighbouring triangles of a flat part meet at less than this angle (radians), or differ by no
// more than rounding to single precision: this share of the part's diagonal.
constexpr double kFlatAngle = 0.01;
constexpr double kRounding = 2e-7;
// A flat part with a smooth border is at least this share of the diagonal wide ...
constexpr double kMinWidth = 0.02;
// ... and, along at least this share of the border, this many times as wide as the facets behind
// the border ...
constexpr double kBorderShare = 0.6;
constexpr double kWider = 3;
// ... and this many times less bent: on a gently curved surface patches end by chance, not at a
// bend.
constexpr double kStraighter = 8;
// Border edges that are looked at, at the most.
constexpr std::size_t kMaxSamples = 48;
// ... and a part that is not exactly flat (its triangles are off by more than this, radians) would
// turn by so much over its width if it bent on like the facets behind.
constexpr double kExact = 5e-4;
constexpr double kBend = 0.35;

class Finder {
 public:
  Finder(const ProxyMesh& proxy, const std::vector<Frame>& frames, Vec3 fallback,
         const RunContext& context)
      : proxy_(proxy),
        frames_(frames),
        fallback_(fallback),
        context_(context),
        size_(proxy.mesh.bounds().diagonal()) {}

  FlatPatches run() {
    measure_faces();
    claim_flat_regions();
    grow_all();
    collect_outlines();
    measure_bends();
    FlatPatches result;
    result.face_patch.assign(patch_.size(), -1);
    std::vector<std::int32_t> renamed(outline_.size(), -1);
    for (std::size_t p = 0; p < outline_.size(); ++p) {
      if (p % 1024 == 0) context_.check();
      if (!is_flat(p)) continue;
      const auto patch = with_cross(p);
      if (!patch) continue;
      renamed[p] = static_cast<std::int32_t>(result.patches.size());
      result.patches.push_back(*patch);
    }
    for (std::size_t f = 0; f < patch_.size(); ++f) {
      if (patch_[f] >= 0) result.face_patch[f] = renamed[static_cast<std::size_t>(patch_[f])];
    }
    return result;
  }

 private:
  std::size_t faces() const { return proxy_.mesh.triangles.size(); }
  Vec3 corner(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }
  // The other side of a smooth edge. A triangle that is folded back, as the rounding of a hole's
  // rim leaves them on the face around it, is no continuation.
  HalfEdge smooth_opposite(HalfEdge h) const {
    const auto i = static_cast<std::size_t>(h);
    const HalfEdge other = proxy_.topology.opposite[i];
    if (proxy_.edge_kind[i] != EdgeKind::Smooth || other == kNoHalfEdge) return kNoHalfEdge;
    return glm::dot(normal_[face_of(h)], normal_[face_of(other)]) < 0 ? kNoHalfEdge : other;
  }

  // Whether the triangle behind the smooth half-edge `h` goes on in the plane of its own triangle.
  bool goes_on(HalfEdge h, HalfEdge other) const {
    const Vec3 n = normal_[face_of(h)], m = normal_[face_of(other)];
    const double off = std::abs(glm::dot(corner(prev_in_face(other)) - corner(other), n));
    if (off <= kRounding * size_) return glm::dot(n, m) > 0;
    return glm::dot(n, m) > 0 && glm::length(glm::cross(n, m)) < kFlatAngle;
  }

  void measure_faces() {
    normal_.resize(faces());
    area_.resize(faces());
    parallel_for(
        faces(), kFlatGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t f = begin; f < end; ++f) {
            normal_[f] = proxy_.mesh.normal(static_cast<std::uint32_t>(f));
            area_[f] = proxy_.mesh.area(static_cast<std::uint32_t>(f));
          }
        },
        &context_);
  }

  // Regions that are flat but for noise become patches first, whatever their triangles look like.
  void claim_flat_regions() {
    const auto count = static_cast<std::size_t>(proxy_.region_count);
    std::vector<Vec3> mean(count, Vec3(0));
    std::vector<double> area(count, 0), bend(count, 0);
    const auto region = [&](std::size_t f) {
      return static_cast<std::size_t>(proxy_.face_region[f]);
    };
    for (std::size_t f = 0; f < faces(); ++f) {
      mean[region(f)] += area_[f] * normal_[f];
      area[region(f)] += area_[f];
    }
    for (Vec3& n : mean) n = normalize_or(n, Vec3(0));
    for (std::size_t f = 0; f < faces(); ++f) {
      const Vec3 off = normal_[f] - mean[region(f)];
      bend[region(f)] += area_[f] * glm::dot(off, off);
    }
    std::vector<std::int32_t> patch(count, -1);
    for (std::size_t r = 0; r < count; ++r) {
      if (bend[r] <= kFlatRegion * kFlatRegion * area[r]) patch[r] = patch_count_++;
    }
    patch_.resize(faces());
    for (std::size_t f = 0; f < faces(); ++f) patch_[f] = patch[region(f)];
  }

  // Triangles that could lie in a flat part, largest first (by powers of two).
  std::vector<std::uint32_t> seeds() {
    std::vector<std::int32_t> key(faces(), -1);
    parallel_for(
        faces(), kFlatGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t f = begin; f < end; ++f) {
            if (patch_[f] < 0 && area_[f] > 0 && may_be_flat(static_cast<HalfEdge>(3 * f)))
              key[f] = magnitude(area_[f]);
          }
        },
        &context_);
    std::array<std::vector<std::uint32_t>, kMagnitudes> buckets;
    for (std::uint32_t f = 0; f < faces(); ++f) {
      if (key[f] >= 0) buckets[static_cast<std::size_t>(key[f])].push_back(f);
    }
    std::vector<std::uint32_t> order;
    for (const auto& bucket : buckets) order.insert(order.end(), bucket.begin(), bucket.end());
    return order;
  }

  static constexpr int kMagnitudes = 64;
  int magnitude(double area) const {
    return std::clamp(-std::ilogb(area / (size_ * size_)), 0, kMagnitudes - 1);
  }

  bool may_be_flat(HalfEdge first) const {
    bool alone = true;
    for (HalfEdge h = first; h < first + 3; ++h) {
      const HalfEdge other = smooth_opposite(h);
      if (other == kNoHalfEdge) continue;
      alone = false;
      if (goes_on(h, other)) return true;
    }
    return alone || area_[face_of(first)] > kMinWidth * kMinWidth * size_ * size_;
  }

  void grow_all() {
    for (const std::uint32_t seed : seeds()) {
      if (patch_[seed] < 0) grow(seed, patch_count_++);
    }
    context_.check();
  }

  void grow(std::uint32_t seed, std::int32_t patch) {
    const Vec3 n = normal_[seed], p = corner(static_cast<HalfEdge>(3 * seed));
    std::vector<std::uint32_t> stack{seed};
    patch_[seed] = patch;
    while (!stack.empty()) {
      const auto first = static_cast<HalfEdge>(3 * stack.back());
      stack.pop_back();
      for (HalfEdge h = first; h < first + 3; ++h) {
        const HalfEdge other = smooth_opposite(h);
        if (other == kNoHalfEdge || patch_[face_of(other)] >= 0 || !goes_on(h, other)) continue;
        if (std::abs(glm::dot(corner(prev_in_face(other)) - p, n)) > kPlanar * size_) continue;
        patch_[face_of(other)] = patch;
        stack.push_back(face_of(other));
      }
    }
  }

  void collect_outlines() {
    outline_.resize(static_cast<std::size_t>(patch_count_));
    area_vector_.assign(outline_.size(), Vec3(0));
    for (std::uint32_t f = 0; f < faces(); ++f) {
      if (patch_[f] < 0) continue;
      const auto p = static_cast<std::size_t>(patch_[f]);
      area_vector_[p] += area_[f] * normal_[f];
      for (HalfEdge h = static_cast<HalfEdge>(3 * f); h < static_cast<HalfEdge>(3 * f + 3); ++h) {
        const HalfEdge other = smooth_opposite(h);
        if (other == kNoHalfEdge || patch_[face_of(other)] != patch_[f]) outline_[p].push_back(h);
      }
    }
  }

  // Root mean square angle between a patch's triangles and its plane.
  void measure_bends() {
    bend_.assign(outline_.size(), 0);
    std::vector<double> area(outline_.size(), 0);
    for (std::size_t f = 0; f < faces(); ++f) {
      if (patch_[f] < 0) continue;
      const auto p = static_cast<std::size_t>(patch_[f]);
      const Vec3 off = normal_[f] - normalize_or(area_vector_[p], normal_[f]);
      bend_[p] += area_[f] * glm::dot(off, off);
      area[p] += area_[f];
    }
    for (std::size_t p = 0; p < bend_.size(); ++p) bend_[p] = std::sqrt(bend_[p] / area[p]);
  }

  // How far the patch of `h`'s triangle (or that triangle alone) reaches from the edge, in its
  // plane.
  double width_behind(HalfEdge h) const {
    const Vec3 a = corner(h), along = normalize_or(corner(next_in_face(h)) - a, Vec3(0));
    const Vec3 inwards = glm::cross(normal_[face_of(h)], along);
    double width = glm::dot(corner(prev_in_face(h)) - a, inwards);
    const std::int32_t p = patch_[face_of(h)];
    if (p < 0) return width;
    for (const HalfEdge o : outline_[static_cast<std::size_t>(p)]) {
      width = std::max(width, glm::dot(corner(o) - a, inwards));
    }
    return width;
  }

  bool is_flat(std::size_t p) const {
    std::vector<HalfEdge> smooth;
    for (const HalfEdge h : outline_[p]) {
      if (smooth_opposite(h) != kNoHalfEdge) smooth.push_back(h);
    }
    if (smooth.empty()) return true;
    Box3 box;
    for (const HalfEdge h : outline_[p]) box.add(corner(h));
    if (box.diagonal() < kMinWidth * size_) return false;
    const std::size_t stride = (smooth.size() + kMaxSamples - 1) / kMaxSamples;
    double border = 0, wider = 0;
    for (std::size_t i = 0; i < smooth.size(); i += stride) {
      const double length = glm::distance(corner(smooth[i]), corner(next_in_face(smooth[i])));
      border += length;
      if (ends_at(p, smooth[i])) wider += length;
    }
    return wider >= kBorderShare * border;
  }

  // Whether the patch ends at the smooth edge `h` because the surface begins to bend there.
  bool ends_at(std::size_t p, HalfEdge h) const {
    const HalfEdge other = smooth_opposite(h);
    const double own = width_behind(h), behind = width_behind(other);
    if (own < kMinWidth * size_ || own < kWider * behind) return false;
    const double turn =
        glm::length(glm::cross(normalize_or(area_vector_[p], Vec3(0)), normal_[face_of(other)]));
    const double least = bend_[p] < kExact ? 0 : kBend;
    return turn * own > std::max(kStraighter * bend_[p], least) * behind;
  }

  std::optional<FlatPatch> with_cross(std::size_t p) const {
    std::vector<OutlineEdge> edges;
    for (const HalfEdge h : outline_[p]) {
      const Vec3 a = corner(h), b = corner(next_in_face(h));
      if (a == b) continue;
      OutlineEdge edge{0.5 * (a + b), b - a, smooth_opposite(h) != kNoHalfEdge, b - a};
      const Frame& f = frames_[proxy_.wedges[face_of(h)][static_cast<std::size_t>(h % 3)]];
      if (edge.smooth && f.confidence > kSure) edge.arm = f.d1;
      edges.push_back(edge);
    }
    return flat_cross(normalize_or(area_vector_[p], Vec3(0, 0, 1)), edges, fallback_);
  }

  const ProxyMesh& proxy_;
  const std::vector<Frame>& frames_;
  Vec3 fallback_;
  const RunContext& context_;
  double size_;
  std::vector<Vec3> normal_;
  std::vector<double> area_;
  std::vector<std::int32_t> patch_;
  std::vector<std::vector<HalfEdge>> outline_;
  std::vector<Vec3> area_vector_;
  std::vector<double> bend_;
  std::int32_t patch_count_ = 0;
};

}  // namespace

FlatPatches find_flat_patches(const ProxyMesh& proxy, const std::vector<Frame>& frames,
                              Vec3 fallback, const RunContext& context) {
  return Finder(proxy, frames, fallback, context).run();
}

}  // namespace burin::field
