#include "lay_pmi.h"

#include <burin/drawing/color.h>
#include <burin/illustrate/ground.h>
#include <burin/illustrate/illustrate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace burin {
namespace {

/// How a view looks at a place. Units.
struct Sightline {
  Vec3 to_viewer{0}, right{0};
};

/// Whether an annotation can be read: not from behind, where its letters are mirrored where the
/// part stands, not from its edge, and not upside down.
bool is_readable(const PmiItem& item, const Placement& place, const Sightline& sight,
                 double degrees) {
  if (!item.plane) return true;
  const Vec3 along = glm::normalize(place.vector(item.plane->along));
  const Vec3 up = place.vector(glm::cross(item.plane->normal, item.plane->along));
  const Vec3 facing = glm::normalize(glm::cross(along, up));
  // Letters that run down or up the sheet may lean a little to the left.
  constexpr double kLeaning = -0.2;
  return glm::dot(facing, sight.to_viewer) >= std::cos(glm::radians(degrees)) &&
         glm::dot(along, sight.right) >= kLeaning;
}

bool is_wanted(const PmiItem& item, const PmiOptions& options) {
  return options.view.empty() || std::ranges::find(item.views, options.view) != item.views.end();
}

/// Whether the file says it and shows it nowhere.
bool is_unseen(const PmiItem& item) { return !item.shown() && item.shown_with < 0; }

/// Every point that an annotation has.
template <class Do>
void for_points(const PmiItem& item, const Placement& place, const Do& one) {
  for (const auto* lines : {&item.lines, &item.filled}) {
    for (const PmiLine& line : *lines) {
      for (const Vec3& point : line.points) one(place.point(point));
    }
  }
}

Vec3 middle_of(const PmiItem& item, const Placement& place) {
  Box3 box;
  for_points(item, place, [&](const Vec3& point) { box.add(point); });
  return 0.5 * (box.min + box.max);
}

/// How much of an annotation parts cover.
class Cover {
 public:
  Cover(const Camera& camera, const Occluder& solid) : camera_(camera), solid_(solid) {}

  /// Of letters and frames that stand beside a part; the leader may run into it.
  bool hides(const PmiItem& item, const Placement& place) const {
    // Arrows have three corners.
    constexpr std::size_t kLetter = 5;
    constexpr double kMostOfLetters = 0.5, kMostOfLines = 0.9;
    Ink letters, lines;
    for (const PmiLine& line : item.filled) {
      if (line.points.size() >= kLetter) add(line, place, letters);
    }
    if (letters.length > 0) return letters.covered > kMostOfLetters * letters.length;
    for (const PmiLine& line : item.lines) add(line, place, lines);
    return lines.length > 0 && lines.covered > kMostOfLines * lines.length;
  }

 private:
  /// Paper mm.
  struct Ink {
    double length = 0, covered = 0;
  };

  void add(const PmiLine& line, const Placement& place, Ink& ink) const {
    const std::size_t count = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
      add(place.point(line.points[i]), place.point(line.points[(i + 1) % line.points.size()]), ink);
    }
  }

  void add(const Vec3& a, const Vec3& b, Ink& ink) const {
    // Paper mm between rays; how many a line has at the most.
    constexpr double kStep = 1, kMostRays = 500;
    const double on_paper = glm::distance(camera_.to_paper(a), camera_.to_paper(b));
    const auto rays = static_cast<int>(std::clamp(std::ceil(on_paper / kStep), 1.0, kMostRays));
    for (int i = 0; i < rays; ++i) {
      if (is_covered(glm::mix(a, b, (i + 0.5) / rays))) ink.covered += on_paper / rays;
    }
    ink.length += on_paper;
  }

  bool is_covered(const Vec3& point) const {
    // Paper mm before the surface that a line touches: its triangles are less than that away.
    constexpr double kTouching = 0.2;
    const double near = std::max(kTouching / camera_.scale_at(point), 2 * solid_.resolution());
    return solid_.occluded(point, camera_.to_viewer(point), near, camera_.distance_to_viewer(point),
                           {});
  }

  const Camera& camera_;
  const Occluder& solid_;
};

/// Lays the annotations of one part.
class Laying {
 public:
  Laying(const Camera& camera, const PaperBreaks& breaks, const Occluder& solid, const Style& style,
         Layer& layer, std::vector<Area>& areas)
      : camera_(camera),
        breaks_(breaks),
        cover_(camera, solid),
        options_(style.pmi),
        ink_(style.pmi.color.empty() ? style.sheet.ink : style.pmi.color),
        layer_(layer),
        areas_(areas) {}

