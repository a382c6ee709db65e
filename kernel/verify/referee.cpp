#include <burin/base/error.h>
#include <burin/feature/light_normals.h>
#include <burin/mesh/chord_error.h>
#include <burin/surface/nearest_on.h>
#include <burin/verify/referee.h>
#include <burin/visibility/sight_ray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace burin {
namespace {

constexpr int kDirections = 12;
// A tessellation that fails is tried again this much coarser, so often.
constexpr double kCoarser = 2;
constexpr int kTries = 4;

// line_near: paper mm, and times what the slopes of both places explain, from which depths make a
// jump.
constexpr double kJump = 0.05;
constexpr double kSteeper = 2;

// test: times its slope that a sheet may rise between two places and be one: a sheet that folds
// like a parabola at its contour lies twice as deep as its slope says.
constexpr double kFolds = 3;
// Steepest slope (depth over what is across) that anything is asked for.
constexpr double kSteepest = 1000;
// behind_another: a sheet is so many times nearer to the point than the one before it, and that one
// is farther than so much of the slack, twice what the fine tessellation alone may be off.
constexpr double kMuchNearer = 3;
constexpr double kFineShare = 0.4;
// A hidden line is in the open where a sheet no steeper than that is seen at it.
constexpr double kSquarely = 3;
// Of the radius, beside a contour: what the fine facets may be off its line.
constexpr double kClosely = 0.25;
// Of the radius, beside a border of a sheet that is seen from its edge.
constexpr double kBesideSheet = 0.75;
// Times the radius, where facets may lie that far from the line that is drawn round.
constexpr double kWidest = 8;

Vec2 around(int i, int count) {
  const double a = 2 * std::numbers::pi * i / count;
  return {std::cos(a), std::sin(a)};
}

double slope_of(double cosine) {
  const double c = std::max(std::abs(cosine), 1 / kSteepest);
  return std::sqrt(std::max(0.0, 1 - c * c)) / c;
}

}  // namespace

const char* to_string(Finding finding) {
  switch (finding) {
    case Finding::Holds:
      return "holds";
    case Finding::Covered:
      return "covered";
    case Finding::Open:
      return "open";
    case Finding::Adrift:
      return "adrift";
  }
  return "";
}

FineSurfaces fine_surfaces(const Scene& scene, double tolerance, const std::vector<bool>& parts,
                           const std::vector<double>& crease_angles, RunContext& context) {
  FineSurfaces surfaces;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    surfaces.push_back(nullptr);
    if (!parts.empty() && !parts[i]) continue;
    RealiseOptions options;
    options.tolerance = tolerance;
    options.curvature = false;
    if (i < crease_angles.size()) options.crease_angle = crease_angles[i];
    for (int t = 0; t < kTries && !surfaces.back(); ++t, options.tolerance *= kCoarser) {
      try {
        surfaces.back() = scene.parts[i].form->realise(options, context);
      } catch (const GeometryError&) {
        // Tried again; a part without surface is told by whoever asked.
      }
    }
  }
  return surfaces;
}

/// What a ray from the viewer meets first.
struct Referee::Sight {
  Vec2 paper{0};
  Vec3 place{0};
  std::int32_t part = -1, face = -1;
  double depth = 0;   // the camera's: model mm, larger is nearer
  double slope = 0;   // model mm of depth a model mm across
  double chord = 0;   // model mm that the triangle may be off
  double cosine = 1;  // between its triangle and the view
  ProxyPoint point;
};

/// A point of a line.
struct Referee::Point {
  Vec3 model{0};
  Vec2 paper{0};
  double depth = 0;
  double scale = 1;  // paper mm a model mm there
};

Referee::Referee(FineSurfaces surfaces, const Camera& camera, const RefereeOptions& options,
                 const RunContext& context)
    : surfaces_(std::move(surfaces)), camera_(camera), options_(options) {
  static const ProxyMesh nothing;
  for (const auto& surface : surfaces_) proxies_.push_back(surface ? &surface->proxy() : &nothing);
  occluder_ =
      std::make_unique<Occluder>(proxies_, context, OccluderOptions{.ranks = options.ranks});
}

Referee::Sight Referee::describe(const Hit& hit, Vec2 paper) const {
  const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(hit.where.part)];
  const Vec3 place = proxy.position(hit.where.face, hit.bary);
  const Vec3 view = camera_.to_viewer(place);
  const double smooth = glm::dot(proxy.normal(hit.where.face, hit.bary), view);
  const double flat = glm::dot(proxy.mesh.normal(hit.where.face), view);
  return {.paper = paper,
          .place = place,
          .part = hit.where.part,
          .face = proxy.face_source(hit.where.face),
          .depth = camera_.depth(place),
          .slope = slope_of(std::min(std::abs(smooth), std::abs(flat))),
          // Exact forms are as fine as was asked, which the slack holds.
          .chord = proxy.tolerance > 0 ? 0 : chord_error(proxy, hit.where.face),
          .cosine = std::abs(flat),
          .point = {hit.where.face, hit.bary}};
}

