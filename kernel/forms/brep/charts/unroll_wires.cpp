#include "unroll_wires.h"

#include <burin/base/vec.h>

#include "contain.h"
#include "occt_vec.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

/// Share of a turn within which ends of curves that follow each other meet.
constexpr double kMeet = 1e-3;
/// Times the tolerance of an edge: farther from itself it is no point.
constexpr double kNoPoint = 10;

/// The surface of a face, and how far apart its turns are; 0 where it does not come again.
struct Turns {
  Handle(Geom_Surface) surface;
  Vec2 period{0};

  explicit Turns(const TopoDS_Face& face) : surface(BRep_Tool::Surface(face)) {
    if (surface.IsNull()) return;
    if (surface->IsUPeriodic()) period.x = surface->UPeriod();
    if (surface->IsVPeriodic()) period.y = surface->VPeriod();
  }
  bool any() const { return period.x > 0 || period.y > 0; }
};

/// One edge of a wire as the face uses it.
struct Use {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;
  Vec2 shift{0};

  Vec2 end(bool begins) const {
    const bool at_first = begins == (edge.Orientation() != TopAbs_REVERSED);
    return to_vec(curve->Value(at_first ? first : last)) + shift;
  }
};

Use use_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Use use{edge, {}};
  use.curve = BRep_Tool::CurveOnSurface(edge, face, use.first, use.last);
  return use;
}

/// Whether an edge that is called a point leads somewhere.
bool leads_round(const Use& use, const Turns& turns) {
  if (!BRep_Tool::Degenerated(use.edge) || use.curve.IsNull()) return false;
  const auto at = [&](double share) {
    const gp_Pnt2d uv = use.curve->Value(use.first + share * (use.last - use.first));
    return turns.surface->Value(uv.X(), uv.Y());
  };
  constexpr double kPlace = 0.37;  // no half of a turn
  return at(0).Distance(at(kPlace)) > kNoPoint * BRep_Tool::Tolerance(use.edge);
}

/// A wire of the face that is turned forward, without edges that lead round.
struct Wire {
  TopoDS_Wire wire;
  std::vector<Use> uses;
  bool changed = false;
};

Wire wire_of(const TopoDS_Wire& wire, const TopoDS_Face& face, const Turns& turns) {
  Wire out{wire, {}};
  for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
    const Use use = use_of(TopoDS::Edge(it.Value()), face);
    if (leads_round(use, turns)) {
      out.changed = true;
    } else {
      out.uses.push_back(use);
    }
  }
  return out;
}

/// What is left of a gap once whole turns are taken from it.
double whole_turns(double& gap, double period) {
  const double turns = period > 0 ? period * std::round(gap / period) : 0;
  gap -= turns;
  return turns;
}

bool meets(Vec2 gap, const Turns& turns) {
  const double turn = std::max(turns.period.x, turns.period.y);
  return std::abs(gap.x) <= kMeet * turn && std::abs(gap.y) <= kMeet * turn;
}

/// Whether each curve ends where some curve begins, in whatever order they stand.
bool is_closed(const Wire& wire, const Turns& turns) {
  return std::ranges::all_of(wire.uses, [&](const Use& use) {
    return std::ranges::any_of(
        wire.uses, [&](const Use& next) { return meets(use.end(false) - next.end(true), turns); });
  });
}

/// Whether curves do not meet, and one begins whole turns from where the one before ends.
bool is_torn(const Wire& wire, const Turns& turns) {
  if (std::ranges::any_of(wire.uses, [](const Use& use) { return use.curve.IsNull(); })) {
    return false;
  }
  for (std::size_t i = 1; i < wire.uses.size(); ++i) {
    Vec2 gap = wire.uses[i - 1].end(false) - wire.uses[i].end(true);
    const double u = whole_turns(gap.x, turns.period.x), v = whole_turns(gap.y, turns.period.y);
    if ((u != 0 || v != 0) && meets(gap, turns)) return !is_closed(wire, turns);
  }
  return false;
}

