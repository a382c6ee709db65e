#include "section_option.h"

#include <burin/base/error.h>
#include <burin/converters/values.h>

#include "draw_options.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace burin::detail {
namespace {

constexpr const char* kTakes =
    "an axis x, y or z, one with a sign, or X,Y,Z, and =MM; quarter, or a list: x,y for a "
    "quarter, y=2,x=10,y=6 for steps";

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

bool across_the_same(const SectionPlane& a, const SectionPlane& b) {
  constexpr double kSame = 1e-9;
  return std::abs(glm::dot(a.axis, b.axis)) > 1 - kSame;
}

}  // namespace

std::string wrong_steps(const std::vector<SectionPlane>& planes) {
  if (planes.size() < 3 || planes.size() % 2 == 0) {
    return "steps are planes in turn: a cut, where it ends, the next cut, ...; three or more";
  }
  int way = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const SectionPlane& plane = planes[i];
    if (!across_the_same(plane, planes[i % 2])) return "steps take turns between two axes";
    if (i % 2 == 0) continue;
    if (across_the_same(plane, planes[0])) return "a step ends across another axis than it cuts";
    if (!plane.offset) return "where a step ends takes =MM";
    if (i < 3) continue;
    const int turn = *plane.offset > *planes[i - 2].offset ? 1 : -1;
    if (*plane.offset == *planes[i - 2].offset || (way != 0 && turn != way)) {
      return "steps go one way: where they end rises or falls";
    }
    way = turn;
  }
  return "";
}

Section section_option(const std::string& spelled, const std::string& text) {
  Section section;
  const bool listed =
      text.find(',') != std::string::npos && text.find_first_of("xyz") != std::string::npos;
  try {
    if (text == "quarter") {
      section.planes = {cut_option(spelled, "x"), cut_option(spelled, "y")};
    } else if (!listed) {
      section.planes = {cut_option(spelled, text)};
    } else {
      for (const std::string& one : parted(text))
        section.planes.push_back(cut_option(spelled, one));
    }
  } catch (const UsageError&) {
    refuse_value(spelled, kTakes, text);
  }
  if (!listed) return section;
  const std::vector<SectionPlane>& planes = section.planes;
  section.steps = planes.size() > 2 && across_the_same(planes[0], planes[2]);
  if (section.steps) {
    const std::string wrong = wrong_steps(planes);
    if (!wrong.empty()) refuse_value(spelled, wrong, text);
    return section;
  }
  for (std::size_t i = 1; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (across_the_same(planes[i], planes[j])) refuse_value(spelled, kTakes, text);
    }
  }
  return section;
}

Section section_of_box(const Box3& box) {
  Section section;
  for (int k = 0; k < 3; ++k) {
    SectionPlane plane{.axis = Vec3(0), .side = 1, .offset = box.min[k]};
    plane.axis[k] = 1;
    section.planes.push_back(plane);
    plane.side = -1;
    plane.offset = box.max[k];
    section.planes.push_back(plane);
  }
  return section;
}

Section section_box_option(const std::string& spelled, const std::string& text) {
  const std::optional<Box3> box = box_option(spelled, text);
  if (!box) refuse_value(spelled, "a box x0,y0,z0,x1,y1,z1", text);
  return section_of_box(*box);
}

Section section_around_option(const std::string& spelled, const std::string& text) {
  double v[4];
  if (!parse_list(text, v) || !(v[3] > 0 && v[3] <= 1e12)) {
    refuse_value(spelled, "a point and a radius over 0, X,Y,Z,R", text);
  }
  Section section;
  section.around = {{v[0], v[1], v[2]}, v[3]};
  return section;
}

namespace {

void set_sections(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    draft.plan.sections.push_back(section_option(asked.spelled, text));
  }
}

void set_section_views(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    Section section = section_option(asked.spelled, text);
    if (section.planes.size() > 1 && !section.steps) {
      refuse_value(asked.spelled, "one plane, or steps: a view shows one cut", text);
    }
    section.own_view = true;
    draft.plan.sections.push_back(std::move(section));
  }
}

/// "none" alone: all are cut.
void set_uncut(Draft& draft, const Asked& asked) {
  const bool none = asked.texts.size() == 1 && asked.texts.front() == "none";
  draft.plan.uncut = none ? std::vector<std::string>{} : asked.texts;
}

}  // namespace

std::vector<RequestRow<Draft>> section_rows() {
  constexpr const char* kPython = "str | Sequence[str]";
  return {
      {{.option = {.name = "section",
                   .meaning =
                       "cut the parts open by a plane across x, y, z or a direction, at a "
                       "coordinate in mm (default the middle); the half towards the viewer goes, "
                       "+y and -y choose one; x,y: only the quarter beyond both; y=2,x=10,y=6: in "
                       "steps, at y=2 until x=10; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "AXIS[=MM][,...]|quarter",
        .choices = {"x", "y", "z", "quarter"},
        .many = true,
        .python = kPython,
        .also = {"cut", "cutaway", "cut plane", "clip", "clipping", "clip plane", "slice",
                 "cross section", "crosssection", "section plane", "section view", "half",
                 "plane"}},
       set_sections},
      {{.option = {.name = "section_view",
                   .meaning =
                       "a view of its own for a section, beside the others: A-A; an axis and where "
                       "it cuts as `section` takes them; the first view that sees the cut from "
                       "its edge shows its line, with arrows and letters; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "AXIS[=MM][,...]",
        .choices = {"x", "y", "z"},
        .many = true,
        .python = kPython,
        .also = {"section line", "cutting line", "a a", "section aa", "cut view", "sectional view",
                 "view section", "sectioned view"}},
       set_section_views},
      {{.option = {.name = "section_box",
                   .meaning = "take away what is inside a box x0,y0,z0,x1,y1,z1, in model mm",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "X0,..,Z1",
        .python = "str | Sequence[float]",
        .also = {"clip box", "crop box", "box", "bounding box cut"}},
       [](Draft& d, const Asked& a) {
         d.plan.sections.push_back(section_box_option(a.spelled, a.text()));
       }},
      {{.option = {.name = "section_around",
                   .meaning =
                       "break out what is before a point of the model, as far as a radius R around "
                       "it, in model mm",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "X,Y,Z,R",
        .python = "str | Sequence[float]",
        .also = {"breakout", "break out", "broken out"}},
       [](Draft& d, const Asked& a) {
         d.plan.sections.push_back(section_around_option(a.spelled, a.text()));
       }},
      {{.option = {.name = "section_exclude",
                   .meaning =
                       "parts that sections leave whole (default: bolts, shafts, keys, pins and "
                       "the like, by their names); none: cut all; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME|none",
        .choices = {"none"},
        .many = true,
        .python = kPython,
        .also = {"uncut", "section skip", "no cut"}},
       set_uncut},
  };
}

}  // namespace burin::detail
