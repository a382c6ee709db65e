#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/camera/standards.h>
#include <burin/converters/values.h>
#include <burin/options/meant.h>

#include "break_option.h"
#include "detail_option.h"
#include "draw_options.h"
#include "title_block_option.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

void set_paper(Draft& draft, const Asked& asked) {
  draft.plan.sheet.fits = equal_but_for_case(asked.text(), "fit");
  if (!draft.plan.sheet.fits) draft.plan.view.paper = Paper::named(asked.text());
}

void set_margin(Draft& draft, const Asked& asked) {
  SheetOptions& sheet = draft.plan.sheet;
  const Paper& paper = draft.plan.view.paper;
  const Vec2 room = sheet.fits ? Vec2(kLargestSheet) : Vec2(paper.width, paper.height);
  sheet.margin = margin_option(asked.spelled, asked.text(), room).value_or(sheet.margin);
}

void set_scale(Draft& draft, const Asked& asked) {
  draft.plan.sheet.iso_scale = equal_but_for_case(asked.text(), kIsoScale);
  draft.plan.view.scale.reset();
  if (draft.plan.sheet.iso_scale) return;
  draft.plan.view.scale = scale_option(asked.spelled, asked.text(), 1 / kLarge, kLarge);
}

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const StandardView& view : standard_views()) names.emplace_back(view.name);
  return names;
}

std::vector<std::string> paper_names() {
  std::vector<std::string> names;
  for (const StandardPaper& paper : standard_papers()) names.emplace_back(paper.name);
  names.emplace_back("fit");
  return names;
}

/// What other programs and people call the views, and directions that have no name.
std::vector<KnownWord> known_views(Spelling spelling) {
  return {
      {"front", {"frontal", "front view", "elevation", "face", "anterior"}},
      {"back", {"rear", "behind", "posterior"}},
      {"left", {"side", "left side", "port"}},
      {"right", {"right side", "starboard", "r"}},
      {"top", {"plan", "up", "upper", "above", "topdown", "top down", "bird", "birds eye"}},
      {"bottom", {"below", "under", "underneath", "lower", "down"}},
      {"iso",
       {"isometric", "axonometric", "axo", "isometry", "3d", "default", "home", "corner", "oblique",
        "cavalier", "cabinet", "diagonal", "three quarter", "iso view"}},
      {"dimetric", {"dimetry"}},
      {"trimetric", {"trimetry"}},
      {"perspective",
       {"persp", "perspective view", "pinhole"},
       spelled_message("a perspective is asked for by `perspective`, in degrees", all_options(),
                       spelling)},
  };
}

NamedView view_asked(const std::string& name, const Asked& asked) {
  const Spelling spelling =
      asked.spelled.starts_with("--") ? Spelling::Options : Spelling::Keywords;
  try {
    return named_view(name);
  } catch (const UsageError& e) {
    const bool several = name.find(',') != name.npos &&
                         std::ranges::any_of(name, [](unsigned char c) { return std::isalpha(c); });
    throw UsageError(e.what() + hint(name, known_views(spelling)) +
                     (several ? fmt::format("; {} draws several", called("views", spelling)) : ""));
  }
}

bool is_direction(const std::string& text) {
  try {
    return point_option("views", text).has_value();
  } catch (const UsageError&) {
    return false;
  }
}

/// Names of views, parted by commas; by semicolons where directions are among them. One direction
/// alone is one view.
std::vector<std::string> names_of_views(const Asked& asked) {
  const std::string& text = asked.text();
  const bool commas = text.find(';') == std::string::npos && !is_direction(text);
  const char between = commas ? ',' : ';';
  std::vector<std::string> views;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(between, at), text.size());
    std::string name = text.substr(at, end - at);
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    views.push_back(std::move(name));
    if (std::ranges::count(views, views.back()) > 1) {
      refuse_value(asked.spelled, "each view once", text);
    }
    at = end + 1;
  }
  return views;
}

void set_views(Draft& draft, const Asked& asked) {
  std::vector<std::string> views = names_of_views(asked);
  for (std::string& name : views) {
    name = lowered(name);
    view_asked(name, asked);  // throws
  }
  constexpr std::size_t kMostViews = 24;
  if (views.size() > kMostViews) refuse_value(asked.spelled, "24 views at the most", asked.text());
  draft.plan.views = std::move(views);
}

