#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/pictures.h>
#include <burin/drawing/font.h>

#include "svg_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr double kChords = 0.01;      // paper mm between curves and their chords
constexpr double kLeastLine = 0.05;   // paper mm
constexpr double kOutline = 0.13;     // paper mm of the outline of what is filled
constexpr double kBesideLines = 0.5;  // paper mm between a value and a line of its cell
constexpr double kLevel = 1e-3;       // sine of an angle that nobody sees

/// What others call the fields of ISO 7200: the names of TechDraw's templates, without what is no
/// letter.
const std::map<std::string, const char*, std::less<>>& other_names() {
  static const std::map<std::string, const char*, std::less<>> names{
      {"drawingtitle", "title"},
      {"titleline1", "title"},
      {"fctitle", "title"},
      {"drawingname", "title"},
      {"subtitle", "supplementary_title"},
      {"titleline2", "supplementary_title"},
      {"dn", "number"},
      {"drawingnumber", "number"},
      {"fcrev", "revision"},
      {"rev", "revision"},
      {"version", "revision"},
      {"fcdate", "date"},
      {"creationdate", "date"},
      {"fcsh", "sheet"},
      {"sheetnumber", "sheet"},
      {"fcsc", "scale"},
      {"authorname", "author"},
      {"designedbyname", "author"},
      {"approvername", "approved_by"},
      {"supervisorname", "approved_by"},
      {"ownername", "company"},
      {"companyname", "company"},
  };
  return names;
}

std::string field_named(const std::string& name) {
  std::string letters;
  for (const char c : lowered(name)) {
    if (c != '_' && c != '-' && c != ' ') letters += c;
  }
  for (const TitleBlockField& field : title_block_fields()) {
    std::string known = field.name;
    std::erase(known, '_');
    if (known == letters) return field.name;
  }
  const auto other = other_names().find(letters);
  return other == other_names().end() ? name : other->second;
}

bool is_field(const std::string& name) {
  return std::ranges::any_of(title_block_fields(),
                             [&](const TitleBlockField& field) { return field.name == name; });
}

std::string collapsed(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  while (out.ends_with(' ')) out.pop_back();
  return out;
}

std::string letters_of(const pugi::xml_node& node) {
  std::string out = node.value();
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_comment) out += letters_of(child);
  }
  return out;
}

/// The value of a property that elements have as an attribute or in `style`, or have from those
/// about them; empty where nobody says it.
std::string property(pugi::xml_node node, std::string_view name) {
  for (; node && node.type() == pugi::node_element; node = node.parent()) {
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
      const std::size_t end = std::min(style.find(';'), style.size()), colon = style.find(':');
      if (colon < end && collapsed(style.substr(0, colon)) == name) {
        return collapsed(style.substr(colon + 1, end - colon - 1));
      }
      style.remove_prefix(std::min(end + 1, style.size()));
    }
    const pugi::xml_attribute own = node.attribute(std::string(name).c_str());
    if (own) return collapsed(own.value());
  }
  return {};
}

/// The number that a length begins with, and the unit behind it.
std::pair<std::optional<double>, std::string> length(const std::string& text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || !std::isfinite(value)) return {std::nullopt, {}};
  return {value, std::string(read.ptr, text.data() + text.size())};
}

class TemplateReader {
 public:
  explicit TemplateReader(const std::filesystem::path& path) : file_(path) {}

  TitleBlockLayout run() {
    const SvgTransform on_paper = placed();
    file_.walk(on_paper, [&](const pugi::xml_node& node, const SvgTransform& transform) {
      if (is_hidden(node)) return;
      if (SvgFile::local_name(node) == "text") {
        take_text(node, transform);
      } else {
        take_lines(node, transform);
      }
    });
    if (block_.paths.empty() && block_.texts.empty()) {
      throw InputError("the template has neither lines nor texts", file_.name());
    }
    for (TitleBlockText& text : block_.texts) text.width = room_of(text.text);
    find_kept_clear(on_paper);
    return std::move(block_);
  }

