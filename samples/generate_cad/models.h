#pragma once
/// The CAD samples, one function each. What each shows stands in samples/README.md.

#include <Quantity_Color.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

namespace burin::samples {

/// A pedestal bearing: foot, wall, ribs, barrel with stepped bore, oil boss; all edges rounded.
TopoDS_Shape pedestal();
/// A ship's propeller: lofted blades on a turned hub.
TopoDS_Shape propeller();

/// A member of an assembly: a part (index into `parts`) or a group, each used at places.
struct Member {
  std::string name;
  int part = -1;
  std::vector<Member> group;
  gp_Trsf place;
};
struct NamedPart {
  std::string name;
  Quantity_Color color;
  TopoDS_Shape shape;
};
struct Assembly {
  std::string name;
  std::vector<NamedPart> parts;
  std::vector<Member> members;
};

/// A flange coupling: two hubs, two shafts with keys, six bolts with nuts and washers.
Assembly coupling();
/// The same, later: holes in a hub, a key farther out, a set screw more, a set of bolts less.
Assembly revised_coupling();
/// A gear pump: body, gasket, cover, two shafts with gears and keys, dowels, six screws with
/// washers.
Assembly pump();

}  // namespace burin::samples