  void part(std::int32_t number, const PlacedPmi& placed) {
    for (const PmiItem& item : placed.pmi->items) {
      if (!is_wanted(item, options_)) continue;
      if (is_unseen(item)) add_name(item);
      if (!item.shown()) continue;
      if (ends_in_break(item, placed.placement)) {
        ++left_out_;
        continue;
      }
      const Vec3 middle = middle_of(item, placed.placement);
      if (!is_readable(item, placed.placement, {camera_.to_viewer(middle), camera_.right()},
                       options_.angle)) {
        ++turned_;
        name_view(item);
      } else if (options_.view.empty() && cover_.hides(item, placed.placement)) {
        ++covered_;  // what a view of the file shows is shown there
        name_view(item);
      } else {
        add(item, placed.placement, {number, item.faces.empty() ? -1 : item.faces.front()});
      }
    }
  }

  void report(const std::string& view, Diagnostics& diagnostics) const {
    const std::string in = view.empty() ? "" : fmt::format("view {}: ", view);
    std::string more = "; another view shows them";
    if (!better_.empty()) more += ", such as `saved_view " + better_ + "`";
    if (turned_ > 0) {
      diagnostics.add(
          Severity::Warning, "pmi.turned_away", turned_,
          fmt::format("{}annotations seen from behind, from their edge or upside down were "
                      "left out ({}){}",
                      in, turned_, more));
    }
    if (covered_ > 0) {
      diagnostics.add(
          Severity::Warning, "pmi.covered", covered_,
          fmt::format("{}annotations behind parts were left out ({}){}", in, covered_, more));
    }
    if (left_out_ > 0) {
      diagnostics.add(Severity::Warning, "pmi.left_out", left_out_,
                      fmt::format("{}annotations that begin or end in what a break leaves out are "
                                  "not drawn ({})",
                                  in, left_out_));
    }
    if (unseen_ > 0) {
      diagnostics.add(Severity::Warning, "pmi.not_shown", unseen_,
                      "dimensions or tolerances are numbers alone in the file, with no lines that "
                      "show them, and are not drawn: " +
                          names_);
    }
  }

 private:
  // Names of what is not drawn in one message; burin info lists all.
  static constexpr std::int64_t kMostNames = 8;

  void name_view(const PmiItem& item) {
    if (better_.empty() && !item.views.empty() && item.views.front() != options_.view) {
      better_ = item.views.front();
    }
  }

  void add_name(const PmiItem& item) {
    if (unseen_++ < kMostNames) {
      names_ += (names_.empty() ? "" : ", ") + (item.text.empty() ? item.name : item.text);
    } else if (unseen_ == kMostNames + 1) {
      names_ += ", ...";
    }
  }

  void add(const PmiItem& item, const Placement& place, const SourceId& source) {
    for (const PmiLine& line : item.lines) add(line, place, source, options_.line);
    const Vec2 by = shift_of_letters(item, place);
    Area area;
    area.part = source.part;
    area.role = "pmi";
    area.fill = ink_;
    for (const PmiLine& line : item.filled) {
      add(line, place, source, 0.5 * options_.line, by);
      area.rings.push_back(layer_.paths.back().points);
    }
    if (!area.rings.empty()) areas_.push_back(std::move(area));
  }

  /// Whether an annotation has points in a band and none on one of its sides.
  bool ends_in_break(const PmiItem& item, const Placement& place) const {
    for (const PaperBreaks::Band& band : breaks_.bands) {
      bool before = false, within = false, behind = false;
      for_points(item, place, [&](const Vec3& point) {
        const double at = glm::dot(breaks_.along, camera_.to_paper(point));
        (at <= band.low ? before : at >= band.high ? behind : within) = true;
      });
      if (within && !(before && behind)) return true;
    }
    return false;
  }

  /// All letters of an annotation move as one, so that they can be read in a gap.
  Vec2 shift_of_letters(const PmiItem& item, const Placement& place) const {
    Box2 box;
    for (const PmiLine& line : item.filled) {
      for (const Vec3& point : line.points) box.add(camera_.to_paper(place.point(point)));
    }
    return box.empty() ? Vec2(0) : breaks_.moved(box.center()) - box.center();
  }

  /// `by`: how far the line moves as it is; absent: as the places do that it passes.
  void add(const PmiLine& line, const Placement& place, const SourceId& source, double width,
           std::optional<Vec2> by = {}) {
    Path path;
    path.kind = LineClass::Frame;
    path.source = source;
    path.closed = line.closed;
    path.width = {width};
    for (const Vec3& point : line.points) {
      path.points3.push_back(place.point(point));
      const Vec2 whole = camera_.to_paper(path.points3.back());
      path.points.push_back(by ? whole + *by : breaks_.moved(whole));
    }
    layer_.paths.push_back(std::move(path));
  }

