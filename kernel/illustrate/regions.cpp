#include "regions.h"

#include <burin/base/parallel.h>
#include <burin/drawing/bezier.h>
#include <burin/feature/feature.h>
#include <burin/feature/kind_borders.h>
#include <burin/feature/light_normals.h>
#include <burin/illustrate/view_probe.h>
#include <burin/surface/nearest_on.h>

#include "exact_places.h"
#include "fill/fills.h"
#include "shadow/cast_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm: points of lines that lie so near the line through the others are left out.
constexpr double kLineTolerance = 0.003;
// Paper mm within which lines and rays agree on a border: chord errors.
constexpr double kSlack = 0.04;
// Paper mm between places of a line that are looked at, at the most.
constexpr double kLookStep = 1;
// Paper mm along the line of sight within which a place of a surface is the one that is seen.
constexpr double kSameDepth = 0.3;

bool parts_regions(LineClass kind) {
  return kind != LineClass::Pattern && kind != LineClass::Trail && kind != LineClass::Isophote &&
         kind != LineClass::Thread && kind != LineClass::ThreadEnd;
}

/// Lines of the sheet, as `partition` takes them.
class Borders {
 public:
  explicit Borders(const Camera& camera) : camera_(camera) {}

  void add(const Curve3& curve) {
    std::vector<Vec2> line;
    line.reserve(curve.points.size() + 1);
    for (const Vec3& p : curve.points) line.push_back(camera_.to_paper(p));
    if (curve.closed) line.push_back(line.front());
    std::vector<Vec2> kept;
    for (const std::size_t i : simplify(std::span<const Vec2>(line), kLineTolerance)) {
      kept.push_back(line[i]);
    }
    lines_.push_back(std::move(kept));
  }

  std::vector<BorderLine> get() const {
    std::vector<BorderLine> out;
    for (const std::vector<Vec2>& line : lines_) out.push_back({line});
    return out;
  }

 private:
  const Camera& camera_;
  std::vector<std::vector<Vec2>> lines_;
};

/// Stretches of a line on which its surface is what is seen, and a step beyond: what is hidden may
/// part nothing.
class Shown {
 public:
  Shown(const Curve3& curve, const ViewProbe& probe, const Camera& camera)
      : curve_(curve), probe_(probe), camera_(camera) {}

  void add_to(Borders& borders) {
    bool looked = false;  // at the start of the stretch
    for (std::size_t i = 0; i < curve_.segment_count(); ++i) {
      const Vec3 &a = curve_.points[i], &b = curve_.points[curve_.next(i)];
      if (!curve_.self_hidden.empty() && curve_.self_hidden[i] != 0) {
        if (looked) end_stretch(borders);
        close(borders);
        looked = false;
        continue;
      }
      if (!std::exchange(looked, true)) {
        before_ = seen(a);
        stretch_ = {a};
      }
      const double length = glm::distance(camera_.to_paper(a), camera_.to_paper(b));
      const auto pieces = static_cast<std::size_t>(std::clamp(length / kLookStep, 0.0, 1e4)) + 1;
      for (std::size_t k = 1; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(pieces);
        stretch_.push_back(glm::mix(a, b, t));
        length_ += length / static_cast<double>(pieces);
        if (length_ >= 0.5 * kLookStep) end_stretch(borders);
      }
    }
    if (looked) end_stretch(borders);
    close(borders);
  }

 private:
  bool seen(Vec3 p) const {
    const auto hit = probe_(camera_.to_paper(p));
    if (!hit) return true;  // beside its own outline
    const double behind = glm::dot(hit->position - p, camera_.to_viewer(p));
    return behind * camera_.scale_at(p) < kSameDepth;
  }
  /// Looks at its end.
  void end_stretch(Borders& borders) {
    if (stretch_.size() < 2) return;
    const bool after = seen(stretch_.back());
    if (before_ || after) {
      const auto from = run_.points.empty() ? stretch_.begin() : std::next(stretch_.begin());
      run_.points.insert(run_.points.end(), from, stretch_.end());
    } else {
      close(borders);
    }
    before_ = after;
    stretch_ = {stretch_.back()};
    length_ = 0;
  }
  void close(Borders& borders) {
    if (!run_.points.empty()) borders.add(run_);
    run_.points.clear();
  }

