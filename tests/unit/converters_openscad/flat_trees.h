#pragma once
// Trees of 2-D shapes and their extrusions, evaluated and measured; what openscad makes of the
// same.

#include <burin/base/run_context.h>

#include "flat/flat.h"

#include <burin_test/folder.h>
#include <burin_test/pictures.h>

#include <filesystem>
#include <optional>
#include <string>

namespace burin::csg::test {

/// A tree and what its evaluation said. Relative files begin at `folder`.
class Evaluated {
 public:
  explicit Evaluated(const std::string& text, const std::filesystem::path& folder = ".");

  /// What stands at the top, as 2-D or as solids beside each other.
  Region region();
  Solid solid();
  const Diagnostics& diagnostics() const { return e_.diagnostics; }
  bool reported(const std::string& code) const;
  bool is_flat() const;

 private:
  Region region_of(std::uint32_t node);
  Solid solid_of(std::uint32_t node);

  RunContext run_;
  Tree tree_;
  Evaluation e_;
  std::vector<Dimension> dimensions_;
};

double volume(const Solid& solid);
/// Empty where each edge has two triangles that run along it in opposite directions, each vertex
/// one fan of triangles, and no triangle two corners at one place; else what is wrong.
std::string flaw(const Solid& solid);
/// The largest distance of a corner of a tagged edge from its arc, mm.
double farthest_from_arcs(const Region& region);
std::size_t tagged_edges(const Region& region);
/// The same for the corners of tagged triangles and their turned surfaces.
double farthest_from_surfaces(const Solid& solid);
/// Triangles that stand for a turned surface.
std::size_t tagged_triangles(const Solid& solid);

using ::burin::test::Folder;
using ::burin::test::has_program;

/// The tree that openscad evaluates a program to; nothing where it fails. Relative names of files
/// are those of the program's folder.
std::optional<std::string> tree_of(const std::filesystem::path& program);
/// Volume of what openscad renders of a program or tree; 0 where that is nothing.
double openscad_volume(const std::filesystem::path& file);

}  // namespace burin::csg::test
