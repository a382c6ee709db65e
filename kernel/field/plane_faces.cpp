#include "plane_faces.h"

#include "fallback.h"
#include "flat_patches.h"

namespace burin::field {
namespace {

class Planes {
 public:
  Planes(const Surface& surface, const std::vector<FaceKind>& kinds, const SmoothedOptions& options,
         const RunContext& context)
      : surface_(surface),
        proxy_(surface.proxy()),
        kinds_(kinds),
        options_(options),
        context_(context) {}

  FlatPatches run() {
    out_.face_patch.assign(kinds_.size(), -1);
    for (std::uint32_t f = 0; f < kinds_.size(); ++f) {
      if (f % 4096 == 0) context_.check();
      if (kinds_[f] == FaceKind::Plane && out_.face_patch[f] < 0) grow(f);
    }
    collect();
    for (std::size_t p = 0; p < outline_.size(); ++p) {
      if (p % 64 == 0) context_.check();
      out_.patches.push_back(with_cross(p));
    }
    return std::move(out_);
  }

 private:
  Vec3 corner(HalfEdge h) const { return proxy_.mesh.positions[origin(proxy_.mesh, h)]; }
  HalfEdge smooth_opposite(HalfEdge h) const {
    const auto i = static_cast<std::size_t>(h);
    return proxy_.edge_kind[i] == EdgeKind::Smooth ? proxy_.topology.opposite[i] : kNoHalfEdge;
  }

  void grow(std::uint32_t seed) {
    const std::int32_t patch = count_++;
    std::vector<std::uint32_t> stack{seed};
    out_.face_patch[seed] = patch;
    while (!stack.empty()) {
      const auto first = static_cast<HalfEdge>(3 * stack.back());
      stack.pop_back();
      for (HalfEdge h = first; h < first + 3; ++h) {
        const HalfEdge o = smooth_opposite(h);
        if (o == kNoHalfEdge) continue;
        const std::uint32_t f = face_of(o);
        if (kinds_[f] != FaceKind::Plane || out_.face_patch[f] >= 0) continue;
        out_.face_patch[f] = patch;
        stack.push_back(f);
      }
    }
  }

  void collect() {
    outline_.resize(static_cast<std::size_t>(count_));
    area_vector_.assign(outline_.size(), Vec3(0));
    for (std::uint32_t f = 0; f < kinds_.size(); ++f) {
      if (out_.face_patch[f] < 0) continue;
      const auto p = static_cast<std::size_t>(out_.face_patch[f]);
      area_vector_[p] += proxy_.mesh.area(f) * proxy_.mesh.normal(f);
      for (HalfEdge h = static_cast<HalfEdge>(3 * f); h < static_cast<HalfEdge>(3 * f + 3); ++h) {
        const HalfEdge o = smooth_opposite(h);
        if (o == kNoHalfEdge || out_.face_patch[face_of(o)] < 0) outline_[p].push_back(h);
      }
    }
  }

  // The direction that strokes have behind a smooth border.
  Vec3 direction_behind(HalfEdge other, Vec3 otherwise) const {
    ProxyPoint middle{face_of(other), Vec3(0)};
    middle.bary[other % 3] = middle.bary[next_in_face(other) % 3] = 0.5;
    const Frame frame = surface_.frame(surface_.lift(middle));
    return !frame.umbilic && frame.confidence > kSure ? frame.d1 : otherwise;
  }

  FlatPatch with_cross(std::size_t p) const {
    const Vec3 normal = normalize_or(area_vector_[p], Vec3(0, 0, 1));
    FlatPatch plain;
    plain.normal = normal;
    plain.arms.first = fallback_tangent(options_.fallback, normal);
    plain.arms.second = glm::cross(normal, plain.arms.first);
    if (options_.policy.plane == FacePolicy::Plane::Direction) return plain;
    std::vector<OutlineEdge> edges;
    for (const HalfEdge h : outline_[p]) {
      const Vec3 a = corner(h), b = corner(next_in_face(h));
      if (a == b) continue;
      const HalfEdge o = smooth_opposite(h);
      const bool smooth = o != kNoHalfEdge;
      edges.push_back({0.5 * (a + b), b - a, smooth, smooth ? direction_behind(o, b - a) : b - a});
    }
    return flat_cross(normal, edges, options_.fallback).value_or(plain);
  }

  const Surface& surface_;
  const ProxyMesh& proxy_;
  const std::vector<FaceKind>& kinds_;
  const SmoothedOptions& options_;
  const RunContext& context_;
  FlatPatches out_;
  std::int32_t count_ = 0;
  std::vector<std::vector<HalfEdge>> outline_;
  std::vector<Vec3> area_vector_;
};

}  // namespace

FlatPatches find_plane_faces(const Surface& surface, const std::vector<FaceKind>& kinds,
                             const SmoothedOptions& options, const RunContext& context) {
  return Planes(surface, kinds, options, context).run();
}

}  // namespace burin::field
