#include "wanted_views.h"

#include <burin/base/error.h>
#include <burin/illustrate/illustrate.h>

#include "sheet_dimensions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

/// Radians between directions that are one.
constexpr double kSame = 1e-6;

/// Whether a view sees the planes of a section as lines.
bool sees_edge(const Vec3& direction, const SectionView& section) {
  const Vec3 d = glm::normalize(direction);
  return std::abs(glm::dot(d, section.axis)) < kSame &&
         std::abs(glm::dot(d, section.across)) < kSame;
}

/// "front", "top", ... of a direction, or nothing.
std::string principal_name(const Vec3& direction) {
  for (const char* name : {"front", "back", "left", "right", "top", "bottom"}) {
    const Vec3 d = view_in_grid(name).direction;
    if (glm::distance(glm::normalize(d), glm::normalize(direction)) < kSame) return name;
  }
  return "";
}

/// The view that shows best where a section cuts, where none is named; or nothing.
std::string edge_view(const SectionView& section) {
  for (const char* name : {"top", "front", "left"}) {
    if (sees_edge(view_in_grid(name).direction, section)) return name;
  }
  return "";
}

WantedView named(const Illustration& illustration, const std::string& name) {
  ViewOptions view = illustration.view;
  const NamedView known = view_in_grid(name);
  view.direction = known.direction;
  view.up = known.up;
  view.center.reset();  // each stands in the middle of its box
  return {name, name, view};
}

WantedView asked_for(const Illustration& illustration) {
  ViewOptions view = illustration.view;
  view.center.reset();
  std::string name = principal_name(view.direction);
  if (name.empty()) name = "view";
  return {name, name, view};
}

/// In the place of the view from that side, where that is free.
WantedView of_section(const SectionView& section, const std::vector<WantedView>& others,
                      const Illustration& illustration) {
  const std::string side = principal_name(section.direction);
  WantedView wanted = asked_for(illustration);
  wanted.name = section.letter + "-" + section.letter;
  const bool is_free =
      !side.empty() && std::ranges::find(others, side, &WantedView::stands_as) == others.end();
  wanted.stands_as = is_free ? side : wanted.name;
  wanted.section = &section;
  ViewOptions& view = wanted.view;
  view.direction = section.direction;
  if (!side.empty()) {
    view.up = view_in_grid(side).up;
  } else if (glm::length(glm::cross(glm::normalize(view.up), section.direction)) < kSame) {
    view.up = any_orthogonal(section.direction);
  }
  wanted.room.top = section_caption(illustration.style.callout);
  return wanted;
}

/// Along the line of the cut, which the view sees.
Vec3 along_cut(const ViewOptions& view, const SectionView& section) {
  const Vec3 along = glm::normalize(glm::cross(section.axis, glm::normalize(view.direction)));
  return glm::dot(along, section.across) < 0 ? -along : along;
}

void keep_room_for_mark(const SectionView& section, const CalloutOptions& style, WantedView& view) {
  const SectionReach reach = section_reach(style);
  const double room = reach.beyond + reach.along;
  const Vec3 along = glm::abs(axes_of(view.view) * along_cut(view.view, section));
  const double x = room * along.x, y = room * along.y;
  view.room = larger(view.room, {y, x, y, x});
}

/// In model mm, from one side of what is drawn to the other.
std::vector<Vec3> course_of(const SectionView& section, const Scene& scene,
                            const Illustration& illustration, const ViewOptions& view) {
  const Vec3 along = along_cut(view, section), to_viewer = glm::normalize(view.direction);
  const Mat3 axes = glm::transpose(Mat3(along, section.axis, to_viewer));
  const Box3 box = drawn_bounds(scene, illustration.illustrate.part_styles, axes);
  const auto at = [&](double place, double face) {
    return place * along + face * section.axis + box.center().z * to_viewer;
  };
  const bool falls = section.ends.size() > 1 && section.ends[1] < section.ends[0];
  std::vector<Vec3> course{at(falls ? box.max.x : box.min.x, section.faces.front())};
  for (std::size_t i = 0; i < section.ends.size(); ++i) {
    course.push_back(at(section.ends[i], section.faces[i]));
    course.push_back(at(section.ends[i], section.faces[i + 1]));
  }
  course.push_back(at(falls ? box.min.x : box.max.x, section.faces.back()));
  return course;
}

