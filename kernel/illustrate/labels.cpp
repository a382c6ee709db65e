#include "labels.h"

#include <burin/area/partition.h>
#include <burin/base/part_ranks.h>
#include <burin/feature/kind_borders.h>
#include <burin/illustrate/view_probe.h>
#include <burin/mesh/chord_error.h>
#include <burin/visibility/sight_ray.h>

#include "fill/fills.h"
#include "regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

// Panes one behind the other that are looked through; items behind more are told as not seen.
constexpr std::size_t kMostGlass = 8;

Box2 ink_on_sheet(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
  }
  if (box.empty()) return box;
  constexpr double kAround = 1;  // paper mm
  return {glm::max(box.min - kAround, Vec2(0)),
          glm::min(box.max + kAround, Vec2(drawing.paper_width, drawing.paper_height))};
}

// The visible lines that a part may end at.
std::vector<LabelBorder> borders_of(const Drawing& drawing) {
  std::vector<LabelBorder> lines;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.visible && path.kind < LineClass::Stroke) {
        lines.push_back({path.points, path.closed});
      }
    }
  }
  return lines;
}

// Where faces of other colours of glass meet.
std::vector<LabelBorder> borders_of_colors(const LabelRequest& wanted) {
  std::vector<LabelBorder> lines;
  const Occluders& occluders = *wanted.occluders;
  const FeatureOptions none{.smooth = false, .seams = false};
  for (std::size_t i = 0; i < wanted.colors.size(); ++i) {
    const FaceColors* colors = wanted.colors[i].get();
    if (!colors || !occluders.transparent(i)) continue;
    const auto color = [&](std::int32_t face) { return colors->at(face); };
    for (const Curve3& curve :
         kind_borders(*occluders.proxies()[i], static_cast<std::int32_t>(i), color, none)) {
      LabelBorder& line = lines.emplace_back(LabelBorder{{}, curve.closed});
      for (const Vec3& p : curve.points) line.points.push_back(wanted.camera.to_paper(p));
    }
  }
  return lines;
}

/// What is seen in a box of the sheet.
class Looker {
 public:
  Looker(const LabelRequest& wanted, const RunContext& context)
      : wanted_(wanted),
        box_(wanted.box),
        camera_(wanted.camera),
        context_(context),
        between_colors_(borders_of_colors(wanted)) {
    for (const std::vector<LabelBorder>* borders :
         {&wanted.borders, &std::as_const(between_colors_)}) {
      for (const LabelBorder& border : *borders) lines_.push_back({border.points, border.closed});
    }
  }

  /// Of the solid parts.
  std::vector<Area> solid() const { return areas(view_probe(wanted_.occluders->solid(), camera_)); }

  /// Of the pane behind so many others at each place. `all` are the solid parts and the panes.
  std::vector<Area> glass(const Occluder& all, std::size_t behind) const {
    return areas([&](Vec2 at) { return pane(all, at, behind); });
  }

 private:
  /// What a part shows first of itself counts, not its other walls. What is solid ends the view.
  /// Walls in which parts touch are met all, so that none behind another is lost.
  std::optional<ViewHit> pane(const Occluder& all, Vec2 at, std::size_t behind) const {
    const ViewRay ray = sight_ray(camera_, at, all);
    const double same = all.tie();
    const std::vector<double>& ranks = wanted_.occluders->ranks();
    Hit end{.where = {}, .distance = std::numeric_limits<double>::infinity()};  // what is solid
    std::vector<Hit> panes;  // the foremost hit of each
    const auto take = [&](const Hit& hit) {
      if (!wanted_.occluders->transparent(static_cast<std::size_t>(hit.where.part))) {
        const bool nearer = hit.distance < end.distance - same;
        const bool beside = hit.distance < end.distance + same;
        if (nearer || (beside && precedes(ranks, hit.where.part, end.where.part))) end = hit;
        return false;
      }
      const auto known =
          std::ranges::find(panes, hit.where.part, [](const Hit& pane) { return pane.where.part; });
      if (known == panes.end()) {
        panes.push_back(hit);
      } else if (std::pair(hit.distance, hit.where.face) <
                 std::pair(known->distance, known->where.face)) {
        *known = hit;
      }
      return false;
    };
    all.occluded_by(ray.origin, ray.direction, 0, end.distance, take);
    std::erase_if(panes, [&](const Hit& pane) {
      const bool first = precedes(ranks, pane.where.part, end.where.part);
      return pane.distance >= end.distance + (first ? same : -same);
    });
    if (panes.size() <= behind) return std::nullopt;
    sort(panes, ray.direction, same);
    const Hit& pane = panes[behind];
    return ViewHit{.part = pane.where.part, .point = {pane.where.face, pane.bary}};
  }

