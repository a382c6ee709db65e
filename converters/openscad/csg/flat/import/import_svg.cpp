#include <burin/base/error.h>

#include "flat/clip.h"
#include "flat/transform.h"
#include "import_file.h"
#include "source.h"
#include "svg_shapes.h"
#include "text.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace burin::csg {
namespace {

constexpr double kInch = 25.4;

/// A length with its unit in mm; `of` where it says nothing but there is a box of so many units.
double millimetres(std::string_view text, std::optional<double> of, double dpi) {
  struct Unit {
    std::string_view name;
    double mm;
  };
  const Unit units[] = {{"px", kInch / 96}, {"pt", kInch / 72}, {"pc", kInch / 6},
                        {"in", kInch},      {"cm", 10},         {"mm", 1}};
  const std::string value(text);
  double number = 0;
  const char* end = scan_double(value.data(), value.data() + value.size(), number);
  if (!end) return of ? kInch * *of / dpi : 0;
  std::string_view rest(end, static_cast<std::size_t>(value.data() + value.size() - end));
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  if (rest.empty()) return kInch * number / dpi;
  for (const Unit& unit : units) {
    if (unit.name == rest) return unit.mm * number;
  }
  // Shares of a page that is not there, and sizes of a font.
  if (rest == "%" || rest == "em" || rest == "ex") return of.value_or(0);
  return of ? kInch * *of / dpi : 0;
}

/// Where the page puts user units: scale * (p - box) + align.
struct Page {
  double height = 0;
  Vec2 scale{1}, align{0}, box{0};
};

double aligned(std::string_view where, double page, double content) {
  return where == "Mid" ? (page - content) / 2 : where == "Max" ? page - content : 0;
}

/// A value of preserveAspectRatio, such as "xMidYMax slice".
void fit(Page& page, std::string_view rule, Vec2 size, Vec2 box) {
  std::string_view where = "xMidYMid";
  bool meet = true;
  for (const std::string_view word : {"xMinYMin", "xMidYMin", "xMaxYMin", "xMinYMid", "xMidYMid",
                                      "xMaxYMid", "xMinYMax", "xMidYMax", "xMaxYMax", "none"}) {
    if (rule.find(word) != std::string_view::npos) where = word;
  }
  if (where == "none") return;
  meet = rule.find("slice") == std::string_view::npos;
  page.scale =
      Vec2(meet ? std::min(page.scale.x, page.scale.y) : std::max(page.scale.x, page.scale.y));
  page.align = {aligned(where.substr(1, 3), size.x, page.scale.x * box.x),
                aligned(where.substr(5, 3), size.y, page.scale.y * box.y)};
}

class SvgReader {
 public:
  SvgReader(Evaluation& e, std::uint32_t node, const Source& source)
      : e_(e),
        source_(source),
        dpi_(e.tree.nodes[node].number("dpi", 72)),
        center_(e.tree.nodes[node].truth("center", false)) {}

  Region read() {
    pugi::xml_document document;
    const std::string_view bytes = source_.bytes();
    const pugi::xml_parse_result result = document.load_buffer(bytes.data(), bytes.size());
    if (!result) {
      source_.fail_at_line(
          bytes.data() + std::min<std::size_t>(
                             static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                             bytes.size()),
          fmt::format("is no readable SVG ({}); export it again", result.description()));
    }
    walk(document);
    return placed();
  }

 private:
  /// Without recursion: files may be as deep as they like.
  void walk(const pugi::xml_node& root) {
    struct Open {
      pugi::xml_node node;
      Affine matrix;
    };
    std::vector<Open> open;
    const auto push = [&](const pugi::xml_node& parent, const Affine& matrix) {
      // The last on top of the first, to be taken in their order.
      for (pugi::xml_node c = parent.last_child(); c; c = c.previous_sibling()) {
        if (c.type() == pugi::node_element) open.push_back({c, matrix});
      }
    };
    push(root, {});
    while (!open.empty()) {
      e_.run.check();
      const Open now = open.back();
      open.pop_back();
      const std::string_view name = now.node.name();
      if (name == "defs") continue;
      Affine matrix = now.matrix;
      if (name == "svg") {
        page(now.node);
      } else {
        const Affine own = matrix * svg_transform(now.node.attribute("transform").value());
        shape(now.node, own);
        if (name == "g" || name == "text" || name == "tspan") matrix = own;
      }
      push(now.node, matrix);
    }
  }

  void page(const pugi::xml_node& node) {
    const std::vector<double> box = svg_numbers(node.attribute("viewBox").value());
    const bool valid = box.size() == 4 && box[2] > 0 && box[3] > 0;
    const auto size = [&](const char* name, std::size_t i) {
      return millimetres(node.attribute(name).value(),
                         valid ? std::optional<double>(box[i]) : std::nullopt, dpi_);
    };
    const Vec2 mm(size("width", 2), size("height", 3));
    page_.height = mm.y;
    if (!valid) return;
    page_.box = {box[0], box[1]};
    page_.scale = mm / Vec2(box[2], box[3]);
    page_.align = Vec2(0);
    fit(page_, node.attribute("preserveAspectRatio").value(), mm, {box[2], box[3]});
  }