  const Camera& camera_;
  const PaperBreaks& breaks_;
  Cover cover_;
  const PmiOptions& options_;
  std::string ink_;
  Layer& layer_;
  std::vector<Area>& areas_;
  std::int64_t turned_ = 0, covered_ = 0, unseen_ = 0, left_out_ = 0;
  /// Of what is not shown in the file; a view that shows what was left out.
  std::string names_, better_;
};

}  // namespace

std::vector<OptionRow<PmiOptions>> pmi_option_rows() {
  using options::number;
  OptionRow<PmiOptions> color =
      options::text("color", &PmiOptions::color, "colour of annotations; empty = sheet.ink",
                    "a colour #rrggbb or nothing");
  color.set = [](PmiOptions& options, const OptionValue& value) {
    options.color = without_name(std::get<std::string>(value));
  };
  return {
      number("line", &PmiOptions::line, {0.01, 10, "mm"},
             "width of the lines of annotations of a CAD file, in mm; outlines of letters are half "
             "as wide"),
      std::move(color),
      number("angle", &PmiOptions::angle, {0, 90, "degrees"},
             "angle between the line of sight and the way that an annotation faces up to which it "
             "is drawn, in degrees"),
      options::text("view", &PmiOptions::view,
                    "the view saved in the file whose annotations alone are drawn; empty = all",
                    "the name of a view or nothing"),
  };
}

namespace {

/// The annotations that a view may draw, with where their part stands.
template <class Do>
void for_readable(const Scene& scene, std::span<const PartStyle> part_styles,
                  const PmiOptions& options, const ViewOptions& view, const Do& one) {
  const Vec3 to_viewer = glm::normalize(view.direction);
  const Vec3 right = glm::cross(view.up, to_viewer);
  const double length = glm::length(right);
  const Sightline sight{to_viewer, length > 0 ? right / length : right};
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const PlacedPmi& placed = scene.parts[i].pmi;
    if (!placed || (i < part_styles.size() && !part_styles[i].drawn)) continue;
    for (const PmiItem& item : placed.pmi->items) {
      if (!is_wanted(item, options) || !is_readable(item, placed.placement, sight, options.angle)) {
        continue;
      }
      one(item, placed.placement);
    }
  }
}

/// In the plane of an annotation, as its texts run.
std::vector<Vec3> box_about(const PmiLine& letter, const PmiPlane& plane, const Placement& place) {
  const Vec3 up = glm::cross(plane.normal, plane.along);
  Box2 box;
  for (const Vec3& p : letter.points) {
    const Vec3 from = p - plane.origin;
    box.add(Vec2(glm::dot(from, plane.along), glm::dot(from, up)));
  }
  const auto at = [&](double x, double y) {
    return place.point(plane.origin + x * plane.along + y * up);
  };
  return {at(box.min.x, box.min.y), at(box.max.x, box.min.y), at(box.max.x, box.max.y),
          at(box.min.x, box.max.y), at(box.min.x, box.min.y)};
}

}  // namespace

std::vector<std::vector<Vec3>> annotation_lines(const Scene& scene,
                                                std::span<const PartStyle> part_styles,
                                                const PmiOptions& options,
                                                const ViewOptions& view) {
  std::vector<std::vector<Vec3>> out;
  for_readable(scene, part_styles, options, view, [&](const PmiItem& item, const Placement& place) {
    const auto add = [&](const PmiLine& line) {
      std::vector<Vec3>& points = out.emplace_back();
      for (const Vec3& p : line.points) points.push_back(place.point(p));
      if (line.closed) points.push_back(points.front());
    };
    std::ranges::for_each(item.lines, add);
    for (const PmiLine& letter : item.filled) {
      if (item.plane) {
        out.push_back(box_about(letter, *item.plane, place));
      } else {
        add(letter);
      }
    }
  });
  return out;
}

Box3 detail::pmi_bounds(const Scene& scene, std::span<const PartStyle> part_styles,
                        const PmiOptions& options, const ViewOptions& view, const Mat3& axes) {
  Box3 box;
  for_readable(scene, part_styles, options, view, [&](const PmiItem& item, const Placement& place) {
    for_points(item, place, [&](const Vec3& point) { box.add(axes * point); });
  });
  return box;
}

void detail::lay_pmi(const Scene& scene, const PartStyles& part_styles, const AnnotatedView& view,
                     const Occluder& solid, const Style& style, Drawing& drawing) {
  Layer layer{"pmi", {}};
  layer.color = style.pmi.color;
  Laying laying(view.camera, view.breaks, solid, style, layer, drawing.areas);
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const PlacedPmi& placed = scene.parts[i].pmi;
    if (placed && part_styles.drawn(i)) laying.part(static_cast<std::int32_t>(i), placed);
  }
  laying.report(view.name, drawing.diagnostics);
  if (!layer.paths.empty()) drawing.layers.push_back(std::move(layer));
}

}  // namespace burin
