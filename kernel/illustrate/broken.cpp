#include "broken.h"

#include <burin/base/box.h>
#include <burin/drawing/break_up.h>
#include <burin/illustrate/ground.h>

#include "tell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

namespace burin::detail {

Camera whole_camera(const Scene& scene, const PlacedView& view, const Style& style,
                    IllustrateOptions& options) {
  if (view.breaks.empty()) return view.camera;
  constexpr double kAround = 20;  // paper mm: lines beside the parts, such as ends of centre lines
  const Camera& camera = view.camera;
  const Mat3 axes = camera.axes();
  const ViewOptions sides{.direction = camera.direction(), .up = camera.up()};
  const Box3 extent = extent_with_shadow(scene, style, options.part_styles, sides)(axes);
  Box2 box;
  for (const Vec3& corner : {extent.min, extent.max}) {
    box.add(camera.to_paper(glm::transpose(axes) * corner));
  }
  const Vec2 corner = kAround - box.min, size = box.size() + 2 * kAround;
  options.broken = {view.breaks.of_moved_view(corner), camera.paper(), corner};
  return camera.on_sheet({size.x, size.y}, corner);
}

Camera camera_on_sheet(const Camera& whole, const BrokenView& broken) {
  return broken.breaks.empty() ? whole : whole.on_sheet(broken.sheet, -broken.corner);
}

namespace {

/// Where a triangle of the paper is on a line across `along`; nothing where it is beside it.
void add_crossing(const std::array<Vec2, 3>& corners, double side, Stretches& to) {
  double from = 0, until = 0;
  bool met = false;
  const auto meet = [&](double at) {
    from = met ? std::min(from, at) : at;
    until = met ? std::max(until, at) : at;
    met = true;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = corners[k], b = corners[(k + 1) % 3];
    if (a.x == side) meet(a.y);
    if ((a.x < side) != (b.x < side)) {
      meet(std::lerp(a.y, b.y, (side - a.x) / (b.x - a.x)));
    }
  }
  if (met) to.emplace_back(from, until);
}

constexpr double kBeside = 1e-4;  // paper mm: of what is left, not of what begins there

/// Whether a triangle stands on a line across `along`, seen from its edge.
bool stands_on(const std::array<Vec2, 3>& corners, double line) {
  constexpr double kLeast = 1e-2;  // paper mm: others may be that small
  const auto [low, high] = std::ranges::minmax(corners, {}, &Vec2::y);
  return high.y - low.y > kLeast && std::ranges::all_of(corners, [&](Vec2 corner) {
           return std::abs(corner.x - line) < kBeside;
         });
}

/// Tells of breaks that end on faces. `lines`: paper mm along the way of the breaks.
void report_on_faces(const std::set<double>& lines, const Camera& camera, const PaperBreaks& breaks,
                     Diagnostics& diagnostics) {
  if (lines.empty()) return;
  const double origin = glm::dot(breaks.along, camera.to_paper(Vec3(0)));
  std::vector<std::string> at;
  for (const double line : lines) {
    at.push_back(fmt::format("{:.6g}", (line - origin) / camera.scale() + 0.0));
  }
  diagnostics.add(Severity::Warning, "break.on_face", static_cast<std::int64_t>(at.size()),
                  fmt::format("the break ends on a face, at {} mm along the axis, where its line "
                              "and the edges are one: end it beside the face",
                              fmt::join(at, " and ")));
}

}  // namespace

std::vector<Stretches> cut_stretches(std::span<const ProxyMesh* const> proxies,
                                     const PartStyles& part_styles, const Camera& camera,
                                     const PaperBreaks& breaks, Diagnostics& diagnostics) {
  std::set<double> on_faces;
  std::vector<double> sides;
  for (const PaperBreaks::Band& band : breaks.bands) {
    sides.push_back(band.low - kBeside);
    sides.push_back(band.high + kBeside);
  }
  std::vector<Stretches> cut(sides.size());
  const Vec2 across(-breaks.along.y, breaks.along.x);
  for (std::size_t part = 0; part < proxies.size() && !sides.empty(); ++part) {
    if (!part_styles.drawn(part)) continue;
    const TriMesh& mesh = proxies[part]->mesh;
    std::vector<Vec2> places;
    for (const Vec3& p : mesh.positions) {
      const Vec2 at = camera.to_paper(p);
      places.emplace_back(glm::dot(breaks.along, at), glm::dot(across, at));
    }
    for (const Triangle& triangle : mesh.triangles) {
      const std::array corners{places[triangle[0]], places[triangle[1]], places[triangle[2]]};
      for (std::size_t i = 0; i < sides.size(); ++i) add_crossing(corners, sides[i], cut[i]);
      for (const PaperBreaks::Band& band : breaks.bands) {
        for (const double line : {band.low, band.high}) {
          if (stands_on(corners, line)) on_faces.insert(line);
        }
      }
    }
    for (Stretches& one : cut) one = joined(std::move(one));
  }
  report_on_faces(on_faces, camera, breaks, diagnostics);
  return cut;
}

void break_drawing(const Camera& camera, const BrokenView& broken, const BreakOptions& style,
                   Labels& labels, Drawing& drawing) {
  const PaperBreaks& breaks = broken.breaks;
  if (breaks.empty()) return;
  Stretches all;
  for (const Stretches& one : labels.cut) all.insert(all.end(), one.begin(), one.end());
  const std::vector<Vec2> edge = break_edge(joined(std::move(all)), style.line);
  break_up(breaks, edge, drawing);
  for (std::vector<Area>* areas : {&labels.areas, &labels.whole}) break_up(breaks, edge, *areas);
  if (labels.shadow) {
    std::vector<Area> shadow{std::move(*labels.shadow)};
    break_up(breaks, edge, shadow);
    labels.shadow = shadow.empty() ? Area{.rings = {}} : std::move(shadow.front());
  }
  lay_break_lines(drawing, breaks, edge, labels.cut, style);
  if (drawing.stats.verify) {
    for (Contradiction& one : drawing.stats.verify->contradictions) one.at = breaks.moved(one.at);
  }
  const Camera on_sheet = camera_on_sheet(camera, broken);
  drawing.paper_width = broken.sheet.width;
  drawing.paper_height = broken.sheet.height;
  drawing.view.offset = on_sheet.offset();
  drawing.view.breaks = breaks.of_moved_view(-broken.corner);
}

}  // namespace burin::detail