  static std::string_view style_of(const pugi::xml_node& node, const char* name) {
    if (const std::string_view own = node.attribute(name).value(); !own.empty()) return own;
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
      const std::size_t end = std::min(style.find(';'), style.size());
      const std::string_view entry = style.substr(0, end);
      const std::size_t colon = entry.find(':');
      if (colon != std::string_view::npos && entry.substr(0, colon) == name)
        return entry.substr(colon + 1);
      style.remove_prefix(std::min(end + 1, style.size()));
    }
    return {};
  }
  static SvgStroke stroke_of(const pugi::xml_node& node) {
    constexpr double kThinnest = 0.01;
    SvgStroke stroke;
    const double width = svg_number(style_of(node, "stroke-width"));
    if (width >= kThinnest) stroke.width = width;
    const std::string_view cap = style_of(node, "stroke-linecap"),
                           join = style_of(node, "stroke-linejoin");
    if (cap == "butt") stroke.cap = SvgStroke::Cap::Butt;
    if (cap == "round") stroke.cap = SvgStroke::Cap::Round;
    if (join == "bevel") stroke.join = SvgStroke::Join::Bevel;
    if (join == "round") stroke.join = SvgStroke::Join::Round;
    return stroke;
  }

  void shape(const pugi::xml_node& node, const Affine& matrix) {
    const auto value = [&](const char* name) { return svg_number(node.attribute(name).value()); };
    const auto pair = [&](const char* x, const char* y) { return Vec2(value(x), value(y)); };
    const std::string_view name = node.name();
    Region shape;
    if (name == "path") {
      shape = svg_path(node.attribute("d").value(), stroke_of(node));
    } else if (name == "circle") {
      shape = svg_ellipse(pair("cx", "cy"), Vec2(value("r")));
    } else if (name == "ellipse") {
      shape = svg_ellipse(pair("cx", "cy"), pair("rx", "ry"));
    } else if (name == "rect") {
      shape = rectangle(node, pair("x", "y"), pair("width", "height"), pair("rx", "ry"));
    } else if (name == "line") {
      shape.outlines = stroked({pair("x1", "y1"), pair("x2", "y2")}, stroke_of(node));
    } else if (name == "polygon" || name == "polyline") {
      const std::vector<double> v = svg_numbers(node.attribute("points").value());
      std::vector<Vec2> points;
      for (std::size_t i = 0; i + 1 < v.size(); i += 2) points.emplace_back(v[i], v[i + 1]);
      if (name == "polygon")
        shape.outlines.push_back(straight(std::move(points)));
      else
        shape.outlines = stroked(points, stroke_of(node));
    } else {
      return;
    }
    shapes_.push_back(transformed(shape, matrix));
  }

  static Outline straight(std::vector<Vec2> points) {
    Outline out{std::move(points), {}};
    out.arc.assign(out.points.size(), -1);
    return out;
  }
  static Region rectangle(const pugi::xml_node& node, Vec2 at, Vec2 size, Vec2 r) {
    constexpr double kNone = 1e-8;
    if (std::abs(r.x) < kNone && std::abs(r.y) < kNone) {
      return {{straight({at, at + Vec2(size.x, 0), at + size, at + Vec2(0, size.y)})}, {}};
    }
    if (std::abs(r.x) < kNone) r.x = r.y;
    if (std::abs(r.y) < kNone) r.y = r.x;
    r = glm::min(r, size / 2.0);
    const Vec2 b = at + size;
    return svg_path(
        fmt::format("M {},{} H {} A {},{} 0 0 1 {},{} V {} A {},{} 0 0 1 {},{} H {} A {},{} 0 0 1 "
                    "{},{} V {} A {},{} 0 0 1 {},{} z",
                    at.x + r.x, at.y, b.x - r.x, r.x, r.y, b.x, at.y + r.y, b.y - r.y, r.x, r.y,
                    b.x - r.x, b.y, at.x + r.x, r.x, r.y, at.x, b.y - r.y, at.y + r.y, r.x, r.y,
                    at.x + r.x, at.y),
        stroke_of(node));
  }

  Region placed() const {
    Vec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Region& shape : shapes_) {
      for (const Outline& o : shape.outlines) {
        for (const Vec2& p : o.points) {
          low = glm::min(low, page_.scale * p);
          high = glm::max(high, page_.scale * p);
        }
      }
    }
    Vec2 shift(page_.align.x, page_.height - page_.align.y);
    if (center_) shift = Vec2(-0.5, 0.5) * (low + high);
    const Affine place{{page_.scale.x, 0}, {0, -page_.scale.y}, shift - page_.scale * page_.box};
    std::vector<Region> regions;
    for (const Region& shape : shapes_) {
      Region region = transformed(shape, place);
      std::erase_if(region.outlines, [](const Outline& o) { return o.points.size() < 3; });
      regions.push_back(odd_places(region));
    }
    return clip(ClipOp::Union, regions);
  }

  Evaluation& e_;
  const Source& source_;
  double dpi_;
  bool center_;
  Page page_;
  std::vector<Region> shapes_;
};

}  // namespace

Region import_svg(Evaluation& e, std::uint32_t node) {
  return if_there(e, node, [&]() -> Region {
    const Source source(file_of(e, node), e.run);
    return SvgReader(e, node, source).read();
  });
}

}  // namespace burin::csg
