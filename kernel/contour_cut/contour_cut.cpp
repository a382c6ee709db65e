#include <burin/base/parallel.h>
#include <burin/base/parallel_filter.h>
#include <burin/contour_cut/contour_cut.h>

#include "cut_mesh.h"
#include "search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

using What = Incision::What;

constexpr std::size_t kScanGrain = 4096;  // half-edges
constexpr std::size_t kWorkGrain = 64;    // edges that are evaluated, some us each

/// Every round halves what is left, from the size of the sheet to the length of a chord.
constexpr int kRounds = 40;

/// Triangles at the most: so many times those that came, and so many more. Contours are lines on
/// paper; only where a surface shows its edge everywhere do they fill it.
constexpr std::size_t kMostTimes = 3, kMostMore = 100'000;

class Cutter {
 public:
  Cutter(ChartMesh& mesh, const Sampler& surface, const Camera& camera,
         const ContourCutOptions& options, const RunContext& context)
      : context_(context),
        mesh_(mesh, surface, camera, context),
        search_(mesh_, options),
        most_(kMostTimes * mesh_.half_edge_count() + 3 * kMostMore) {}

  bool run() {
    begin();
    for (int round = 0; round < kRounds && !full(); ++round) {
      for (int i = 0; i < kRounds && mesh_.any_request(CutMesh::Cut); ++i) cut();
      if (!mesh_.any_request(CutMesh::Look) && faces_.empty()) break;
      look();
    }
    finish();
    return !full();
  }

 private:
  bool full() const { return mesh_.half_edge_count() >= most_; }

  void begin() {
    const std::size_t n = mesh_.half_edge_count();
    const auto first_of_edge = [&](HalfEdge h) {
      const HalfEdge o = mesh_.opposite(h);
      return o == kNoHalfEdge || h < o;
    };
    const auto interesting = [&](HalfEdge h) {
      return first_of_edge(h) && (search_.crosses(h) || search_.chord(h) || search_.suspect(h));
    };
    for (const HalfEdge h : parallel_filter<HalfEdge>(n, kScanGrain, interesting, context_))
      touch(h, true);
    faces_ = parallel_filter<std::uint32_t>(
        n / 3, kScanGrain, [&](std::uint32_t f) { return search_.suspect_face(f); }, context_);
  }

