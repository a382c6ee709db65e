#include "xml.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// FreeCAD's own depth is below 20; pugixml reads deeper ones, but walks them by recursion nowhere.
constexpr unsigned kFlags = pugi::parse_escapes | pugi::parse_wconv_attribute;

}  // namespace

Xml::Xml(std::string text, const char* member, const Source& source)
    : text_(std::move(text)), member_(member), source_(source) {
  const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size(), kFlags);
  if (!result) {
    fail(result.offset, fmt::format("bad XML ({}); save the document again", result.description()));
  }
}

void Xml::fail(std::ptrdiff_t offset, const std::string& what) const {
  const auto end = text_.begin() +
                   std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
  source_.fail(
      fmt::format("{}, line {}: {}", member_, 1 + std::count(text_.begin(), end, '\n'), what));
}

pugi::xml_node Xml::root(const char* name) const {
  const pugi::xml_node node = document_.child(name);
  if (!node) fail(0, "is no document of FreeCAD's");
  return node;
}

pugi::xml_node first_element(const pugi::xml_node& node) {
  return node.find_child([](const pugi::xml_node& n) { return n.type() == pugi::node_element; });
}

std::string text_of(const pugi::xml_node& node) { return node.attribute("value").value(); }

bool truth(const pugi::xml_node& node) { return text_of(node) == "true"; }

double number(const pugi::xml_node& node, const char* attribute, double fallback) {
  double value = 0;
  if (!parse_double(node.attribute(attribute).value(), value)) return fallback;
  return std::isfinite(value) ? value : fallback;
}

Placement make_placement(Vec3 offset, std::array<double, 4> quaternion) {
  Placement placement;
  placement.offset = offset;
  double largest = 0;
  for (const double q : quaternion) largest = std::max(largest, std::abs(q));
  if (!(largest > 0)) return placement;
  double square = 0;
  for (double& q : quaternion) {
    q /= largest;
    square += q * q;
  }
  const double n = 1 / std::sqrt(square);
  const double x = n * quaternion[0], y = n * quaternion[1], z = n * quaternion[2],
               w = n * quaternion[3];
  placement.linear[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)};
  placement.linear[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)};
  placement.linear[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)};
  return placement;
}

Placement placement(const pugi::xml_node& node) {
  return make_placement(
      {number(node, "Px", 0), number(node, "Py", 0), number(node, "Pz", 0)},
      {number(node, "Q0", 0), number(node, "Q1", 0), number(node, "Q2", 0), number(node, "Q3", 1)});
}

}  // namespace burin::detail
