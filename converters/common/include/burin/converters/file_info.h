#pragma once
/// What `burin info` prints about a file, whatever its format.

#include <burin/base/box.h>
#include <burin/base/diagnostics.h>
#include <burin/base/vec.h>
#include <burin/surface/pmi.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// One part. What a format does not know is absent.
struct PartInfo {
  std::string name;
  /// Names from the top of the assembly down to what contains the part.
  std::vector<std::string> assembly = {};
  /// "#rrggbb" or empty.
  std::string color = {};
  /// How many colours its faces have.
  std::int64_t colors = 0;
  /// As that of Part.
  double opacity = 1;
  /// The first part that shares this one's shape, -1 where the shape is its own.
  std::int32_t same_shape_as = -1;

  /// Meshes: after repair.
  std::optional<std::int64_t> vertices = {}, triangles = {};
  /// CAD files: solids, and shells in solids or without one.
  std::optional<std::int64_t> solids = {}, shells = {};
  /// Meshes: smooth regions, connected triangles with no crease of more than 30 degrees between
  /// them. Else faces or patches as they stand in the file.
  std::int64_t faces = 0;
  /// CAD files: edges, each once.
  std::optional<std::int64_t> edges = {};
  std::optional<std::int64_t> components = {};
  /// Edges with a face on one side only.
  std::int64_t boundary_edges = 0;
  /// Meshes: pairs of triangles that cross or overlap other than at shared corners and edges.
  std::optional<std::int64_t> self_intersections = {};
  /// Square and cubic millimetres; the volume is 0 where the part is open.
  double area = 0;
  double volume = 0;
  Box3 bounds = {};
  /// Its dimensions, tolerances, datums and notes; shared by parts of one shape.
  std::shared_ptr<const Pmi> pmi = {};
  bool closed() const { return boundary_edges == 0; }
};

/// Samples on a grid.
struct VolumeInfo {
  static constexpr std::array<double, 5> kPercents{1, 25, 50, 75, 99};

  std::array<std::int64_t, 3> size{};
  /// As they are stored: u8, i16, f32 ...; whether all values are whole numbers for sure.
  std::string type;
  bool whole = true;
  /// Model mm of the first sample, and from sample to sample along each axis of the grid.
  Vec3 origin{0};
  Mat3 steps{1};
  /// What the coordinates are, where the file says it: "right-anterior-superior".
  std::string space;
  /// Of all samples.
  Box3 bounds;
  double min = 0, max = 0;
  /// Values below which kPercents of the samples lie.
  std::array<double, 5> percentiles{};
  /// A level to try: the one that best divides the values into two groups.
  double level = 0;
};

struct FileInfo {
  std::string file;
  std::string format;
  /// STEP: the name of the schema; else empty.
  std::string schema = {};
  std::vector<PartInfo> parts = {};
  /// Volumes only; without a level they have no parts.
  std::optional<VolumeInfo> volume = {};
  /// Defects that were found, and what was done about them.
  Diagnostics diagnostics = {};

  /// The parts added up; their bounds together.
  PartInfo total() const;
};

/// A few lines for a reader.
std::string to_text(const FileInfo& info);
/// {"items": [...], "views": [...]}: the kind, the text and the numbers of each, without its lines.
std::string to_json(const Pmi& pmi);
/// {"format": "burin-info", "version": 1, "files": [...]}, numbers in full precision.
std::string to_json(std::span<const FileInfo> files);

}  // namespace burin
