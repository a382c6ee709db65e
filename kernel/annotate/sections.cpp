#include <burin/annotate/place.h>
#include <burin/annotate/sections.h>
#include <burin/base/nearest_along.h>
#include <burin/drawing/font.h>
#include <burin/drawing/ink.h>

#include "frame_path.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace burin {
namespace {

using detail::arrow_head, detail::line;

// Of the height of letters: the wide ends of the line and the stretches on both sides of a corner;
// the arrow's shaft and head; between a letter and what is beside it; between a section and its
// name.
constexpr double kEnd = 1.0, kCorner = 0.6, kShaft = 1.8, kHead = 0.7, kBeside = 0.35, kAbove = 0.5;
// Paper mm that the line stands out of what the view shows, before its wide end.
constexpr double kOut = 3;
// Of the width of narrow lines: outlines are as wide (ISO 128-2).
constexpr double kWide = 2.8;
constexpr std::string_view kDimensions = "dimensions";
/// Paper mm: a centre line that near lies under the line of a cut.
constexpr double kUnder = 0.1;

/// Whether a line that is seen runs through letters. `only`: of that layer; empty: of any.
bool is_crossed(const Text& text, const Drawing& sheet, std::string_view only) {
  const Box2 box = text_box(text);
  const Vec2 a = box.min, c = box.max, b(c.x, a.y), d(a.x, c.y);
  const auto crosses = [&](const Vec2& from, const Vec2& to) {
    return box.contains(from) || box.contains(to) || segments_cross(from, to, a, c) ||
           segments_cross(from, to, b, d);
  };
  for (const Layer& layer : sheet.layers) {
    if (!only.empty() && layer.name != only) continue;
    for (const Path& path : layer.paths) {
      for (std::size_t i = 1; path.visible && i < path.points.size(); ++i) {
        if (crosses(path.points[i - 1], path.points[i])) return true;
      }
    }
  }
  return false;
}

/// Where the letter of an end stands: beside the arrow's shaft, away from the drawing.
Text letter_at(Vec2 end, Vec2 inwards, const SectionMark& mark, double h) {
  const Vec2 half = 0.5 * Vec2(text_width(mark.letter, h), h);
  const double reach = kBeside * h + glm::dot(glm::abs(inwards), half);
  const Vec2 middle = end - 0.5 * kShaft * h * mark.sight - reach * inwards;
  return {middle - Vec2(0, half.y), h, TextAnchor::Middle, mark.letter, "section", 0};
}

/// Or behind the arrow's tail, where lines of dimensions run beside its shaft.
Text clear_letter(Vec2 end, Vec2 inwards, const SectionMark& mark, double h, const Drawing& sheet) {
  Text beside = letter_at(end, inwards, mark, h);
  if (!is_crossed(beside, sheet, kDimensions)) return beside;
  const Vec2 half = 0.5 * Vec2(text_width(mark.letter, h), h);
  const double reach = (kShaft + kBeside) * h + glm::dot(glm::abs(mark.sight), half);
  Text behind = beside;
  behind.at = end - reach * mark.sight - Vec2(0, half.y);
  return is_crossed(behind, sheet, kDimensions) ? beside : behind;
}

/// An end of a line, moved out until its arrow and letter stand clear of those that are there.
Vec2 free_end(Vec2 end, Vec2 inwards, const SectionMark& mark, double h, const Layer& layer) {
  constexpr int kMost = 8;
  const auto is_taken = [&](Vec2 at) {
    Box2 box = text_box(letter_at(at, inwards, mark, h));
    box.add(at), box.add(at - kShaft * h * mark.sight);
    return std::ranges::any_of(layer.texts,
                               [&](const Text& other) { return text_box(other).overlaps(box); });
  };
  for (int i = 0; i < kMost && is_taken(end); ++i) end -= h * inwards;
  return end;
}

/// An end of the line: wide, with an arrow that comes from the viewer's side, and its letter.
void lay_end(Vec2 end, Vec2 inwards, const SectionMark& mark, const CalloutOptions& style,
             const Drawing& sheet, Layer& layer) {
  const double h = style.height, wide = kWide * style.line;
  layer.paths.push_back(line(end, end + kEnd * h * inwards, wide));
  const Vec2 tail = end - kShaft * h * mark.sight;
  layer.paths.push_back(line(tail, end - 0.5 * kHead * h * mark.sight, style.line));
  layer.paths.push_back(arrow_head(end, mark.sight, kHead * h));
  layer.texts.push_back(clear_letter(end, inwards, mark, h, sheet));
}

/// Both sides of the corner in which a step ends, wide.
void lay_corner(Vec2 before, Vec2 corner, Vec2 after, const CalloutOptions& style, Layer& layer) {
  const auto towards = [&](Vec2 to) {
    const double length = glm::distance(corner, to);
    return corner + std::min(kCorner * style.height, 0.5 * length) / length * (to - corner);
  };
  Path path = line(towards(before), corner, kWide * style.line);
  path.points.push_back(towards(after));
  layer.paths.push_back(std::move(path));
}

/// Whether a line lies under a stretch of the course of a cut.
bool lies_under(const Path& path, const std::vector<Vec2>& course) {
  for (std::size_t i = 1; i < course.size(); ++i) {
    if (std::ranges::all_of(path.points, [&](const Vec2& p) {
          return distance_to_segment(course[i - 1], course[i], p) < kUnder;
        })) {
      return true;
    }
  }
  return false;
}

void leave_out_under(const SectionMark& mark, Drawing& sheet) {
  for (Layer& layer : sheet.layers) {
    if (layer.name != kCentreLayer) continue;
    std::erase_if(layer.paths, [&](const Path& path) { return lies_under(path, mark.course); });
  }
}

}  // namespace

