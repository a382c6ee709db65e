#pragma once
/// One model part of a 3MF archive as it stands.

#include <burin/base/placement.h>
#include <burin/mesh/tri_mesh.h>

#include "look.h"
#include "source.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Another object put somewhere: a component of an object or an item of the build.
struct ThreeMfUse {
  std::string object;
  std::string path = {};  // the model part that holds it; empty = the same one
  Placement place = {};   // in the unit of the model
  bool printable = true;  // of an item, as slicers write it
};

struct ThreeMfObject {
  std::string name;
  /// "model", "support" ...; empty: model.
  std::string type;
  PolygonSoup mesh;  // of triangles, in the unit of the model
  /// Of each triangle, that of most of its corners; empty where the model has no colours.
  std::vector<std::optional<Rgba>> colors;
  std::vector<ThreeMfUse> components;
  /// Whether there are beams, which have no triangles.
  bool has_beams = false;

  /// Whether it is part of what is made: not a support, nor what only helps to make it.
  bool is_model() const { return type.empty() || type == "model" || type == "surface"; }
};

struct ThreeMfModel {
  /// Millimetres per unit.
  double unit = 1;
  std::map<std::string, ThreeMfObject> objects;
  std::vector<std::string> order;  // the ids of the objects as they stand in the file
  std::vector<ThreeMfUse> build;
};

/// Parses the XML `text` of the member `name`. Throws InputError with the member's line.
ThreeMfModel parse_3mf_model(std::string text, const std::string& name, const Source& source);

/// The path of the main model part, by the relationships of the archive, or empty.
std::string find_3mf_root(std::string relationships, const Source& source);

}  // namespace burin