/// Whether the two uses of a seam lie on each other: a wire out of order, which holds nothing.
bool folds(const Wire& wire, const Turns& turns) {
  for (std::size_t i = 1; i < wire.uses.size(); ++i) {
    const Use& use = wire.uses[i];
    const auto before = wire.uses.begin() + static_cast<std::ptrdiff_t>(i);
    const auto other = std::find_if(wire.uses.begin(), before,
                                    [&](const Use& u) { return u.edge.IsSame(use.edge); });
    if (other != before && meets(other->end(true) - use.end(false), turns)) return true;
  }
  return false;
}

/// Moves each curve to the end of the one before. Whether the wire closes around something.
bool unroll(Wire& wire, const Turns& turns) {
  if (wire.uses.empty()) return false;
  for (const Use& use : wire.uses) {
    if (use.curve.IsNull()) return false;
  }
  for (std::size_t i = 1; i < wire.uses.size(); ++i) {
    Use& use = wire.uses[i];
    Vec2 gap = wire.uses[i - 1].end(false) - use.end(true);
    use.shift.x += whole_turns(gap.x, turns.period.x);
    use.shift.y += whole_turns(gap.y, turns.period.y);
    if (!meets(gap, turns)) return false;
  }
  return meets(wire.uses.back().end(false) - wire.uses.front().end(true), turns) &&
         !folds(wire, turns);
}

Handle(Geom2d_Curve) moved(const Use& use) {
  return Handle(Geom2d_Curve)::DownCast(use.curve->Translated(gp_Vec2d(use.shift.x, use.shift.y)));
}

void set_curves(const Wire& wire, const TopoDS_Face& face) {
  const BRep_Builder builder;
  for (const Use& use : wire.uses) {
    const double tolerance = BRep_Tool::Tolerance(use.edge);
    const auto other = std::ranges::find_if(wire.uses, [&](const Use& u) {
      return u.edge.IsSame(use.edge) && u.edge.Orientation() != use.edge.Orientation();
    });
    if (other == wire.uses.end()) {
      builder.UpdateEdge(use.edge, moved(use), face, tolerance);
    } else if (use.edge.Orientation() == TopAbs_FORWARD) {
      builder.UpdateEdge(use.edge, moved(use), moved(*other), face, tolerance);
    } else {
      continue;
    }
    builder.Range(use.edge, face, use.first, use.last);
  }
}

TopoDS_Shape without_rounds(const TopoDS_Face& face, const std::vector<Wire>& wires) {
  const BRep_Builder builder;
  const TopoDS_Shape made = face.EmptyCopied();
  for (const Wire& wire : wires) {
    TopoDS_Shape kept = wire.wire.EmptyCopied();
    for (const Use& use : wire.uses) builder.Add(kept, use.edge);
    kept.Closed(wire.wire.Closed());
    TopoDS_Shape target = made;
    builder.Add(target, kept);
  }
  return made;
}

/// Null where there is nothing to mend, or it fails.
TopoDS_Shape mended_face(const TopoDS_Face& face) {
  const Turns turns(face);
  if (turns.surface.IsNull() || !turns.any()) return {};
  std::vector<Wire> wires;
  bool changed = false;
  for (TopoDS_Iterator it(face); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_WIRE) return {};
    wires.push_back(wire_of(TopoDS::Wire(it.Value()), face, turns));
    wires.back().changed |= is_torn(wires.back(), turns);
    changed |= wires.back().changed;
  }
  if (!changed) return {};
  for (Wire& wire : wires) {
    if (wire.changed && !unroll(wire, turns)) return {};
  }
  for (const Wire& wire : wires) {
    if (wire.changed) set_curves(wire, face);
  }
  return without_rounds(face, wires);
}

}  // namespace

TopoDS_Shape unroll_wires(const TopoDS_Shape& shape) {
  BRepTools_ReShape changes;
  bool any = false;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
    contained([&] {
      const TopoDS_Shape better = mended_face(face);
      if (better.IsNull()) return;
      changes.Replace(face, better);
      any = true;
    });
  }
  return any ? changes.Apply(shape) : shape;
}

}  // namespace burin