 private:
  /// Paper mm; a bare number is in pixels, of which an inch has 96.
  std::optional<double> side(const char* name) const {
    static const std::map<std::string, double, std::less<>> units{
        {"mm", 1}, {"cm", 10}, {"in", 25.4}, {"pt", 25.4 / 72}, {"px", 25.4 / 96}, {"", 25.4 / 96}};
    const pugi::xml_attribute given = file_.root().attribute(name);
    if (!given) return std::nullopt;
    const auto [number, unit] = length(given.value());
    const auto known = units.find(unit);
    if (!number || known == units.end()) return std::nullopt;
    return *number * known->second;
  }

  /// From the file's units to paper mm, y up.
  SvgTransform placed() {
    const pugi::xml_node root = file_.root();
    std::vector<double> box = file_.numbers(root, root.attribute("viewBox").value());
    const auto width = side("width"), height = side("height");
    const bool has_box = box.size() == 4 && box[2] > 0 && box[3] > 0;
    if (!has_box && !(width && height)) {
      file_.fail(root, "the template states no size: give it width and height in mm");
    }
    constexpr double kPixels = 25.4 / 96;
    if (!has_box) box = {0, 0, *width / kPixels, *height / kPixels};
    block_.size = {width.value_or(box[2]), height.value_or(box[3])};
    if (!(block_.size.x > 0 && block_.size.y > 0)) file_.fail(root, "the template has no size");
    const double x = block_.size.x / box[2], y = block_.size.y / box[3];
    return {x, 0, 0, -y, -x * box[0], block_.size.y + y * box[1]};
  }

  static bool is_hidden(const pugi::xml_node& node) {
    if (property(node, "visibility") == "hidden") return true;
    for (pugi::xml_node n = node; n; n = n.parent()) {
      const std::string style = n.attribute("style").value();
      if (style.find("display:none") != std::string::npos) return true;
    }
    return false;
  }

  void take_lines(const pugi::xml_node& node, const SvgTransform& transform) {
    const std::string stroke = property(node, "stroke"), fill = lowered(property(node, "fill"));
    const bool stroked = !stroke.empty() && stroke != "none";
    const bool white = fill == "#ffffff" || fill == "#fff" || fill == "white";
    if (!stroked && (fill == "none" || white)) return;
    const double size = std::sqrt(std::abs(transform.a * transform.d - transform.b * transform.c));
    const double given = length(property(node, "stroke-width")).first.value_or(1);
    const double width = stroked ? std::max(size * given, kLeastLine) : kOutline;
    for (const Subpath& sub : file_.lines(node, transform)) {
      Path path;
      path.kind = LineClass::Frame;
      path.points = flattened(sub, kChords);
      path.closed = sub.closed;
      path.width = {width};
      if (path.points.size() > 1) block_.paths.push_back(std::move(path));
    }
  }

