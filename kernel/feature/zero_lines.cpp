#include "zero_lines.h"

#include "paper_limits.h"
#include "zero_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// Where a line with the front side to its left leaves triangle `f`: the half-edge that runs from
/// back to front. It comes in over the one that runs from front to back.
HalfEdge exit_of(const ZeroSet& zeros, std::uint32_t f) {
  for (HalfEdge h = static_cast<HalfEdge>(3 * f);; ++h) {
    if (!zeros.front_at(h) && zeros.front_at(next_in_face(h))) return h;
  }
}

HalfEdge entry_of(const ZeroSet& zeros, std::uint32_t f) {
  for (HalfEdge h = static_cast<HalfEdge>(3 * f);; ++h) {
    if (zeros.front_at(h) && !zeros.front_at(next_in_face(h))) return h;
  }
}

/// The half-edge beyond `h`, over which a line goes on; kNoHalfEdge where it ends: at creases, and
/// at tips, where the next triangle may lie on one side.
HalfEdge beyond(const ZeroSet& zeros, HalfEdge h) {
  const auto i = static_cast<std::size_t>(h);
  if (zeros.proxy().edge_kind[i] != EdgeKind::Smooth) return kNoHalfEdge;
  const HalfEdge o = zeros.proxy().topology.opposite[i];
  return zeros.crosses(o) ? o : kNoHalfEdge;
}

class Tracer {
 public:
  Tracer(const ZeroSet& zeros, bool with_chords, const RunContext& context)
      : zeros_(zeros),
        with_chords_(with_chords),
        context_(context),
        mixed_(zeros.mixed_faces(context)),
        used_(mixed_.size(), 0) {}

  void run(const std::function<void(ZeroLine&&)>& each) {
    for (const std::uint32_t f : mixed_) {  // open ones first: they must begin at their start
      if (beyond(zeros_, entry_of(zeros_, f)) == kNoHalfEdge) trace(f, each);
    }
    for (std::size_t i = 0; i < mixed_.size(); ++i) {
      if (!used_[i]) trace(mixed_[i], each);
    }
  }

 private:
  void trace(std::uint32_t f, const std::function<void(ZeroLine&&)>& each) {
    ZeroLine line;
    line.first_face = f;
    line.closed = follow(f, line);
    if (line.closed ? closes(line) : line.points.size() >= 2) each(std::move(line));
  }

  /// Follows the line from triangle `f` on; true where it came back to `f`.
  bool follow(std::uint32_t f, ZeroLine& line) {
    const HalfEdge first = entry_of(zeros_, f);
    const ZeroCrossing start = zeros_.crossing(first);
    add(start, first, line);
    double share = start.share;
    HalfEdge entry = first;
    for (std::uint32_t at = f;;) {
      mark(at);
      const HalfEdge out = exit_of(zeros_, at);
      const double beyond_share = step(entry, share, out, line);
      const HalfEdge in = beyond(zeros_, out);
      if (in == kNoHalfEdge) return false;
      at = face_of(in);
      share = same_wedges(out, in) ? beyond_share : zeros_.crossing(in).share;
      entry = in;
      if (at == f) return true;
      // At a tip both sides of an edge may have wedges of their own, and lines may run into
      // another.
      if (used_[place(at)]) return false;
    }
  }

  /// Whether both triangles at an edge have the same normals along it: tips may have two.
  bool same_wedges(HalfEdge a, HalfEdge b) const {
    return zeros_.origin_wedge(a) == zeros_.target_wedge(b) &&
           zeros_.target_wedge(a) == zeros_.origin_wedge(b);
  }

