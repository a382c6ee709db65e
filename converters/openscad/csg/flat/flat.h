#pragma once
// The 2-D nodes of a tree, and how they become solids; for converters/openscad alone.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>

#include "solid.h"
#include "tree.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace burin::csg {

class Fonts;

/// What all nodes of one evaluation share.
struct Evaluation {
  const Tree& tree;
  /// Where relative file names begin.
  std::filesystem::path folder;
  RunContext& run;
  /// What a user should know: text without glyphs, an import that is not there.
  Diagnostics diagnostics = {};
  /// Those of this machine, once a text asks for one.
  std::shared_ptr<Fonts> fonts = nullptr;
  /// What is under way and why it may take long, in a few words.
  std::string doing = {};
  /// How many groups of solids that touch were cut: what is alike counts once.
  std::size_t cuts = 0;
};

/// Whether a node is of two dimensions, by itself or (groups, hulls, ...) by its first child that
/// says so; for every node of the tree, in one pass. What OpenSCAD ignores with a warning (a 2-D
/// child among solids) is ignored here too and told in the diagnostics of the evaluation.
enum class Dimension : std::uint8_t { None, Flat, Solid };
std::vector<Dimension> dimensions(const Tree& tree);

/// square, circle, polygon, text, import of DXF and SVG.
Region leaf_region(Evaluation& e, std::uint32_t node);
/// Every 2-D node with 2-D children: union, group, difference, intersection, offset, hull,
/// minkowski, resize, multmatrix, color, render. `children` in order, those without area are empty.
Region combine_regions(Evaluation& e, std::uint32_t node, std::span<const Region> children);
/// linear_extrude and rotate_extrude.
Solid extruded(Evaluation& e, std::uint32_t node, const Region& region);
/// projection, cut or not.
Region projected(Evaluation& e, std::uint32_t node, const Solid& solid);
/// import of STL, OFF, 3MF, AMF, NEF3 and surface: the objects of the file, which OpenSCAD unites;
/// each closed where the file's faces close, and turned outwards.
std::vector<Solid> file_solids(Evaluation& e, std::uint32_t node);
/// The same beside each other in one, for files whose objects do not meet.
Solid file_solid(Evaluation& e, std::uint32_t node);

}  // namespace burin::csg
