#pragma once
/// What the models are built with, on OCCT's modelling.

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace burin::samples {

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high);
/// From `base` along `axis`.
TopoDS_Shape cylinder(const gp_Pnt& base, const gp_Dir& axis, double radius, double height);
/// A plane polygon swept by a vector.
TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, const gp_Vec& sweep);
/// A closed profile of (radius, z), turned about the z axis.
TopoDS_Shape turned(const std::vector<std::pair<double, double>>& profile);

TopoDS_Shape fuse(const std::vector<TopoDS_Shape>& shapes);
TopoDS_Shape cut(const TopoDS_Shape& from, const std::vector<TopoDS_Shape>& tools);
/// `n` copies of the shape, turned about the z axis.
std::vector<TopoDS_Shape> round_about(const TopoDS_Shape& shape, int n, double first_angle = 0);

/// An edge as the choice of edges to be rounded sees it.
struct EdgeView {
  gp_Pnt middle;
  gp_Dir direction;
  bool line = false;
  /// Material on less than half of all sides.
  bool convex = false;
  bool smooth = false;
};
/// Rounds the edges that `choose` takes; throws where OCCT cannot.
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius,
                     const std::function<bool(const EdgeView&)>& choose);
TopoDS_Shape chamfered(const TopoDS_Shape& shape, double size,
                       const std::function<bool(const EdgeView&)>& choose);

}  // namespace burin::samples