  const Curve3& curve_;
  const ViewProbe& probe_;
  const Camera& camera_;
  /// What is shown, up to the stretch.
  Curve3 run_;
  /// From the last place that was looked at on.
  std::vector<Vec3> stretch_;
  double length_ = 0;
  bool before_ = false;
};

/// Visible stretches of the lines of solid parts.
void add_seen(const SeenLines& lines, const Occluders& occluders, Borders& borders) {
  for (std::size_t i = 0; i < lines.curves.size(); ++i) {
    const Curve3& curve = lines.curves[i];
    const auto part = static_cast<std::size_t>(curve.source.part);
    if (!parts_regions(curve.kind) || occluders.transparent(part)) continue;
    const auto count = static_cast<double>(curve.segment_count());
    for (const Span& span : merged(lines.spans[i], curve.closed, count)) {
      if (!span.visible) continue;
      const bool whole = span.begin <= 0 && span.end >= count && span.end - span.begin <= count;
      borders.add(whole ? curve : slice(curve, span.begin, span.end));
    }
  }
}

/// The colours of the faces of a part; null: it has one.
const FaceColors* colors_of(const RegionOptions& options, std::size_t part) {
  return part < options.colors.size() ? options.colors[part].get() : nullptr;
}

bool tells_faces(const RegionOptions& options, std::size_t part) {
  return part < options.faces.size() && options.faces[part];
}

/// Lines that the drawing has none of.
std::vector<Curve3> silent_lines(const LightNormals& normals, const Occluders& occluders,
                                 const Occluders& casters, const Camera& camera,
                                 const RegionOptions& options, const LightView* light,
                                 const RunContext& context) {
  std::vector<Curve3> out;
  const auto proxies = occluders.solid_proxies();
  const bool faces = std::ranges::find(options.faces, true) != options.faces.end();
  const FeatureOptions silent{.contours = false,
                              .creases = false,
                              .boundaries = false,
                              .intersections = !options.found.intersections,
                              .smooth = faces && !options.found.smooth,
                              .seams = faces && !options.found.seams};
  if (silent.intersections || silent.smooth || silent.seams) {
    Diagnostics said;  // once is enough
    out = extract_features(proxies, camera, silent, said, context);
  }
  const FeatureOptions lines{.smooth = faces || options.found.smooth,
                             .seams = faces || options.found.seams};
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    const FaceColors* colors = colors_of(options, i);
    if (!colors) continue;
    std::vector<Curve3> more = kind_borders(
        *proxies[i], static_cast<std::int32_t>(i),
        [&](std::int32_t face) { return colors->at(face); }, lines);
    std::ranges::move(more, std::back_inserter(out));
  }
  std::vector<std::vector<Curve3>> isophotes(proxies.size());
  parallel_for(
      proxies.size(), 1,
      [&](std::size_t i, std::size_t) {
        isophotes[i] = trace_isophotes(*proxies[i], static_cast<std::int32_t>(i), options.tones[i],
                                       camera, context,
                                       {.exact = exact_places(*occluders.surfaces()[i]),
                                        .border = true,
                                        .normals = normals[i]});
      },
      &context);
  for (std::vector<Curve3>& of_one : isophotes) std::ranges::move(of_one, std::back_inserter(out));
  if (light) {
    std::ranges::move(cast_shadows(occluders, casters, *light, camera, options.tones, context),
                      std::back_inserter(out));
  }
  return out;
}

