#include "model.h"

#include "../texture.h"
#include "../xml.h"
#include "properties.h"
#include "text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

// pugixml keeps no table of entities and reads no external ones, so that none of their tricks
// works; attributes are converted here, as its own conversion follows the locale. lib3mf in Debian
// 12 is an old 1.8 that loads into structures of its own first.
namespace burin {
namespace {

using xml::attribute;
using xml::child;
using xml::is;

/// Which group of properties, and which of it, where triangles say nothing of their own.
struct Materials {
  std::string_view group, index;
};

class ModelParser {
 public:
  ModelParser(std::string text, const std::string& name, const Source& source);
  ThreeMfModel model();

 private:
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const {
    fail(node.offset_debug(), what);
  }
  double unit(const pugi::xml_node& model) const;
  double number(const pugi::xml_node& node, const char* name) const;
  std::uint32_t index(const pugi::xml_node& node, const char* name, std::size_t count) const;
  Placement transform(const pugi::xml_node& node) const;
  ThreeMfUse use(const pugi::xml_node& node) const;
  void mesh(const pugi::xml_node& node, const Materials& of_object, ThreeMfObject& out) const;
  void properties(const pugi::xml_node& triangle, const Materials& of_object,
                  ThreeMfObject& out) const;
  ThreeMfObject object(const pugi::xml_node& node) const;

  std::string text_;
  const std::string& name_;
  const Source& source_;
  pugi::xml_document document_;
  std::optional<ThreeMfProperties> properties_;
};

ModelParser::ModelParser(std::string text, const std::string& name, const Source& source)
    : text_(std::move(text)), name_(name), source_(source) {
  // 3MF allows no document type: nothing but tricks with entities needs one.
  const std::size_t doctype = std::string_view(text_).substr(0, 4096).find("<!DOCTYPE");
  if (doctype != std::string_view::npos) {
    fail(static_cast<std::ptrdiff_t>(doctype),
         "a document type is not allowed in 3MF; export it again");
  }
  const pugi::xml_parse_result result = document_.load_buffer_inplace(
      text_.data(), text_.size(), pugi::parse_escapes | pugi::parse_wconv_attribute);
  if (!result)
    fail(result.offset, fmt::format("bad XML ({}); export it again", result.description()));
}

void ModelParser::fail(std::ptrdiff_t offset, const std::string& what) const {
  const std::size_t end =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
  const auto line =
      1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t slash = name_.starts_with('/') ? 1 : 0;
  source_.fail(fmt::format("in {}, line {}: {}", name_.substr(slash), line, what));
}

double ModelParser::unit(const pugi::xml_node& model) const {
  static const std::map<std::string_view, double> units = {
      {"", 1},        {"millimeter", 1}, {"micron", 0.001}, {"centimeter", 10},
      {"inch", 25.4}, {"foot", 304.8},   {"meter", 1000}};
  const std::string_view name = attribute(model, "unit");
  const auto found = units.find(name);
  if (found == units.end()) fail(model, in_quotes(name) + " is no unit of 3MF");
  return found->second;
}

double ModelParser::number(const pugi::xml_node& node, const char* name) const {
  const char* text = node.attribute(name).value();
  double value = 0;
  if (parse_double(text, value)) return value;
  while (is_blank(*text)) ++text;  // some writers pad
  const std::string_view padded(text);
  if (parse_double(padded.substr(0, padded.find_last_not_of(" \t") + 1), value)) return value;
  fail(node, fmt::format("{} is no number for {}; export it again", in_quotes(text), name));
}

std::uint32_t ModelParser::index(const pugi::xml_node& node, const char* name,
                                 std::size_t count) const {
  const std::string_view text = node.attribute(name).value();
  std::uint32_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value >= count) {
    fail(node, fmt::format("a triangle refers to vertex {}, its mesh has {}; export it again",
                           in_quotes(text), count));
  }
  return value;
}

Placement ModelParser::transform(const pugi::xml_node& node) const {
  Placement out;  // 3MF multiplies rows from the left: each three numbers are a column of ours
  const std::string_view text = attribute(node, "transform");
  if (text.empty()) return out;
  const char *p = text.data(), *end = p + text.size();
  int count = 0;
  for (;; ++count) {
    while (p < end && (is_blank(*p) || is_line_end(*p))) ++p;
    if (p == end) break;
    double value = 0;
    p = scan_double(p, end, value);
    if (p == nullptr || count == 12 || !(std::abs(value) < 1e60)) break;
    (count < 9 ? out.linear[count / 3] : out.offset)[count % 3] = value;
  }
  if (p != end || count != 12) {
    fail(node,
         fmt::format("{} is no transform, which has 12 numbers; export it again", in_quotes(text)));
  }
  return out;
}

ThreeMfUse ModelParser::use(const pugi::xml_node& node) const {
  return {std::string(attribute(node, "objectid")), std::string(attribute(node, "path")),
          transform(node)};
}

void ModelParser::properties(const pugi::xml_node& triangle, const Materials& of_object,
                             ThreeMfObject& out) const {
  const std::string_view pid = attribute(triangle, "pid"), p1 = attribute(triangle, "p1");
  const std::string_view group = pid.empty() ? of_object.group : pid;
  std::array<std::optional<Rgba>, 3> colors;
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr std::array<const char*, 3> kCorners{"p1", "p2", "p3"};
    std::string_view at = attribute(triangle, kCorners[i]);
    if (at.empty()) at = p1.empty() ? of_object.index : p1;
    if (properties_->has_texture()) out.mesh.texture.push_back(properties_->texture(group, at));
    colors[i] = properties_->color(group, at);
  }
  if (!properties_->has_colors()) return;
  out.colors.push_back(color_of_corners(colors));
}

