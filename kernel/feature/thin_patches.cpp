#include <burin/base/box.h>

#include "facing.h"
#include "paper_limits.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {

namespace {

enum class Mark : std::uint8_t { Unknown, Thin, Wide };

/// Grows the patches of triangles with a corner turned to the viewer.
class PatchSearch {
 public:
  explicit PatchSearch(const Facing& facing)
      : facing_(facing),
        marks_(facing.proxy().mesh.triangles.size(), Mark::Unknown),
        widest_(std::hypot(facing.camera().paper().width, facing.camera().paper().height)) {}

  /// The patch around `f` if it is thin, else nothing. No triangle is visited twice over all calls:
  /// a patch that meets one known to be wide is wide.
  const std::vector<std::uint32_t>& thin_patch(std::uint32_t f) {
    faces_.clear();
    if (marks_[f] != Mark::Unknown) return faces_;
    Box2 box;
    double area = 0;
    bool wide = !take(f);
    for (std::size_t i = 0; i < faces_.size() && !wide; ++i) {
      area += seen_area(faces_[i], box);
      wide = area > kThinWidth * widest_ || !take_neighbours(faces_[i]);
    }
    wide = wide || area > kThinWidth * box.diagonal();
    if (wide) {
      for (const std::uint32_t g : faces_) marks_[g] = Mark::Wide;
      faces_.clear();
    }
    return faces_;
  }

 private:
  /// False where `f` is known to be wide.
  bool take(std::uint32_t f) {
    if (marks_[f] == Mark::Wide) return false;
    if (marks_[f] == Mark::Unknown) {
      marks_[f] = Mark::Thin;
      faces_.push_back(f);
    }
    return true;
  }

  bool take_neighbours(std::uint32_t f) {
    const ProxyMesh& proxy = facing_.proxy();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t h = 3 * std::size_t{f} + k;
      if (proxy.edge_kind[h] != EdgeKind::Smooth) continue;
      const auto half_edge = static_cast<HalfEdge>(h);
      if (!facing_.front_at(half_edge) && !facing_.front_at(next_in_face(half_edge))) continue;
      if (!take(face_of(proxy.topology.opposite[h]))) return false;
    }
    return true;
  }

  /// Paper mm^2 that the triangle shows; none where it is itself turned away.
  double seen_area(std::uint32_t f, Box2& box) const {
    const TriMesh& mesh = facing_.proxy().mesh;
    const Triangle& t = mesh.triangles[f];
    const Camera& camera = facing_.camera();
    const Vec2 a = camera.to_paper(mesh.positions[t[0]]), b = camera.to_paper(mesh.positions[t[1]]),
               c = camera.to_paper(mesh.positions[t[2]]);
    box.add(a);
    box.add(b);
    box.add(c);
    return std::max(0.0, 0.5 * cross2(b - a, c - a));
  }

  const Facing& facing_;
  std::vector<Mark> marks_;
  double widest_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace

void Facing::turn_thin_patches_away(const RunContext& context) {
  const std::vector<std::uint32_t> mixed = mixed_faces(context);
  if (mixed.empty()) return;
  PatchSearch search(*this);
  std::vector<std::uint32_t> away;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    if (i % 1024 == 0) context.check();
    for (const std::uint32_t f : search.thin_patch(mixed[i])) {
      for (const std::uint32_t w : proxy_->wedges[f]) away.push_back(w);
    }
  }
  for (const std::uint32_t w : away) turn_away(w);
}

}  // namespace burin
