#pragma once
// Solids of parts, each evaluated once; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/placement.h>
#include <burin/base/run_context.h>

#include "child.h"
#include "parts.h"
#include "solid.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace burin::detail {

/// What two texts have in common that differ by how deep they stand in the tree: tabs at the
/// beginnings of lines say that alone, unless a text in quotes goes over several lines.
std::string key_of(const std::string& text);

/// How the text of a file's tree is evaluated.
csg::ChildOptions evaluation_of(const std::filesystem::path& path);

/// A part as one of the solids, placed.
struct StoredPart {
  std::size_t solid = 0;
  Placement place;
  /// By what the volume of the solid is larger here.
  double growth = 1;
};

/// How much solid something is: mm3, and surfaces that are closed in themselves.
struct Bulk {
  double volume = 0;
  std::size_t shells = 0;
};

class SolidStore {
 public:
  /// `path`: the file that the tree comes from, in whose folder other files are found. The tree has
  /// to live as long.
  SolidStore(const csg::Tree& tree, std::filesystem::path path, RunContext& context);

  /// The parts, by solids; those that are new are evaluated in a process of its own, all in one
  /// run. Throws as `evaluate_in_child`.
  std::vector<StoredPart> store(const std::vector<TreePart>& parts, Diagnostics& diagnostics);

  const csg::Solid& solid(const StoredPart& part) const { return solids_[part.solid]; }
  /// Of a part where it stands. Linear in its triangles the first time.
  Bulk bulk(const StoredPart& part);

 private:
  const csg::Tree& tree_;
  std::filesystem::path path_;
  RunContext& context_;
  std::unordered_map<std::string, std::size_t> known_;
  std::vector<csg::Solid> solids_;
  /// As far as they were asked for.
  std::unordered_map<std::size_t, Bulk> bulks_;
};

}  // namespace burin::detail