std::vector<std::vector<Vec2>> lines_of(const SectionMark& mark, const CalloutOptions& style) {
  const double h = style.height;
  const std::size_t last = mark.course.size() - 1;
  std::vector<std::vector<Vec2>> lines{mark.course};
  for (const auto& [end, next] : {std::pair(mark.course[0], mark.course[1]),
                                  std::pair(mark.course[last], mark.course[last - 1])}) {
    lines.push_back({end, end - kShaft * h * mark.sight});
    const Box2 letter = text_box(letter_at(end, glm::normalize(next - end), mark, h));
    lines.push_back({letter.min, {letter.max.x, letter.min.y}, letter.max, letter.min});
  }
  return lines;
}

SectionReach section_reach(const CalloutOptions& style) {
  const double letter = 1.2 * style.height;  // no letter is wider
  return {.beyond = kOut + kEnd * style.height, .along = kBeside * style.height + letter};
}

double section_caption(const CalloutOptions& style) { return (1 + 2 * kAbove) * style.height; }

void lay_sections(Drawing& sheet, std::span<const SectionMark> marks,
                  std::span<const SectionName> names, const CalloutOptions& style) {
  Layer plane{std::string(kSectionPlaneLayer), {}}, over{"section-marks", {}};
  for (const SectionMark& mark : marks) {
    leave_out_under(mark, sheet);
    std::vector<Vec2> course = mark.course;
    const Vec2 first = glm::normalize(course[1] - course[0]),
               final = glm::normalize(course[course.size() - 2] - course.back());
    course.front() = free_end(course.front(), first, mark, style.height, over);
    course.back() = free_end(course.back(), final, mark, style.height, over);
    Path path = line(course.front(), course.back(), style.line);
    path.points = course;
    plane.paths.push_back(std::move(path));
    const std::size_t last = course.size() - 1;
    lay_end(course.front(), first, mark, style, sheet, over);
    lay_end(course.back(), final, mark, style, sheet, over);
    for (std::size_t i = 1; i < last; ++i)
      lay_corner(course[i - 1], course[i], course[i + 1], style, over);
  }
  for (const SectionName& name : names) {
    Text text{{name.drawn.center().x, name.drawn.max.y + kAbove * style.height},
              style.height,
              TextAnchor::Middle,
              name.letter + "-" + name.letter,
              "section",
              0};
    // Centre lines and extension lines go beyond the outline.
    constexpr int kMostSteps = 4;
    const double low = text.at.y;
    for (int i = 0; i < kMostSteps && is_crossed(text, sheet, ""); ++i) {
      text.at.y += kAbove * style.height;
    }
    if (is_crossed(text, sheet, "")) text.at.y = low;
    over.texts.push_back(std::move(text));
  }
  if (!plane.paths.empty()) sheet.layers.push_back(std::move(plane));
  sheet.layers.push_back(std::move(over));
}

}  // namespace burin