std::optional<Referee::Sight> Referee::look(Vec2 paper) const {
  const ViewRay ray = sight_ray(camera_, paper, *occluder_);
  const auto hit =
      occluder_->first_hit(ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity());
  if (!hit) return std::nullopt;
  return describe(*hit, paper);
}

std::optional<Referee::Seen> Referee::see(Vec2 paper) const {
  const auto sight = look(paper);
  if (!sight) return std::nullopt;
  return Seen{{sight->part, sight->face, -1}, sight->place, sight->chord};
}

bool Referee::differ(const Sight& a, const Sight& b) const {
  if (a.part != b.part || a.face != b.face) return true;
  const double explained = glm::distance(a.paper, b.paper) * std::max(a.slope, b.slope);
  return std::abs(a.depth - b.depth) * camera_.scale() > kSteeper * explained + kJump;
}

bool Referee::line_near(Vec2 paper, double radius) const {
  const auto middle = look(paper);
  for (const double r : {radius, 0.5 * radius}) {
    for (int i = 0; i < kDirections; ++i) {
      const auto other = look(paper + r * around(i, kDirections));
      if (middle.has_value() != other.has_value()) return true;
      if (middle && differ(*middle, *other)) return true;
    }
  }
  return false;
}

// Model mm by which a sight is nearer than the point (negative: farther) beyond what the slope of
// its sheet and the slack explain; 0 where it may be the sheet of the point.
double Referee::excess(const Point& p, const Sight& s) const {
  const double nearer = s.depth - p.depth;
  const double apart = glm::distance(p.paper, s.paper) + options_.slack;
  const double explained =
      (options_.slack + kFolds * s.slope * apart) / p.scale + s.chord * (1 + kFolds * s.slope);
  return std::copysign(std::max(0.0, std::abs(nearer) - explained), nearer);
}

// Calls `visit` for the sheets behind each other at a place, foremost first, until it says no.
template <class Visit>
void Referee::each_sheet(Vec2 paper, const Visit& visit) const {
  constexpr int kMostSheets = 16;
  const ViewRay ray = sight_ray(camera_, paper, *occluder_);
  double from = 0;
  for (int i = 0; i < kMostSheets; ++i) {
    const auto hit = occluder_->first_hit(ray.origin, ray.direction, from,
                                          std::numeric_limits<double>::infinity());
    if (!hit || !visit(describe(*hit, paper))) return;
    from = hit->distance + occluder_->tie();
  }
}

bool Referee::may_see(Vec2 paper, const std::function<bool(const Sheet&)>& accepts) const {
  bool taken = false;
  double first = std::numeric_limits<double>::infinity(), explained = 0;
  each_sheet(paper, [&](const Sight& s) {
    const auto off = [&] {
      return (1 + s.slope) * (options_.slack / camera_.scale_at(s.place) + s.chord);
    };
    if (std::isinf(first)) {
      first = s.depth;
      explained = off();
    } else if (first - s.depth > std::max(explained, off())) {
      return false;
    }
    const Surface& surface = *surfaces_[static_cast<std::size_t>(s.part)];
    const bool cut = surface.proxy().is_cut(s.point.face);
    taken = accepts({s.part, s.face, cut, surface.exact(), s.place, s.point});
    return !taken;
  });
  return taken;
}

Vec3 Referee::normal(const Sheet& sheet, std::span<const Vec3> light_normals) const {
  const Surface& surface = *surfaces_[static_cast<std::size_t>(sheet.part)];
  const ProxyMesh& proxy = surface.proxy();
  const Vec3 normal = surface.exact()
                          ? surface.frame(nearest_on(surface, sheet.point)).normal
                          : light_normal(proxy, light_normals, sheet.point.face, sheet.point.bary);
  const bool away = glm::dot(normal, camera_.to_viewer(sheet.place)) < 0;
  return away && !proxy.closed(sheet.point.face) ? -normal : normal;
}

Referee::Shade Referee::shade(const Sheet& sheet, Vec3 to_light, const Referee& casting) const {
  const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(sheet.part)];
  const Vec3 light = glm::normalize(to_light);
  Vec3 normal = proxy.mesh.normal(sheet.point.face);
  if (glm::dot(normal, light) < 0) normal = -normal;
  const auto shaded = [&](double off) {
    return casting.occluder_->occluded(sheet.place + off * normal, light, 0,
                                       2 * occluder_->diagonal());
  };
  const double chord = proxy.tolerance > 0 ? 0 : chord_error(proxy, sheet.point.face);
  const bool close = shaded(4 * occluder_->resolution());
  const bool above = shaded(options_.slack / camera_.scale_at(sheet.place) + chord);
  if (close != above) return Shade::Unsure;
  return close ? Shade::Shaded : Shade::Lit;
}

// Whether two sheets lie within the slack of the point, one of them before it: which is in front is
// not told there.
bool Referee::thin_sheet(const Point& p, Vec2 paper) const {
  int near = 0;
  bool before = false;
  const double slack = options_.slack / p.scale;
  each_sheet(paper, [&](const Sight& s) {
    const double nearer = s.depth - p.depth;
    if (nearer < -slack) return false;
    if (nearer <= slack) {
      ++near;
      before = before || nearer > 0;
    }
    return true;
  });
  return near > 1 && before;
}