  template <class Find>
  std::vector<Incision> find_all(std::size_t n, const Find& find) const {
    std::vector<Incision> out(n);
    parallel_for(
        n, kWorkGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) out[i] = find(i);
        },
        &context_);
    return out;
  }

  /// Cuts all edges along which g changes its sign.
  void cut() {
    std::vector<HalfEdge> edges = mesh_.take_requests(CutMesh::Cut);
    std::erase_if(edges, [&](HalfEdge h) { return !search_.crosses(h); });
    const auto zeros =
        find_all(edges.size(), [&](std::size_t i) { return search_.zero(edges[i]); });
    mesh_.watch(edges);
    // First the vertices that contours pass through, so that nothing is cut beside them.
    for (const bool marks : {true, false}) {
      for (std::size_t i = 0; i < edges.size() && !full(); ++i) {
        if ((zeros[i].what != What::SplitEdge) != marks) continue;
        const HalfEdge h = edges[i], side = zeros[i].side == 0 ? h : mesh_.opposite(h);
        if (mesh_.sign(side) * mesh_.sign(next_in_face(side)) >= 0) continue;
        if (marks) {
          const bool first = (zeros[i].what == What::MarkOrigin) == (zeros[i].side == 0);
          mark(first ? side : next_in_face(side), zeros[i].place);
        } else {
          split(h, zeros[i].point, true);
        }
      }
    }
    mesh_.unwatch();
  }

  void mark(HalfEdge corner, const FaceSample& zero) {
    mesh_.mark_zero(corner, &zero);
    for (const HalfEdge h : mesh_.wedge(corner)) {
      touch(h, true);
      touch(prev_in_face(h), true);
      touch(next_in_face(h), false);
    }
  }

  /// Returns the other half of `h`.
  HalfEdge split(HalfEdge h, const EdgePoint& point, bool look_on) {
    const HalfEdge h2 = mesh_.split_edge(h, point), o = mesh_.opposite(h2);
    // Contours that had been hidden may go on over the edges around.
    const bool look_around = !point.zero[0] && !point.zero[1];
    touch(h, look_on);
    touch(h2, look_on);
    touch(next_in_face(h), look_on);
    touch(prev_in_face(h), look_around);
    touch(next_in_face(h2), look_around);
    if (o == kNoHalfEdge) return h2;
    const HalfEdge o2 = mesh_.opposite(h);
    touch(next_in_face(o), look_on);
    touch(prev_in_face(o), look_around);
    touch(next_in_face(o2), look_around);
    return h2;
  }

  /// Puts an edge that has changed where it belongs.
  void touch(HalfEdge h, bool look_on) {
    if (search_.crosses(h)) {
      mesh_.request(h, CutMesh::Cut);
    } else if (search_.chord(h) || (look_on && search_.suspect(h))) {
      mesh_.request(h, CutMesh::Look);
    }
  }

  /// Looks at chords of contours, and at edges and triangles that may hide some.
  void look() {
    const std::vector<HalfEdge> taken = mesh_.take_requests(CutMesh::Look);
    std::vector<HalfEdge> edges = taken;
    std::vector<std::uint32_t> faces = std::exchange(faces_, {});
    std::ranges::sort(faces);
    const auto versions = [&](HalfEdge h) {
      const HalfEdge o = mesh_.opposite(h);
      return std::pair(mesh_.version(face_of(h)), o == kNoHalfEdge ? 0 : mesh_.version(face_of(o)));
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> before;
    for (const HalfEdge h : edges) before.push_back(versions(h));
    std::vector<std::uint32_t> faces_before;
    for (const std::uint32_t f : faces) faces_before.push_back(mesh_.version(f));
    const auto found = find_all(edges.size() + faces.size(), [&](std::size_t i) {
      if (i >= edges.size()) return search_.hidden_loop(faces[i - edges.size()]);
      if (search_.chord(edges[i])) return search_.bulge(edges[i]);
      return search_.hidden_crossing(edges[i]);
    });
    mesh_.watch(edges);
    for (std::size_t i = 0; i < edges.size() && !full(); ++i) {
      if (found[i].what == What::Nothing) continue;
      if (edges[i] != taken[i] || versions(edges[i]) != before[i]) {
        mesh_.request(edges[i], CutMesh::Look);
      } else {
        apply(found[i]);
      }
    }
    mesh_.unwatch();
    for (std::size_t i = 0; i < faces.size() && !full(); ++i) {
      const Incision& incision = found[edges.size() + i];
      if (incision.what == What::Nothing) continue;
      if (mesh_.version(faces[i]) != faces_before[i]) {
        add_face(faces[i]);
      } else {
        apply(incision);
      }
    }
  }

  void apply(const Incision& incision) {
    const HalfEdge h = incision.half_edge;
    if (incision.what == What::SplitFace) {
      split_face(incision);
    } else if (incision.what == What::Detour) {
      EdgePoint point = incision.point;
      const bool fits = detour(incision, point);
      split(h, fits ? point : incision.point, !fits);
    } else {
      const bool was_chord = search_.chord(h);
      const HalfEdge h2 = split(h, incision.point, true);
      if (was_chord) return;
      for (const HalfEdge e : {h, h2, mesh_.opposite(h), mesh_.opposite(h2)}) {
        if (e != kNoHalfEdge) add_face(face_of(e));
      }
    }
  }

  void add_face(std::uint32_t f) {
    if (search_.suspect_face(f)) faces_.push_back(f);
  }

  void split_face(const Incision& incision) {
    const std::uint32_t f = incision.face;
    mesh_.split_face(f, incision.place, incision.shift);
    const auto h = static_cast<HalfEdge>(3 * f);
    for (const std::uint32_t piece :
         {f, face_of(mesh_.opposite(h + 1)), face_of(mesh_.opposite(h + 2))}) {
      const auto e = static_cast<HalfEdge>(3 * piece);
      touch(e, true);
      touch(e + 1, true);
      add_face(piece);
    }
  }

  /// The point where a contour that bulges out of edge `h` passes, as a point of that edge; false
  /// where a triangle would turn over.
  bool detour(const Incision& incision, EdgePoint& point) const {
    const HalfEdge h = incision.half_edge, o = mesh_.opposite(h);
    for (const HalfEdge corner : {h, next_in_face(h), o, next_in_face(o)}) {
      if (mesh_.pole(corner)) return false;
    }
    const std::size_t side = incision.side;
    const Vec2 shift = mesh_.uv(next_in_face(o)) - mesh_.uv(h);
    point.position = incision.place.position;
    point.uv[side] = incision.place.uv;
    point.uv[1 - side] = incision.place.uv + (side == 0 ? shift : -shift);
    point.normal = {incision.place.normal, incision.place.normal};
    point.own_g = {incision.place.g, incision.place.g};
    point.zero = {true, true};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      const HalfEdge e = k == 0 ? h : o;
      const Vec2 a = mesh_.uv(e), b = mesh_.uv(next_in_face(e)), c = mesh_.uv(prev_in_face(e));
      const Vec2 m = point.uv[k];
      const double whole = cross2(b - a, c - a), left = cross2(m - a, c - a),
                   right = cross2(b - m, c - m);
      if (!(left * whole > 0) || !(right * whole > 0)) return false;
    }
    return true;
  }

  /// Rounds are bounded and normals are blended at borders: what is left of triangles that face
  /// both ways loses its smaller value.
  void finish() {
    const auto faces_both_ways = [&](std::uint32_t f) {
      const auto h = static_cast<HalfEdge>(3 * f);
      const int a = mesh_.sign(h), b = mesh_.sign(h + 1), c = mesh_.sign(h + 2);
      return std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0;
    };
    for (const std::uint32_t f : parallel_filter<std::uint32_t>(
             mesh_.half_edge_count() / 3, kScanGrain, faces_both_ways, context_)) {
      while (faces_both_ways(f)) {
        HalfEdge least = kNoHalfEdge;
        for (auto h = static_cast<HalfEdge>(3 * f); h < static_cast<HalfEdge>(3 * f + 3); ++h) {
          if (mesh_.sign(h) == 0) continue;
          if (least < 0 || std::abs(mesh_.g(h)) < std::abs(mesh_.g(least))) least = h;
        }
        mesh_.mark_zero(least, nullptr);
      }
    }
  }

  const RunContext& context_;
  CutMesh mesh_;
  CutSearch search_;
  std::size_t most_;  // half-edges
  std::vector<std::uint32_t> faces_;
};

}  // namespace

bool cut_along_contours(ChartMesh& mesh, const Sampler& surface, const Camera& camera,
                        const ContourCutOptions& options, const RunContext& context) {
  return mesh.triangles.empty() || Cutter(mesh, surface, camera, options, context).run();
}

void add_contours_bounded(Diagnostics& diagnostics) {
  diagnostics.add(Severity::Warning, "surface.contours_bounded", 1,
                  "a part is edge-on in so many places that its contours were not all found; "
                  "look from another direction");
}

}  // namespace burin