  /// The way out of a triangle that the line came into at a share of `entry`; the share beyond
  /// `exit`.
  double step(HalfEdge entry, double share, HalfEdge exit, ZeroLine& line) {
    const ZeroCrossing zero = zeros_.crossing(exit);
    if (zero.position == line.points.back()) return zero.share_beyond;
    line.faces.push_back(static_cast<std::int32_t>(face_of(exit)));
    if (with_chords_) line.chords.push_back({bary_on(entry, share), bary_on(exit, zero.share)});
    add(zero, exit, line);
    return zero.share_beyond;
  }
  void add(const ZeroCrossing& zero, HalfEdge h, ZeroLine& line) {
    line.points.push_back(zero.position);
    line.normals.push_back(zeros_.normal(h, zero.share));
  }
  /// Drops the repeated first point of a closed line.
  static bool closes(ZeroLine& line) {
    if (line.points.size() > 1 && line.points.front() == line.points.back()) {
      line.points.pop_back();
      line.normals.pop_back();
    }
    return line.points.size() >= 3;
  }

  std::size_t place(std::uint32_t f) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(mixed_, f) - mixed_.begin());
  }
  void mark(std::uint32_t f) {
    used_[place(f)] = 1;
    if (++steps_ % 4096 == 0) context_.check();
  }

  const ZeroSet& zeros_;
  bool with_chords_;
  const RunContext& context_;
  std::vector<std::uint32_t> mixed_;
  std::vector<std::uint8_t> used_;
  std::size_t steps_ = 0;
};

}  // namespace

Curve3 ZeroLine::take_curve(const ZeroSet& zeros, LineClass kind, std::int32_t part) {
  Curve3 curve;
  curve.kind = kind;
  curve.closed = closed;
  curve.source = {part, zeros.proxy().face_region[first_face], -1};
  curve.points = std::move(points);
  curve.normals = std::move(normals);
  curve.faces = std::move(faces);
  curve.self_hidden.assign(curve.faces.size(), 0);
  return curve;
}

void trace_zeros(const ZeroSet& zeros, bool with_chords, const RunContext& context,
                 const std::function<void(ZeroLine&&)>& each) {
  Tracer(zeros, with_chords, context).run(each);
}

void follow_surface(const ZeroSet& zeros, const std::vector<Chord>& chords, Curve3& curve,
                    std::vector<std::uint8_t>& flags) {
  constexpr double kMostPieces = 16;
  Curve3 out = curve;
  std::vector<std::uint8_t> kept;
  out.points.clear(), out.normals.clear(), out.faces.clear();
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const std::size_t j = curve.next(i);
    const Vec3 &p = curve.points[i], &q = curve.points[j];
    const auto face = static_cast<std::uint32_t>(curve.faces[i]);
    const RoundedFacet facet = zeros.over(face);
    const auto over = [&](double t) {
      return zeros.between(facet, glm::mix(chords[i].in, chords[i].out, t));
    };
    const double scale = zeros.camera().scale_at(p);
    double bulge = 0;
    if (!zeros.is_straight(face, glm::distance(p, q) * scale)) {
      bulge = glm::distance(over(0.5), glm::mix(p, q, 0.5)) * scale;
      if (!zeros.is_straight()) {  // it may be an S
        for (const double t : {0.25, 0.75}) {
          const double off = glm::distance(over(t), glm::mix(p, q, t));
          bulge = std::max(bulge, off * scale);
        }
      }
    }
    const auto pieces = static_cast<std::size_t>(
        std::clamp(std::ceil(std::sqrt(bulge / kRoundness)), 1.0, kMostPieces));
    for (std::size_t k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces);
      out.points.push_back(k == 0 ? p : over(t));
      out.normals.push_back(
          k == 0 ? curve.normals[i]
                 : normalize_or(glm::mix(curve.normals[i], curve.normals[j], t), curve.normals[i]));
      out.faces.push_back(curve.faces[i]);
      kept.push_back(flags[i]);
    }
  }
  if (!curve.closed) {
    out.points.push_back(curve.points.back());
    out.normals.push_back(curve.normals.back());
  }
  out.self_hidden.assign(out.faces.size(), 0);
  curve = std::move(out);
  flags = std::move(kept);
}

}  // namespace burin
