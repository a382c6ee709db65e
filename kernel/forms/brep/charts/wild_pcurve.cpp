#include "wild_pcurve.h"

#include <burin/base/vec.h>

#include "occt_vec.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace burin {
namespace {

/// Share of the part. As of stray faces: whole files, the sloppiest too, stay under 5e-4.
constexpr double kBeside = 0.01;
/// How far beyond a surface, in sizes of it, its edges are compared with those in space, and how
/// far OCCT is not asked. Faces that begin in one turn and end in the next stay under the first.
constexpr double kCompared = 0.5, kHopeless = 10;
/// Places on a curve: of a spline so many a pole.
constexpr int kPlaces = 8, kPlacesOfPole = 4, kMostPlaces = 400;

Handle(Geom2d_Curve) untrimmed(const Handle(Geom2d_Curve) & curve) {
  const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve);
  return trimmed.IsNull() ? curve : trimmed->BasisCurve();
}

const TColgp_Array1OfPnt2d* poles_of(const Handle(Geom2d_Curve) & curve) {
  const Handle(Geom2d_Curve) basis = untrimmed(curve);
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(basis)) return &spline->Poles();
  if (const auto bezier = Handle(Geom2d_BezierCurve)::DownCast(basis)) return &bezier->Poles();
  return nullptr;
}

/// How far beyond the ends of a surface a parameter is, as a share of what lies between them.
double beyond(double x, double from, double to) {
  if (Precision::IsInfinite(from) || Precision::IsInfinite(to) || !(to > from)) return 0;
  return std::max({0.0, (from - x) / (to - from), (x - to) / (to - from)});
}

class Domain {
 public:
  explicit Domain(Handle(Geom_Surface) surface) {
    // The surface goes on beyond its trims, and files take it there.
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
      surface = trimmed->BasisSurface();
    }
    surface->Bounds(from_.x, to_.x, from_.y, to_.y);
    periodic_ = {surface->IsUPeriodic(), surface->IsVPeriodic()};
  }

  double beyond(Vec2 uv) const {
    return std::max(burin::beyond(uv.x, from_.x, to_.x), burin::beyond(uv.y, from_.y, to_.y));
  }
  /// The same, but for directions in which the surface comes again.
  double beyond_ends(Vec2 uv) const {
    return std::max(periodic_[0] ? 0 : burin::beyond(uv.x, from_.x, to_.x),
                    periodic_[1] ? 0 : burin::beyond(uv.y, from_.y, to_.y));
  }

 private:
  Vec2 from_{0}, to_{0};
  std::array<bool, 2> periodic_{};
};

/// A spline stays within its poles.
bool stays(const TColgp_Array1OfPnt2d& poles, const Domain& domain) {
  return std::all_of(poles.begin(), poles.end(),
                     [&](const gp_Pnt2d& p) { return domain.beyond(to_vec(p)) <= kCompared; });
}

/// Shares of the way along a curve at which it may be beyond the surface.
int places(const EdgeInFace& use, const Domain& domain) {
  if (const TColgp_Array1OfPnt2d* poles = poles_of(use.curve)) {
    return stays(*poles, domain) ? 0 : std::min(kPlacesOfPole * poles->Size(), kMostPlaces);
  }
  return untrimmed(use.curve)->IsKind(STANDARD_TYPE(Geom2d_Line)) ? 1 : kPlaces;
}

Vec2 at(const EdgeInFace& use, double share) {
  return to_vec(use.curve->Value(use.first + share * (use.last - use.first)));
}

double distance_from_edge(const EdgeInFace& use, Vec2 uv, double share) {
  const double t = use.edge_first + share * (use.edge_last - use.edge_first);
  return use.surface->Value(uv.x, uv.y).Distance(use.edge->Value(t));
}

}  // namespace

bool has_sound_poles(const Handle(Geom2d_Curve) & curve) {
  constexpr double kFarthest = 1e7;  // times the usual distance from the origin, or 1
  const TColgp_Array1OfPnt2d* poles = poles_of(curve);
  if (!poles) return true;
  std::vector<double> far;
  for (const gp_Pnt2d& p : *poles) {
    far.push_back(std::abs(p.X()) + std::abs(p.Y()));
    if (!std::isfinite(far.back())) return false;
  }
  std::ranges::sort(far);
  return far.back() <= kFarthest * std::max(1.0, far[far.size() / 2]);
}

bool leaves_edge(const EdgeInFace& use, double size) {
  if (use.edge.IsNull() || !(size > 0)) return false;
  const Domain domain(use.surface);
  const int n = places(use, domain);
  for (int i = 0; n > 0 && i <= n; ++i) {
    const double share = static_cast<double>(i) / n;
    const Vec2 uv = at(use, share);
    if (domain.beyond(uv) <= kCompared) continue;
    // Not a number is beside it too.
    if (!(distance_from_edge(use, uv, share) <= kBeside * size)) return true;
  }
  return false;
}

bool leaves_surface(const EdgeInFace& use) {
  const Domain domain(use.surface);
  const int n = places(use, domain);
  for (int i = 0; n > 0 && i <= n; ++i) {
    if (domain.beyond_ends(at(use, static_cast<double>(i) / n)) > kHopeless) return true;
  }
  return false;
}

}  // namespace burin