  /// A text, or each line of one.
  void take_text(const pugi::xml_node& node, const SvgTransform& transform) {
    std::string field;
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (name == "editable" || name.ends_with(":editable")) field = field_named(attribute.value());
    }
    if (field.empty() && is_field(node.attribute("id").value())) {
      field = node.attribute("id").value();
    }
    const bool lines = std::ranges::any_of(
        node.children(), [](const pugi::xml_node& part) { return !part.attribute("y").empty(); });
    if (!lines || !field.empty()) return add_text(node, field, transform);
    for (const pugi::xml_node& part : node.children()) add_text(part, "", transform);
  }

  /// The element that has the first letters, or would have them: what it says of them holds.
  static pugi::xml_node innermost(pugi::xml_node node) {
    for (;;) {
      const pugi::xml_node inner = node.find_child(
          [](const pugi::xml_node& child) { return child.type() == pugi::node_element; });
      if (!inner) return node.type() == pugi::node_element ? node : node.parent();
      node = inner;
    }
  }

  void add_text(const pugi::xml_node& node, const std::string& field, const SvgTransform& t) {
    const std::string letters = collapsed(letters_of(node));
    if (letters.empty() && field.empty()) return;
    if (std::abs(t.b) > kLevel * std::abs(t.a) || t.a <= 0) {
      ++block_.left_out;
      return;
    }
    const pugi::xml_node styled = innermost(node);
    const auto place = [&](const char* name) {
      for (pugi::xml_node n = styled; SvgFile::local_name(n) != "g" && n != file_.root();
           n = n.parent()) {
        const std::vector<double> all = file_.numbers(n, n.attribute(name).value());
        if (!all.empty()) return all.front();
      }
      return 0.0;
    };
    constexpr double kUsual = 16;  // pixels, of CSS
    const std::string anchor = property(styled, "text-anchor");
    TitleBlockText out;
    out.field = field;
    out.text.text = letters;
    out.text.role = "title_block";
    out.text.at = t({place("x"), place("y")});
    const double size = length(property(styled, "font-size")).first.value_or(kUsual);
    out.text.height = size * std::abs(t.d) / font_size(1);
    if (anchor == "middle") out.text.anchor = TextAnchor::Middle;
    if (anchor == "end") out.text.anchor = TextAnchor::End;
    block_.texts.push_back(std::move(out));
  }

  /// How wide a line at that place may be until it meets a line of the template.
  double room_of(const Text& text) const {
    const double y = text.at.y + 0.5 * text.height;
    double left = 0, right = block_.size.x;
    for (const Path& path : block_.paths) {
      const std::size_t n = path.points.size();
      for (std::size_t i = path.closed ? 0 : 1; i < n; ++i) {
        const Vec2 p = path.points[(i + n - 1) % n], q = path.points[i];
        // Outlines of letters are no lines of a cell.
        if ((p.y > y) == (q.y > y) || std::abs(p.y - q.y) < text.height) continue;
        const double x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
        if (x > text.at.x) right = std::min(right, x);
        if (x <= text.at.x) left = std::max(left, x);
      }
    }
    const double before = text.at.x - left - kBesideLines, after = right - text.at.x - kBesideLines;
    const double room = text.anchor == TextAnchor::Start ? after
                        : text.anchor == TextAnchor::End ? before
                                                         : 2 * std::min(before, after);
    return std::max(room, text.height);
  }

  /// "<!-- Title block 220 227 410 287 -->" says where the block of a whole sheet is, as TechDraw's
  /// templates have it. Others have it about their fields, if these are in the lower half.
  void find_kept_clear(const SvgTransform& on_paper) {
    constexpr std::string_view kSays = "Title block ";
    for (const pugi::xml_node& node : file_.root().children()) {
      const std::string said = collapsed(node.value());
      const std::size_t at = said.find(kSays);
      if (node.type() != pugi::node_comment || at == std::string::npos) continue;
      const std::vector<double> n =
          file_.numbers(node, std::string_view(said).substr(at + kSays.size()));
      if (n.size() != 4) continue;
      Box2 box;
      box.add(on_paper({n[0], n[1]}));
      box.add(on_paper({n[2], n[3]}));
      block_.kept_clear = box;
      return;
    }
    Box2 fields;
    for (const TitleBlockText& text : block_.texts) {
      if (!text.field.empty()) fields.add(text.text.at);
    }
    if (fields.empty() || fields.max.y > 0.5 * block_.size.y) return;
    constexpr double kAbout = 8;  // paper mm: a row with its label
    block_.kept_clear = Box2{fields.min - kAbout, {block_.size.x, fields.max.y + kAbout}};
  }

  SvgFile file_;
  TitleBlockLayout block_;
};

}  // namespace

TitleBlockLayout read_title_block(const std::filesystem::path& path) {
  return TemplateReader(path).run();
}

}  // namespace burin