/// The step of tone of a place. The normal of an exact surface is asked for only where those at the
/// corners of the triangle leave more than one step: between them light bends by less than the
/// angle between them lets it.
std::int32_t tone_at(const Surface& surface, std::span<const Vec3> normals, const ViewHit& hit,
                     const Camera& camera, const Isophotes& tones) {
  const ProxyMesh& proxy = surface.proxy();
  const auto [face, bary] = hit.point;
  Vec3 normal = proxy.normal(face, bary);
  const bool closed = proxy.closed(face);
  const bool back = !closed && glm::dot(normal, camera.to_viewer(hit.position)) < 0;
  const double side = back ? -1 : 1;
  const Triangle& w = proxy.wedges[face];
  const std::span<const Vec3> at = normals.empty() ? proxy.wedge_normal : normals;
  const Vec3 &a = at[w[0]], &b = at[w[1]], &c = at[w[2]];
  const double bend = 1 - std::min({glm::dot(a, b), glm::dot(b, c), glm::dot(c, a)});
  const Vec3 light = side / glm::length(tones.light) * tones.light;
  const std::array lights{glm::dot(a, light), glm::dot(b, light), glm::dot(c, light)};
  const auto [least, most] = std::ranges::minmax(lights);
  const auto step = [&](double of) {
    return std::ranges::lower_bound(tones.levels, of) - tones.levels.begin();
  };
  if (const auto one = step(least - bend); one == step(most + bend)) {
    return static_cast<std::int32_t>(one);
  }
  normal = surface.exact() ? surface.frame(nearest_on(surface, hit.point)).normal
                           : light_normal(proxy, normals, face, bary);
  return step_of(tones, side * normal);
}

/// What is seen at a place of the sheet. All of it must outlive that.
LabelAt region_label(const LightNormals& normals, const Occluders& occluders,
                     const Occluders& casters, const ExactDepths& depths, const Camera& camera,
                     const RegionOptions& options, const LightView* light) {
  return [probe = exact_view_probe(occluders, depths, camera), proxies = occluders.solid_proxies(),
          &normals, &occluders, &casters, &depths, &camera, &options, light](Vec2 at) {
    const auto hit = probe(at);
    if (!hit) return AreaLabel{};
    AreaLabel label{.part = hit->part};
    const auto part = static_cast<std::size_t>(hit->part);
    const ProxyMesh& proxy = *proxies[part];
    const auto steps = static_cast<std::int32_t>(options.tones[part].levels.size());
    const bool cut = proxy.is_cut(hit->point.face);
    if (cut || tells_faces(options, part)) label.face = proxy.face_source(hit->point.face);
    const FaceColors* colors = colors_of(options, part);
    if (colors && !cut) label.color = colors->at(proxy.face_source(hit->point.face));
    // The face that closes a cut is none of the shape: in shade its hatching would be lost.
    label.tone = cut ? steps : 0;
    if (cut || steps == 0) return label;
    label.tone =
        tone_at(*occluders.surfaces()[part], normals[part], *hit, camera, options.tones[part]);
    if (light && label.tone > 0 &&
        in_shadow(occluders, casters.solid(), depths, *hit, light->camera.direction())) {
      label.tone = 0;
    }
    return label;
  };
}

/// Regions of one part, face and colour, by step.
using Steps = std::map<std::int32_t, std::vector<std::uint32_t>>;

void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The colour of a part goes on below those of its faces, in its lightest step.
void lay_below(std::map<AreaLabel, Steps>& faces, const std::vector<bool>& nested) {
  for (auto& [label, steps] : faces) {
    AreaLabel own = label;
    own.color = -1;
    const auto below = faces.find(own);
    const bool lies_over = label.color >= 0 && nested[static_cast<std::size_t>(label.part)];
    if (!lies_over || below == faces.end()) continue;
    for (const auto& [tone, regions] : steps) append(below->second.rbegin()->second, regions);
  }
}

Area area_of(const Partition& partition, const AreaLabel& label, bool toned,
             const std::vector<std::uint32_t>& regions) {
  Area area;
  area.part = label.part;
  area.face = label.face;
  area.tone = toned ? label.tone : -1;
  for (std::vector<Vec2>& ring : partition.outline(regions)) add_ring(std::move(ring), area);
  return area;
}

}  // namespace

