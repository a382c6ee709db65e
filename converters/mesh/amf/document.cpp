#include "document.h"

#include "../xml.h"
#include "package.h"
#include "text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

namespace burin::amf {
namespace {

using xml::attribute;
using xml::child;
using xml::is;

std::string unpacked(const Source& source) {
  if (!source.bytes().starts_with("PK")) return std::string(source.bytes());
  const Package package(source, "zipped AMF file");
  const std::vector<std::string> names = package.names();
  for (const std::string& name : names) {
    if (lowered(name).ends_with(".amf")) return package.read(name);
  }
  if (names.size() != 1) source.fail("is an archive without an AMF file in it");
  return package.read(names[0]);
}

/// Texts of elements "metadata", by their types.
std::string metadata(const pugi::xml_node& node, std::string_view type) {
  for (const pugi::xml_node& m : node) {
    if (is(m, "metadata") && attribute(m, "type") == type) return m.text().get();
  }
  return {};
}

class Parser {
 public:
  explicit Parser(const Source& source) : source_(source), text_(unpacked(source)) {
    const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size());
    if (!result) {
      fail(result.offset,
           fmt::format("is no readable AMF ({}); export it again", result.description()));
    }
  }
  Document document();

 private:
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const;
  double unit(const pugi::xml_node& root) const;
  std::optional<double> number(const pugi::xml_node& node) const;
  double coordinate(const pugi::xml_node& node) const;
  std::optional<Rgba> color(const pugi::xml_node& of) const;
  Object object(const pugi::xml_node& node) const;
  void mesh(const pugi::xml_node& node, Object& out) const;
  Volume volume(const pugi::xml_node& node, const std::vector<Vec3>& points) const;
  Instance instance(const pugi::xml_node& node) const;