// Model mm along the view to the sheet nearest to the point, whichever, right at it or beside it.
double Referee::own_sheet(const Point& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](Vec2 paper) {
    each_sheet(paper, [&](const Sight& s) {
      nearest = std::min(nearest, std::abs(s.depth - p.depth));
      return s.depth > p.depth;
    });
  };
  look_at(p.paper);
  for (int i = 0; i < kDirections; ++i) {
    look_at(p.paper + kClosely * options_.radius * around(i, kDirections));
  }
  return nearest;
}

// Whether the foremost sheet at the very place of the point lies before it and is not its own,
// however thin the wall or sharp the fold between them: its plane passes the point farther off than
// both tessellations are, or another sheet is much nearer to the point. Of a smooth contour the
// second says little: its own fold lies as far before it as behind.
bool Referee::behind_another(const Point& p, Fold fold) const {
  const auto first = look(p.paper);
  if (!first || first->depth <= p.depth) return false;
  const double before = first->depth - p.depth, slack = options_.slack / p.scale;
  const double off = before * first->cosine - 2 * first->chord;
  if (off > slack) return true;
  if ((fold == Fold::Smooth ? off : before) < kFineShare * slack) return false;
  return kMuchNearer * (own_sheet(p) + 2 * first->chord) < before;
}

// Whether any sheet, however deep in the picture, passes the point in space: within the radius and
// the slack, or within twice what its triangle may lie beside what it stands for. A sheet that is
// seen from its edge meets no ray along the view, and its border any ray only from beside.
bool Referee::surface_near(const Point& p) const {
  const double near = (options_.radius + options_.slack) / p.scale;
  const auto meets = [&](Vec3 from, Vec3 direction) {
    return occluder_->occluded_by(
        from, direction, 0, kWidest * options_.radius / p.scale, [&](const Hit& hit) {
          if (hit.distance <= near) return true;
          const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(hit.where.part)];
          return proxy.tolerance <= 0 && hit.distance <= 2 * chord_error(proxy, hit.where.face);
        });
  };
  const Vec3 view = camera_.to_viewer(p.model);
  std::vector<Vec3> ways{view, -view};
  for (int i = 0; i < kDirections; ++i) {
    const Vec2 a = around(i, kDirections);
    ways.push_back(a.x * camera_.right() + a.y * camera_.up());
  }
  const auto meets_any = [&](Vec3 from) {
    return std::ranges::any_of(ways, [&](Vec3 way) { return meets(from, way); });
  };
  const double beside = kBesideSheet * options_.radius / p.scale;
  return meets_any(p.model) ||
         std::ranges::any_of(ways, [&](Vec3 way) { return meets_any(p.model + beside * way); });
}

Finding Referee::test_visible(const Point& p) const {
  bool free = false;
  const auto asked = [&](Vec2 paper) {
    const auto sight = look(paper);
    const double e = sight ? excess(p, *sight) : -1;
    free = free || e <= 0;
    return e == 0;
  };
  if (asked(p.paper)) return Finding::Holds;
  for (const double share : {0.5, 1.0}) {
    for (int i = 0; i < kDirections; ++i) {
      if (asked(p.paper + share * options_.radius * around(i, kDirections))) return Finding::Holds;
    }
  }
  if (!free) return Finding::Covered;
  return surface_near(p) ? Finding::Holds : Finding::Adrift;
}

// Whether the line can be seen where it is, not only beside. At its own fold a sheet before it is
// not told from the sheet that it lies on: a contour is in the open where one looks past it on its
// outer side, any other line where its sheet is seen squarely.
bool Referee::in_the_open(const Point& p, Fold fold) const {
  const auto clear = [&](Vec2 paper) {
    const auto sight = look(paper);
    if (fold != Fold::None) return !sight || excess(p, *sight) < 0;
    return sight && excess(p, *sight) == 0 && sight->slope <= kSquarely;
  };
  if (clear(p.paper)) return true;
  if (fold == Fold::None) return false;
  for (int i = 0; i < kDirections; ++i) {
    if (clear(p.paper + kClosely * options_.radius * around(i, kDirections))) return true;
  }
  return false;
}

Finding Referee::test_hidden(const Point& p, Fold fold) const {
  const auto before = [&](Vec2 paper) {
    const auto sight = look(paper);
    return sight && (excess(p, *sight) > 0 || thin_sheet(p, paper));
  };
  if (before(p.paper) || behind_another(p, fold)) return Finding::Holds;
  for (const double share : {0.5, 1.0}) {
    for (int i = 0; i < kDirections; ++i) {
      if (before(p.paper + share * options_.radius * around(i, kDirections))) return Finding::Holds;
    }
  }
  return in_the_open(p, fold) ? Finding::Open : Finding::Holds;
}

Finding Referee::test(Vec3 point, bool visible, Fold fold) const {
  const Point p{point, camera_.to_paper(point), camera_.depth(point), camera_.scale_at(point)};
  return visible ? test_visible(p) : test_hidden(p, fold);
}

}  // namespace burin