void ModelParser::mesh(const pugi::xml_node& node, const Materials& of_object,
                       ThreeMfObject& out) const {
  PolygonSoup& soup = out.mesh;
  const std::size_t first = soup.positions.size();
  for (const pugi::xml_node& v : child(node, "vertices")) {
    if (!is(v, "vertex")) continue;
    source_.context().check();
    soup.positions.emplace_back(number(v, "x"), number(v, "y"), number(v, "z"));
  }
  const bool plain = !properties_->has_texture() && !properties_->has_colors();
  for (const pugi::xml_node& t : child(node, "triangles")) {
    if (!is(t, "triangle")) continue;
    source_.context().check();
    for (const char* corner : {"v1", "v2", "v3"}) {
      soup.indices.push_back(static_cast<std::uint32_t>(first) +
                             index(t, corner, soup.positions.size() - first));
    }
    soup.offsets.push_back(soup.indices.size());
    if (!plain) properties(t, of_object, out);
  }
}

ThreeMfObject ModelParser::object(const pugi::xml_node& node) const {
  ThreeMfObject out;
  out.name = attribute(node, "name");
  if (out.name.empty()) out.name = attribute(node, "partnumber");
  out.type = attribute(node, "type");
  // One is allowed; programs that write several mean all of them.
  for (const pugi::xml_node& m : node) {
    if (!is(m, "mesh")) continue;
    mesh(m, {attribute(node, "pid"), attribute(node, "pindex")}, out);
    out.has_beams |= !child(m, "beamlattice").empty();
  }
  for (const pugi::xml_node& c : child(node, "components")) {
    if (is(c, "component")) out.components.push_back(use(c));
  }
  return out;
}

ThreeMfModel ModelParser::model() {
  const pugi::xml_node root = child(document_, "model");
  if (!root) fail(0, "the XML has no element 'model'; export it again");
  ThreeMfModel out;
  out.unit = unit(root);
  properties_.emplace(child(root, "resources"));
  for (const pugi::xml_node& o : child(root, "resources")) {
    if (!is(o, "object")) continue;
    const std::string id(attribute(o, "id"));
    if (!out.objects.try_emplace(id, object(o)).second) {
      fail(o, fmt::format("two objects have the id {}; export it again", in_quotes(id)));
    }
    out.order.push_back(id);
  }
  for (const pugi::xml_node& i : child(root, "build")) {
    if (!is(i, "item")) continue;
    out.build.push_back(use(i));
    const std::string printable(attribute(i, "printable"));
    out.build.back().printable = printable != "0" && printable != "false";
  }
  return out;
}

}  // namespace

ThreeMfModel parse_3mf_model(std::string text, const std::string& name, const Source& source) {
  return ModelParser(std::move(text), name, source).model();
}

std::string find_3mf_root(std::string relationships, const Source& source) {
  pugi::xml_document document;
  if (!document.load_buffer_inplace(relationships.data(), relationships.size())) {
    source.fail("the relationships of the 3MF archive are bad XML; export it again");
  }
  for (const pugi::xml_node& r : child(document, "Relationships")) {
    const std::string_view type = attribute(r, "Type");
    if (type.ends_with("/3dmodel")) return std::string(attribute(r, "Target"));
  }
  return {};
}

}  // namespace burin
