#pragma once
// XML of FreeCAD's; internal to the module. Numbers are converted free of the locale.

#include <burin/forms/charted/chart.h>

#include "source.h"

#include <pugixml.hpp>

#include <array>
#include <string>
#include <string_view>

namespace burin::detail {

/// One document. Throws InputError that names the member and the line.
class Xml {
 public:
  Xml(std::string text, const char* member, const Source& source);
  /// Throws InputError where the outermost element is another.
  pugi::xml_node root(const char* name) const;

 private:
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const;

  std::string text_;
  const char* member_;
  const Source& source_;
  pugi::xml_document document_;
};

pugi::xml_node first_element(const pugi::xml_node& node);
/// The attribute "value".
std::string text_of(const pugi::xml_node& node);
bool truth(const pugi::xml_node& node);
/// `fallback` where the attribute is absent or no finite number.
double number(const pugi::xml_node& node, const char* attribute, double fallback);
/// `quaternion` is x, y, z, w of any length; 0 is no rotation.
Placement make_placement(Vec3 offset, std::array<double, 4> quaternion);
Placement placement(const pugi::xml_node& node);

}  // namespace burin::detail