/// The view that is asked for alone, after those that see its sections from their edges where it
/// does not itself.
std::vector<WantedView> views_about(const Illustration& illustration) {
  std::vector<WantedView> views{asked_for(illustration)};
  for (const SectionView& section : illustration.section_views) {
    const std::string edge = edge_view(section);
    if (edge.empty() || parent_of(views, illustration, section)) continue;
    if (std::ranges::find(views, edge, &WantedView::name) != views.end()) continue;
    views.insert(views.end() - 1, named(illustration, edge));
  }
  return views;
}

/// Leaves hidden lines to those that are named, where any are.
void choose_hidden(const std::vector<std::string>& names, std::vector<WantedView>& views) {
  if (names.empty()) return;
  std::vector<std::string> known;
  for (WantedView& view : views) {
    known.push_back(view.section ? view.section->letter : view.name);
    view.none_hidden = std::ranges::find(names, known.back()) == names.end();
  }
  for (const std::string& name : names) {
    if (views.empty() || std::ranges::find(known, name) != known.end()) continue;
    throw UsageError(fmt::format("`hidden_views`: '{}' is none of the views of the sheet: {}", name,
                                 fmt::join(known, ", ")));
  }
}

}  // namespace

Mat3 axes_of(const ViewOptions& view) {
  const ViewOptions sides{.direction = view.direction, .up = view.up};
  return Camera::fit([](const Mat3&) { return Box3{Vec3(-1), Vec3(1)}; }, sides).axes();
}

std::string name_of(const ViewOptions& view) {
  std::string principal = principal_name(view.direction);
  if (!principal.empty()) return principal;
  for (const char* name : {"iso", "dimetric", "trimetric"}) {
    const Vec3 d = named_view(name).direction;
    if (glm::distance(glm::normalize(d), glm::normalize(view.direction)) < kSame) return name;
  }
  return "view";
}

std::vector<WantedView> wanted_views(const Illustration& illustration) {
  std::vector<WantedView> views;
  for (const std::string& name : illustration.views) views.push_back(named(illustration, name));
  const std::vector<SectionView>& sections = illustration.section_views;
  if (views.empty() && !sections.empty()) views = views_about(illustration);
  for (const SectionView& section : sections)
    views.push_back(of_section(section, views, illustration));
  for (const SectionView& section : sections) {
    const auto parent = parent_of(views, illustration, section);
    if (!parent) continue;
    views[*parent].marked = true;
    keep_room_for_mark(section, illustration.style.callout, views[*parent]);
  }
  choose_hidden(illustration.hidden_views, views);
  return views;
}

std::optional<std::size_t> parent_of(const std::vector<WantedView>& views,
                                     const Illustration& illustration, const SectionView& section) {
  if (illustration.explode.wanted) return std::nullopt;  // parts are not where they were cut
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!views[i].section && sees_edge(views[i].view.direction, section)) return i;
  }
  return std::nullopt;
}

std::optional<SectionMark> mark_of(const SectionView& section, const Scene& scene,
                                   const Illustration& illustration, const ViewOptions& view,
                                   const PlacedView& placed) {
  const Camera& camera = placed.camera;
  SectionMark mark{.course = {},
                   .sight = -Vec2(glm::dot(camera.right(), section.direction),
                                  glm::dot(camera.up(), section.direction)),
                   .letter = section.letter};
  const std::vector<Vec3> places = course_of(section, scene, illustration, view);
  if (std::ranges::all_of(
          places, [&](const Vec3& p) { return placed.breaks.leaves_out(camera.to_paper(p)); })) {
    return std::nullopt;
  }
  for (const Vec3& p : places) mark.course.push_back(placed.at(p));
  std::vector<Vec2>& course = mark.course;
  const double beyond = section_reach(illustration.style.callout).beyond;
  const auto prolong = [&](Vec2& end, Vec2 next) { end += beyond * glm::normalize(end - next); };
  prolong(course.front(), course[1]);
  prolong(course.back(), course[course.size() - 2]);
  return mark;
}

void report_no_line(Scene& scene, const Illustration& illustration, const SectionView& section) {
  const std::string edge = edge_view(section);
  std::string why = "no view sees it from its edge";
  if (illustration.explode.wanted) {
    why = "parts that came apart are not where they were cut";
  } else if (!edge.empty()) {
    why += fmt::format(": add {} to `views`", edge);
  }
  scene.diagnostics.add(Severity::Warning, "section.no_line", 1,
                        fmt::format("{}the sheet does not show where section {}-{} cuts: {}",
                                    section.place, section.letter, section.letter, why));
}

}  // namespace burin::detail