  const Source& source_;
  std::string text_;
  pugi::xml_document document_;
  std::map<std::string, Rgba, std::less<>> materials_;
};

void Parser::fail(std::ptrdiff_t offset, const std::string& what) const {
  const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
  source_.fail(fmt::format("line {}: {}", 1 + std::count(text_.begin(), end, '\n'), what));
}

double Parser::unit(const pugi::xml_node& root) const {
  static const std::map<std::string, double> units = {
      {"", 1},        {"millimeter", 1}, {"mm", 1},       {"micron", 0.001}, {"micrometer", 0.001},
      {"inch", 25.4}, {"feet", 304.8},   {"foot", 304.8}, {"meter", 1000}};
  const std::string name = lowered(std::string(attribute(root, "unit")));
  const auto found = units.find(name);
  if (found == units.end()) fail(root.offset_debug(), in_quotes(name) + " is no unit of AMF");
  return found->second;
}

std::optional<double> Parser::number(const pugi::xml_node& node) const {
  const std::string_view text = node.text().get();
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  double value = 0;
  if (begin == text.npos || !parse_double(text.substr(begin, end - begin + 1), value) ||
      !(std::abs(value) < 1e60)) {
    return std::nullopt;
  }
  return value;
}

double Parser::coordinate(const pugi::xml_node& node) const {
  if (const std::optional<double> value = number(node)) return *value;
  fail(node.offset_debug(),
       fmt::format("has {} where a number belongs", in_quotes(node.text().get())));
}

/// Formulas of the place, which AMF allows, are no colour.
std::optional<Rgba> Parser::color(const pugi::xml_node& of) const {
  const pugi::xml_node node = child(of, "color");
  if (!node) return std::nullopt;
  Rgba out{0, 0, 0, 255};
  constexpr std::array<const char*, 4> kChannels{"r", "g", "b", "a"};
  for (std::size_t i = 0; i < 4; ++i) {
    const pugi::xml_node channel_of = child(node, kChannels[i]);
    if (!channel_of && i == 3) continue;
    const std::optional<double> share = number(channel_of);
    if (!share) return std::nullopt;
    out[i] = channel(*share);
  }
  return out;
}

Volume Parser::volume(const pugi::xml_node& node, const std::vector<Vec3>& points) const {
  Volume out;
  out.name = metadata(node, "name");
  out.support = attribute(node, "type") == "support";
  out.modifier = metadata(node, "slic3r.modifier") == "1";
  std::optional<Rgba> of_volume = color(node);
  if (const auto material = materials_.find(attribute(node, "materialid"));
      !of_volume && material != materials_.end()) {
    of_volume = material->second;
  }
  std::unordered_map<std::size_t, std::uint32_t> taken;
  for (const pugi::xml_node& t : node) {
    if (!is(t, "triangle")) continue;
    source_.context().check();
    for (const char* corner : {"v1", "v2", "v3"}) {
      const double index = coordinate(child(t, corner));
      if (!(index >= 0 && index < static_cast<double>(points.size()))) {
        fail(t.offset_debug(),
             fmt::format("has a triangle with the vertex {:g} of {}", index, points.size()));
      }
      // Volumes share the points of their object; each takes those it uses.
      const auto [own, is_new] = taken.try_emplace(
          static_cast<std::size_t>(index), static_cast<std::uint32_t>(out.mesh.positions.size()));
      if (is_new) out.mesh.positions.push_back(points[own->first]);
      out.mesh.indices.push_back(own->second);
    }
    out.mesh.offsets.push_back(out.mesh.indices.size());
    const std::optional<Rgba> own = color(t);
    out.look.add(own ? own : of_volume);
  }
  return out;
}

void Parser::mesh(const pugi::xml_node& node, Object& out) const {
  std::vector<Vec3> points;
  for (const pugi::xml_node& v : child(node, "vertices")) {
    if (!is(v, "vertex")) continue;
    source_.context().check();
    const pugi::xml_node at = child(v, "coordinates");
    points.emplace_back(coordinate(child(at, "x")), coordinate(child(at, "y")),
                        coordinate(child(at, "z")));
  }
  for (const pugi::xml_node& v : node) {
    if (is(v, "volume")) out.volumes.push_back(volume(v, points));
  }
}

Object Parser::object(const pugi::xml_node& node) const {
  Object out{std::string(attribute(node, "id")), metadata(node, "name"), {}};
  for (const pugi::xml_node& m : node) {
    if (is(m, "mesh")) mesh(m, out);
  }
  const std::optional<Rgba> whole = color(node);
  for (Volume& volume : out.volumes) {
    if (volume.look.any() || !whole) continue;
    volume.look = {};
    volume.look.add(whole);
  }
  return out;
}

/// Scaled and mirrored as slicers add it, turned about x, then y, then z, then moved.
Instance Parser::instance(const pugi::xml_node& node) const {
  const auto value = [&](const char* name, double absent) {
    const pugi::xml_node found = child(node, name);
    return found ? coordinate(found) : absent;
  };
  Instance out{std::string(attribute(node, "objectid")), {}};
  constexpr std::array<std::array<const char*, 4>, 3> kAxes{{
      {"deltax", "rx", "scalex", "mirrorx"},
      {"deltay", "ry", "scaley", "mirrory"},
      {"deltaz", "rz", "scalez", "mirrorz"},
  }};
  const double scale = value("scale", 1);
  for (int i = 0; i < 3; ++i) {
    const auto& [delta, turn, factor, mirror] = kAxes[static_cast<std::size_t>(i)];
    out.place.linear[i] *= scale * value(factor, 1) * (value(mirror, 0) == 1 ? -1 : 1);
    out.place.offset[i] = value(delta, 0);
  }
  for (int i = 0; i < 3; ++i) {
    const double angle = value(kAxes[static_cast<std::size_t>(i)][1], 0) * std::numbers::pi / 180;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Mat3 turn(1);
    turn[j][j] = turn[k][k] = std::cos(angle);
    turn[j][k] = std::sin(angle);
    turn[k][j] = -std::sin(angle);
    out.place.linear = turn * out.place.linear;
  }
  return out;
}

Document Parser::document() {
  const pugi::xml_node root = child(document_, "amf");
  if (!root) source_.fail("is XML, but no AMF; export it again");
  Document out;
  out.unit = unit(root);
  for (const pugi::xml_node& m : root) {
    if (!is(m, "material")) continue;
    if (const auto rgba = color(m)) materials_.emplace(attribute(m, "id"), *rgba);
  }
  for (const pugi::xml_node& node : root) {
    if (is(node, "object")) out.objects.push_back(object(node));
    if (!is(node, "constellation")) continue;
    Constellation& set = out.constellations.emplace_back();
    set.id = attribute(node, "id");
    set.name = metadata(node, "name");
    for (const pugi::xml_node& i : node) {
      if (is(i, "instance")) set.instances.push_back(instance(i));
    }
  }
  return out;
}

}  // namespace

Document parse(const Source& source) { return Parser(source).document(); }

}  // namespace burin::amf