  /// From the viewer on; those that lie on each other, as far as triangles tell, by rank: they
  /// would change places from ray to ray.
  void sort(std::vector<Hit>& panes, Vec3 direction, double same) const {
    constexpr double kGrazing = 0.05;
    const auto off = [&](const Hit& hit) {
      const ProxyMesh& proxy =
          *wanted_.occluders->proxies()[static_cast<std::size_t>(hit.where.part)];
      const double error =
          proxy.tolerance > 0 ? proxy.tolerance : chord_error(proxy, hit.where.face);
      const double cosine = std::abs(glm::dot(proxy.mesh.normal(hit.where.face), direction));
      return error / std::max(cosine, kGrazing);
    };
    std::ranges::sort(panes, {},
                      [](const Hit& pane) { return std::pair(pane.distance, pane.where.part); });
    for (std::size_t pass = 1; pass < panes.size(); ++pass) {
      for (std::size_t i = 0; i + pass < panes.size(); ++i) {
        Hit &a = panes[i], &b = panes[i + 1];
        const bool apart = b.distance - a.distance > same + off(a) + off(b);
        if (!apart && precedes(wanted_.occluders->ranks(), b.where.part, a.where.part)) {
          std::swap(a, b);
        }
      }
    }
  }

  std::vector<Area> areas(const ViewProbe& probe) const {
    const auto label_at = [&](Vec2 at) {
      const auto hit = probe(at);
      if (!hit) return AreaLabel{};
      const auto part = static_cast<std::size_t>(hit->part);
      AreaLabel label{.part = hit->part};
      const ProxyMesh& proxy = *wanted_.occluders->proxies()[part];
      const FaceColors* colors = colors_of(part);
      if (colors && !proxy.is_cut(hit->point.face)) {
        label.color = colors->at(proxy.face_source(hit->point.face));
      }
      return label;
    };
    return areas_of(partition(box_, lines_, label_at, {.rounds = 1}, context_));
  }

  const FaceColors* colors_of(std::size_t part) const {
    const bool of_glass = part < wanted_.colors.size() && wanted_.occluders->transparent(part);
    return of_glass ? wanted_.colors[part].get() : nullptr;
  }

  /// What is seen of each part, by part and colour.
  std::vector<Area> areas_of(const Partition& partition) const {
    std::map<std::pair<std::int32_t, std::int32_t>, Area> areas;
    for (const AreaRegion& region : partition.regions) {
      const AreaLabel& label = region.label;
      if (label.part < 0) continue;
      Area& area =
          areas.try_emplace({label.part, label.color}, Area{.part = label.part, .rings = {}})
              .first->second;
      for (const AreaRing& ring : region.rings) add_ring(partition.polygon(ring), area);
      if (label.color < 0) continue;
      const FaceColors& colors = *colors_of(static_cast<std::size_t>(label.part));
      set_face_color(colors.colors[static_cast<std::size_t>(label.color)], area);
    }
    std::vector<Area> out;
    for (auto& [key, area] : areas) {
      if (!area.rings.empty()) out.push_back(std::move(area));
    }
    return out;
  }

  const LabelRequest& wanted_;
  Box2 box_;
  std::vector<BorderLine> lines_;
  const Camera& camera_;
  const RunContext& context_;
  std::vector<LabelBorder> between_colors_;
};

}  // namespace

LabelRequest::LabelRequest(const Drawing& drawing, std::shared_ptr<const Occluders> parts,
                           const Camera& of, bool with_solid)
    : occluders(std::move(parts)), camera(of), box(ink_on_sheet(drawing)), solid(with_solid) {
  if (solid || occluders->any_transparent()) borders = borders_of(drawing);
}

Labels label(const LabelRequest& wanted, const RunContext& context) {
  const Box2& box = wanted.box;
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return {};
  const Occluders& occluders = *wanted.occluders;
  const Looker looker(wanted, context);
  Labels labels;
  if (occluders.any_transparent()) {
    const Occluder all(occluders.proxies_with(occluders.transparent()), context,
                       occluders.tree_options());
    for (std::size_t behind = 0; behind < kMostGlass; ++behind) {
      std::vector<Area> seen = looker.glass(all, behind);
      if (seen.empty()) break;
      std::ranges::move(seen, std::back_inserter(labels.areas));
    }
  }
  if (wanted.solid) {
    std::ranges::move(looker.solid(), std::back_inserter(labels.areas));
  }
  return labels;
}

}  // namespace burin::detail
