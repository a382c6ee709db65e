#pragma once
/// An AMF file (ISO/ASTM 52915) as it stands.

#include <burin/base/placement.h>
#include <burin/mesh/tri_mesh.h>

#include "look.h"
#include "source.h"

#include <cstddef>
#include <string>
#include <vector>

namespace burin::amf {

/// Triangles of an object that are of one material.
struct Volume {
  std::string name;
  PolygonSoup mesh;  // in the unit of the file
  FaceLooks look;
  /// Whether it supports the model while it is made, and whether it only changes other volumes.
  bool support = false, modifier = false;
};

struct Object {
  std::string id, name;
  std::vector<Volume> volumes;
};

/// An object, or another constellation, put somewhere.
struct Instance {
  std::string object;
  Placement place = {};  // in the unit of the file
};

struct Constellation {
  std::string id, name;
  std::vector<Instance> instances;
};

struct Document {
  /// Millimetres per unit.
  double unit = 1;
  std::vector<Object> objects;
  std::vector<Constellation> constellations;
};

/// Parses an AMF, plain or zipped. Throws InputError with the line.
Document parse(const Source& source);

}  // namespace burin::amf
