#pragma once
/// What `burin info` tells about a mesh file.

#include <burin/base/box.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// One part after repair.
struct PartInfo {
  std::string name;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  /// Smooth regions: connected triangles with no crease of more than 30 degrees between them.
  std::int64_t faces = 0;
  std::int64_t components = 0;
  std::int64_t boundary_edges = 0;
  /// Pairs of triangles that cross or overlap other than at shared corners and edges.
  std::int64_t self_intersections = 0;
  /// Square and cubic millimetres; the volume is 0 where the part is open.
  double area = 0;
  double volume = 0;
  Box3 bounds;
  bool closed() const { return boundary_edges == 0; }
};

struct MeshInfo {
  std::string file;
  std::string format;
  std::vector<PartInfo> parts;
  /// Defects that were found, and what was done about them.
  Diagnostics diagnostics;

  /// The parts added up; their bounds together.
  PartInfo total() const;
};

/// Reads, repairs and measures. Throws InputError as `read_mesh_file` does. Cost: about
/// 2 s of processor time a million triangles.
MeshInfo inspect_mesh(const std::filesystem::path& path, const RunContext& context);

/// A few lines for a reader.
std::string to_text(const MeshInfo& info);
/// {"format": "burin-info", "version": 1, "files": [...]}, numbers in full precision.
std::string to_json(std::span<const MeshInfo> files);

}  // namespace burin
