#pragma once
/// One model part of a 3MF archive as it stands.

#include <burin/base/vec.h>
#include <burin/mesh/tri_mesh.h>

#include "source.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace burin {

/// p' = p * linear + shift, p a row as in 3MF: the three rows of `linear`, then the shift.
struct ThreeMfTransform {
  std::array<Vec3, 4> rows{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0)};
  Vec3 apply(const Vec3& p) const {
    return p.x * rows[0] + p.y * rows[1] + p.z * rows[2] + rows[3];
  }
  bool mirrors() const { return glm::dot(rows[0], glm::cross(rows[1], rows[2])) < 0; }
  /// First this one, then `outer`.
  ThreeMfTransform then(const ThreeMfTransform& outer) const;
};

/// Another object put somewhere: a component of an object or an item of the build.
struct ThreeMfUse {
  std::string object;
  std::string path;  // the model part that holds it; empty = the same one
  ThreeMfTransform transform;
};

struct ThreeMfObject {
  std::string name;
  PolygonSoup mesh;  // of triangles, in the unit of the model
  std::vector<ThreeMfUse> components;
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