void set_details(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    draft.plan.details.push_back(detail_option(asked.spelled, text));
  }
}

void set_breaks(Draft& draft, const Asked& asked) {
  for (const std::string& text : asked.texts) {
    draft.plan.breaks.push_back(break_option(asked.spelled, text));
  }
}

}  // namespace

std::vector<RequestRow<Draft>> view_rows() {
  return {
      {{.option = {.name = "view",
                   .meaning = fmt::format("{}, or the direction from the model to the viewer "
                                          "(default iso)",
                                          fmt::join(view_names(), " ")),
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME|X,Y,Z",
        .fallback = "iso",
        .choices = view_names(),
        .python = "str | Sequence[float]",
        .also = {"camera", "direction", "orientation", "view direction", "projection direction",
                 "rotate", "rotation",  "azimuth",     "elevation",      "angle",
                 "angles", "viewpoint", "from",        "isometric",      "iso",
                 "front",  "top",       "side",        "left",           "right",
                 "bottom", "back",      "eye",         "look at",        "roll",
                 "pitch",  "yaw",       "dir"}},
       [](Draft& d, const Asked& a) {
         const NamedView named = view_asked(a.text(), a);
         d.plan.view.direction = named.direction;
         d.plan.view.up = named.up;
       }},
      {{.option = {.name = "saved_view",
                   .meaning = "look as a view does that a STEP file saves, with the annotations "
                              "that it shows; burin info lists them",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME",
        .also = {"pmi view", "annotation view", "model view", "mbd view", "camera name"}},
       [](Draft& d, const Asked& a) { d.plan.saved_view = a.text(); }},
      {{.option = {.name = "up",
                   .meaning = "up on the sheet (default 0,0,1; for top and bottom 0,1,0)",
                   .takes = Direction{},
                   .phrase = kDirectionPhrase},
        .group = kSheet,
        .label = "X,Y,Z",
        .also = {"up vector", "upvector", "z up", "y up"}},
       [](Draft& d, const Asked& a) { d.plan.view.up = std::get<Vec3>(a.value); }},
      {{.option = {.name = "perspective",
                   .meaning = "vertical field of view in degrees (default: orthographic)",
                   .takes = NumberRange{1, 120, "degrees"},
                   .phrase = "1 to 120 degrees"},
        .group = kSheet,
        .label = "DEG",
        .also = {"fov", "field of view", "focal length", "lens", "focal", "persp", "ortho",
                 "orthographic"}},
       [](Draft& d, const Asked& a) { d.plan.view.perspective = std::get<double>(a.value); }},
      {{.option = {.name = "views",
                   .meaning = "several views on one sheet at one scale, e.g. front,top,left,iso: "
                              "front, top ... about the front view, others in the corner",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME,NAME...",
        .python = "str | Sequence[str]",
        .also = {"multiview", "multi view", "three views", "view list", "orthographic views",
                 "viewports", "layout"}},
       set_views},
      {{.option = {.name = "hidden_views",
                   .meaning = "of several views those in which hidden lines are dashed, by the "
                              "names in views or the letters of sections (default all)",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME,NAME...",
        .python = "str | Sequence[str]",
        .also = {"hidden lines in", "dashed views", "hidden per view"}},
       [](Draft& d, const Asked& a) { d.plan.hidden_views = names_of_views(a); }},
      {{.option = {.name = "projection",
                   .meaning = "where the view from the left goes: first angle, to the right of "
                              "the front view, or third angle, to its left (default first)",
                   .takes = WordList{{"first", "third"}}},
        .group = kSheet,
        .label = "first|third",
        .fallback = "first",
        .also = {"first angle", "third angle", "projection method", "angle projection"}},
       [](Draft& d, const Asked& a) {
         d.plan.projection = std::get<std::uint64_t>(a.value) == 0 ? ProjectionMethod::FirstAngle
                                                                   : ProjectionMethod::ThirdAngle;
       }},
      {{.option = {.name = "break_view",
                   .meaning =
                       "leave a stretch of a long part out of the views that show it from "
                       "the side, and move its ends together: auto, the long stretches that "
                       "keep their cross-section; those along x, y, z or a direction; or "
                       "from where to where, z:20..180 in model mm; repeatable; looks: style "
                       "keys break.*",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "auto|AXIS[:FROM..TO]",
        .choices = {"auto", "x", "y", "z"},
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"break", "breaks", "broken", "broken view", "interrupted view", "shorten",
                 "break line", "break lines", "interrupt", "foreshorten", "partial view"}},
       set_breaks},
      {{.option = {.name = "detail",
                   .meaning = "draw a place again beside the view, larger, in a circle: parts by "
                              "name, or a point and a radius in model mm; at a scale, or as large "
                              "as fits on the sheet; repeatable",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME|X,Y,Z,R[=A:B]",
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"zoom", "magnify", "magnifier", "detail view", "inset", "loupe", "enlarge",
                 "close up"}},
       set_details},
      {{.option = {.name = "dimensions",
                   .meaning = "write lengths beside the drawing: overall, width, depth and height "
                              "along the axes of the model, or none (default none); looks: style "
                              "keys dimension.*",
                   .takes = WordList{{"none", "overall"}}},
        .group = kSheet,
        .label = "none|overall",
        .fallback = "none",
        .also = {"dimension", "measure", "measurements", "size labels", "bounding box dimensions",
                 "overall dimensions", "lengths"}},
       [](Draft& d, const Asked& a) {
         d.plan.overall_dimensions = std::get<std::uint64_t>(a.value) == 1;
       }},
  };
}

std::vector<RequestRow<Draft>> sheet_rows() {
  return {
      {{.option = {.name = "paper",
                   .meaning = "A0..A6, B0..B6, letter, legal, tabloid (A4p is portrait), mm, e.g. "
                              "200x150, or fit: the drawing and its margin, at --scale or 1 "
                              "(default A4)",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME|WxH",
        .fallback = "A4",
        .choices = paper_names(),
        .python = "str | Sequence[float]",
        .also = {"size", "page", "page size", "sheet", "sheet size", "format size", "width",
                 "height", "canvas", "canvas size", "landscape", "portrait", "paper size",
                 "page format", "crop", "fit", "dimensions of sheet"}},
       set_paper},
      {{.option = {.name = "scale",
                   .meaning = "paper mm for a model mm, also as 1:2; iso: the largest of ISO 5455 "
                              "(1:1, 2:1, 5:1 ..., 1:2, 1:5 ...) that fits (default: fit to the "
                              "sheet)",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "S|A:B|iso",
        .choices = {"iso"},
        .python = "float | str",
        .also = {"factor", "scale factor", "ratio", "standard scale", "iso scale", "iso 5455"}},
       set_scale},
      {{.option = {.name = "center",
                   .meaning = "the model point in the middle of the sheet (default: the middle of "
                              "the drawing)",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "X,Y,Z",
        .python = "Sequence[float]",
        .also = {"centre", "middle", "target", "focus", "pan", "offset"}},
       [](Draft& d, const Asked& a) { d.plan.view.center = point_option(a.spelled, a.text()); }},
      {{.option = {.name = "margin",
                   .meaning = "empty border of a fitted sheet; one number, or top, right, bottom, "
                              "left (default 10)",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "MM|T,R,B,L",
        .fallback = "10",
        .python = "float | Sequence[float]",
        .also = {"margins", "padding", "border", "inset margin", "bleed"}},
       set_margin},
      {{.option = {.name = "title_block",
                   .meaning = "a title block in the lower right corner: iso, of ISO 7200, or "
                              "FILE.svg, a template whose texts are fields, also of TechDraw; "
                              "none: as if not asked for",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "iso|FILE.svg",
        .choices = {"iso", "none"},
        .also = {"titleblock", "title strip", "frame", "sheet template", "template", "border frame",
                 "schriftfeld", "drawing frame", "iso 7200", "stamp"}},
       set_title_block},
      {{.option = {.name = "title_block_field",
                   .meaning = "text of a field of the title block, e.g. number=A-100; title, "
                              "scale and model have values by themselves; repeatable",
                   .takes = FreeText{}},
        .group = kSheet,
        .label = "NAME=TEXT",
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"title field", "author", "drawing number", "revision", "company", "date",
                 "sheet number", "approved by"}},
       set_title_block_fields},
  };
}

}  // namespace burin::detail