void add_ring(std::vector<Vec2> ring, Area& area) {
  // Paper mm. More would let the borders of narrow areas cross.
  constexpr double kTolerance = 1e-4;
  ring.push_back(ring.front());
  std::vector<Vec2> kept;
  for (const std::size_t i : simplify(std::span<const Vec2>(ring), kTolerance)) {
    kept.push_back(ring[i]);
  }
  kept.pop_back();
  if (kept.size() > 2) area.rings.push_back(std::move(kept));
}

LightNormals light_normals_of(const Occluders& occluders, const Camera& camera,
                              const RegionOptions& options, const RunContext& context) {
  const auto proxies = occluders.solid_proxies();
  LightNormals out(proxies.size());
  parallel_for(
      proxies.size(), 1,
      [&](std::size_t i, std::size_t) {
        if (options.tones[i].levels.empty() || occluders.surfaces()[i]->exact()) return;
        out[i] = light_normals(*proxies[i], camera, options.pen, context);
      },
      &context);
  return out;
}

Partition find_regions(const Box2& box, const SeenLines& lines, const Occluders& occluders,
                       const Occluders& casters, const Camera& camera, const RegionOptions& options,
                       const LightView* light, LightNormals normals, const RunContext& context) {
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return {};
  const auto proxies = occluders.solid_proxies();
  parallel_for(
      proxies.size(), 1,
      [&](std::size_t i, std::size_t) {
        normals[i] = without_islands(*proxies[i], std::move(normals[i]), options.tones[i], camera,
                                     options.pen);
      },
      &context);
  Borders borders(camera);
  add_seen(lines, occluders, borders);
  const ViewProbe probe = view_probe(occluders.solid(), camera);
  const std::vector<Curve3> silent =
      silent_lines(normals, occluders, casters, camera, options, light, context);
  for (const Curve3& line : silent) Shown(line, probe, camera).add_to(borders);
  const ExactDepths depths(occluders);
  const LabelAt label_at =
      region_label(normals, occluders, casters, depths, camera, options, light);
  const PartitionOptions how{.least_tone_width = options.pen, .slack = kSlack};
  return partition(box, borders.get(), label_at, how, context);
}

std::vector<Area> silhouettes(const Partition& partition) {
  std::map<std::int32_t, std::vector<std::uint32_t>> parts;
  for (std::uint32_t i = 0; i < partition.regions.size(); ++i) {
    const std::int32_t part = partition.regions[i].label.part;
    if (part >= 0) parts[part].push_back(i);
  }
  std::vector<Area> out;
  for (const auto& [part, regions] : parts) {
    out.push_back(area_of(partition, {.part = part}, false, regions));
  }
  return out;
}

std::vector<Area> areas_of(const Partition& partition, const RegionOptions& options,
                           const std::vector<bool>& nested) {
  std::map<AreaLabel, Steps> faces;
  for (std::uint32_t i = 0; i < partition.regions.size(); ++i) {
    AreaLabel label = partition.regions[i].label;
    if (label.part < 0) continue;
    const std::int32_t tone = std::exchange(label.tone, 0);
    faces[label][tone].push_back(i);
  }
  lay_below(faces, nested);
  std::vector<Area> out;
  for (auto& [label, steps] : faces) {
    const auto part = static_cast<std::size_t>(label.part);
    if (nested[part]) {
      for (auto it = steps.begin(); std::next(it) != steps.end(); ++it) {
        append(std::next(it)->second, it->second);
      }
    }
    for (auto it = steps.rbegin(); it != steps.rend(); ++it) {
      AreaLabel one = label;
      one.tone = it->first;
      Area area = area_of(partition, one, !options.tones[part].levels.empty(), it->second);
      if (label.color >= 0) {
        set_face_color(options.colors[part]->colors[static_cast<std::size_t>(label.color)], area);
      }
      if (!area.rings.empty()) out.push_back(std::move(area));
    }
  }
  return out;
}

}  // namespace burin::detail
