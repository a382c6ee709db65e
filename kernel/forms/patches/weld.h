#pragma once
// Untrimmed patches as faces that meet along edges.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/charted/atlas.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace burin::detail {

using ChartList = std::vector<std::shared_ptr<const Chart>>;

/// The four sides of a chart's domain, counter-clockwise in (u,v) with t in [0,1]: 0 where v is
/// least, then 1 where u is most, 2 and 3.
Vec2 side_uv(const ParameterBox& box, int side, double t);
/// The direction that runs along a side, 0 = u, 1 = v.
inline int side_direction(int side) { return side % 2; }
/// Whether the parameter falls along a side.
inline bool side_descends(int side) { return side >= 2; }

/// One use of an edge by a side of a face.
struct SideUse {
  std::int32_t face = -1;
  int side = 0;
  std::int32_t edge = -1;
  /// Whether the side runs against the edge.
  bool backward = false;
  /// The coedge whose side gives the edge its t.
  std::int32_t master = -1;
  /// The side's own t for evenly spaced t of the edge; empty where they are the same (or 1 - t).
  std::vector<double> table = {};
};

class PatchAtlas final : public Atlas {
 public:
  explicit PatchAtlas(ChartList charts) : charts_(std::move(charts)), reversed_(charts_.size()) {}

  std::size_t face_count() const override { return charts_.size(); }
  const Chart& chart(std::int32_t face) const override {
    return *charts_[static_cast<std::size_t>(face)];
  }
  bool reversed(std::int32_t face) const override {
    return reversed_[static_cast<std::size_t>(face)] != 0;
  }
  Vec2 on_coedge(std::int32_t coedge, double t) const override;
  /// The side's own t at a t of its edge, and back.
  double side_t(std::int32_t coedge, double t) const;
  double edge_t(std::int32_t coedge, double wanted) const;

  const std::vector<SideUse>& uses() const { return uses_; }
  std::vector<SideUse>& uses() { return uses_; }
  void reverse(std::int32_t face) { reversed_[static_cast<std::size_t>(face)] ^= 1; }

 private:
  ChartList charts_;
  std::vector<std::uint8_t> reversed_;
  std::vector<SideUse> uses_;
};

/// One or two coedges; t is that of the first one's side.
struct PatchEdge {
  std::array<std::int32_t, 2> coedge{-1, -1};
  ModelEdgeClass kind = ModelEdgeClass::Boundary;
  std::array<std::uint32_t, 2> vertex{0, 0};
};

struct PatchComplex {
  std::shared_ptr<PatchAtlas> atlas;
  std::vector<PatchEdge> edges;
  /// For each face and side its coedge; -1 where the side is collapsed to a pole.
  std::vector<std::array<std::int32_t, 4>> coedge;
  /// For each face its corners: corner k is where side k begins.
  std::vector<std::array<std::uint32_t, 4>> corner;
  std::vector<Vec3> vertices;
  /// Diagonal of the box of the sides and of points between them.
  double size = 1;
  /// Edges at which the orientations of their faces contradict (a Moebius strip): left open.
  int contradictions = 0;
};

/// Finds what coincides within `tolerance` sizes. Patches with kinks inside are cut there into
/// several faces. Cost: 10 us per patch.
PatchComplex weld(const ChartList& patches, double tolerance, const RunContext& context);

/// `patches`, tiny loops of control points at their sides collapsed to one: poles that were meant
/// as such. `tolerance` as in `weld`.
ChartList mend_poles(const ChartList& patches, double tolerance);

/// `patches`, those that have kinks cut there. A kink is a knot line of chart.breaks() at which the
/// normals of both sides differ by more than kSharpAngle somewhere.
ChartList split_at_kinks(const ChartList& patches);

/// The curve of one side.
struct SideCurve {
  const Chart* chart = nullptr;
  ParameterBox box;
  int side = 0;
  std::vector<Vec3> samples;  // at even t
  Vec3 low{0}, high{0};

  Vec3 at(double t) const { return chart->position(side_uv(box, side, t)); }
  /// Derivative by t.
  Vec3 slope(double t, Vec3& point) const;
  /// The t nearest to a point, found from the given one by Newton's method.
  double nearest(Vec3 point, double t) const;
};
SideCurve side_curve(const Chart& chart, int side);

/// Whether two sides are one curve within `distance`; then which way, and the table for SideUse (b
/// by t of a).
struct SideMatch {
  bool found = false, backward = false;
  std::vector<double> table;
};
SideMatch match(const SideCurve& a, const SideCurve& b, double distance);

}  // namespace burin::detail
