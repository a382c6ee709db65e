#pragma once
// Parts with threads and their drawings.

/// Threads of a bolt and of a plate, as a drawing shows them.

#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/surface/placed_form.h>
#include <burin/threads/metric.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace burin::test {

inline const double kMinorM10 = minor_diameter(10, 1.5), kMinorM6 = minor_diameter(6, 1);

inline gp_Ax2 up_from(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

/// M10: a head from z = 0 to 6, a shaft down to z = -39, a chamfer of 1 mm to z = -40.
inline TopoDS_Shape bolt_shape() {
  const TopoDS_Shape head = BRepPrimAPI_MakeCylinder(up_from(0, 0, 0), 9, 6).Shape();
  const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(up_from(0, 0, -39), 5, 39).Shape();
  const TopoDS_Shape tip = BRepPrimAPI_MakeCone(up_from(0, 0, -40), 4, 5, 1).Shape();
  return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(head, shaft).Shape(), tip).Shape();
}

/// 60 x 40 x 20 with a drill of 5 mm all through at 15, 20 and one of 8.5 mm, 14 deep, at 42, 20.
inline TopoDS_Shape plate_shape() {
  const TopoDS_Shape plate = box_shape(60, 40, 20);
  const TopoDS_Shape through = BRepPrimAPI_MakeCylinder(up_from(15, 20, -5), 2.5, 30).Shape();
  const TopoDS_Shape blind = BRepPrimAPI_MakeCylinder(up_from(42, 20, 6), 4.25, 20).Shape();
  return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(plate, through).Shape(), blind).Shape();
}

inline Scene scene_of(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts) {
  Scene scene;
  for (const auto& [name, shape] : parts) {
    scene.parts.push_back({.name = name, .source = "", .form = brep_form(shape)});
  }
  return scene;
}

inline ThreadRow row(const std::string& select, const std::string& size) {
  ThreadRow out;
  out.select = {select};
  out.size = size;
  return out;
}

inline Illustration seen_from(Vec3 direction, Vec3 up, std::vector<ThreadRow> threads) {
  Illustration out;
  out.style = builtin_style("outline");
  out.view.direction = direction;
  out.view.up = up;
  out.view.scale = 2;
  out.thread_rows = std::move(threads);
  return out;
}

inline const Vec3 kY(0, 1, 0), kZ(0, 0, 1);

/// The paths of threads, of one kind, seen or hidden.
inline std::vector<Path> paths_of(const Drawing& drawing, LineClass kind, bool visible = true) {
  std::vector<Path> out;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == kind && path.visible == visible) out.push_back(path);
    }
  }
  return out;
}

inline Drawing drawn(Scene scene, Illustration illustration) {
  RunContext context;
  return illustrate(std::move(scene), std::move(illustration), context);
}

inline double length(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += glm::distance(path.points[i - 1], path.points[i]);
  }
  return sum;
}

/// Paper mm from the vertical line through the middle of the sheet, where the axis is.
struct Extent {
  double low, high;
};
inline Extent across(const Path& path, int coordinate) {
  Extent out{1e300, -1e300};
  for (const Vec2& p : path.points) {
    out.low = std::min(out.low, p[coordinate]);
    out.high = std::max(out.high, p[coordinate]);
  }
  return out;
}

}  // namespace burin::test
