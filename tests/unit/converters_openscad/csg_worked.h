#pragma once
// Trees of solids, worked out by exact cuts, and what is measured on them.

#include <burin/base/run_context.h>

#include "evaluate.h"
#include "flat_trees.h"

#include <string>
#include <vector>

namespace burin::csg::test {

struct Worked {
  Solid solid;
  Diagnostics diagnostics;
  /// Groups of solids that touch which were cut.
  std::size_t cuts = 0;
  bool reported(const std::string& code) const;
};

/// The text's top, or one of its nodes.
Worked work_out(const std::string& text, std::uint32_t node = 0,
                const std::filesystem::path& folder = ".");

/// Edges that do not run as often one way as the other.
std::size_t open_edges(const Solid& solid);
/// Edges that more than two triangles share.
std::size_t shared_edges(const Solid& solid);

/// Words of trees.
std::string cube(double x, double y, double z);
std::string cylinder(double h, double r1, double r2, int fn);
std::string sphere(double r, int fn);
std::string moved(double x, double y, double z, const std::string& what);
/// About z, to the last digit of doubles.
std::string turned(double degrees, const std::string& what);
std::string scaled(double x, double y, double z, const std::string& what);

/// Area of a regular polygon.
double polygon_area(double r, int n);
/// Volume of OpenSCAD's sphere: a stack of frusta of polygons.
double sphere_volume(double r, int n);

}  // namespace burin::csg::test
