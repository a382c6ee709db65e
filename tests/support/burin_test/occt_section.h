#pragma once
/// A cut of a CAD part beside OCCT's section of its exact faces. For tests that link OCCT.

#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/section/section.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace burin::test {

/// What closes a cut.
struct CapMeasure {
  double area = 0, perimeter = 0;  // mm2, mm
  std::size_t loops = 0;
  /// How far corners of the loops lie from the exact faces, mm.
  double off_surface = 0;
};

/// A surface that is there already, so that the cut alone is timed.
class HeldForm final : public Form {
 public:
  explicit HeldForm(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {}
  Box3 bounds(const Mat3& axes) const override {
    Box3 box;
    for (const Vec3& p : surface_->proxy().mesh.positions) box.add(axes * p);
    return box;
  }
  std::shared_ptr<const Surface> realise(const RealiseOptions&, RunContext&) const override {
    return surface_;
  }
  bool same_as(const Form&) const override { return false; }
  Definition definition() const override { return {}; }
  ShapeMeasure measure(RunContext&) const override { return {}; }

 private:
  std::shared_ptr<const Surface> surface_;
};

/// Loops as the edges between what closes the cut and the rest, joined where they share a vertex.
inline CapMeasure measure_cap(const Surface& surface) {
  const ProxyMesh& proxy = surface.proxy();
  CapMeasure cap;
  if (proxy.cut_plane.empty()) return cap;
  std::map<std::uint32_t, std::uint32_t> joined;
  const auto root = [&](std::uint32_t v) {
    while (joined.at(v) != v) v = joined.at(v);
    return v;
  };
  for (std::uint32_t f = 0; f < proxy.mesh.triangles.size(); ++f) {
    if (!proxy.is_cut(f)) continue;
    cap.area += proxy.mesh.area(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdge o = proxy.topology.opposite[3 * std::size_t{f} + k];
      if (o != kNoHalfEdge && proxy.is_cut(face_of(o))) continue;
      const std::uint32_t a = proxy.mesh.triangles[f][k], b = proxy.mesh.triangles[f][(k + 1) % 3];
      cap.perimeter += glm::distance(proxy.mesh.positions[a], proxy.mesh.positions[b]);
      joined.try_emplace(a, a), joined.try_emplace(b, b);
      joined[root(a)] = root(b);
      if (o == kNoHalfEdge) continue;
      Vec3 corner(0);
      corner[static_cast<int>(static_cast<std::size_t>(o) % 3)] = 1;
      const ProxyPoint at{face_of(o), corner};
      const Frame frame = surface.frame(surface.lift(at));
      const Vec3 off = proxy.position(at.face, at.bary) - frame.position;
      cap.off_surface = std::max(cap.off_surface, std::abs(glm::dot(off, frame.normal)));
    }
  }
  std::set<std::uint32_t> roots;
  for (const auto& [v, ignored] : joined) roots.insert(root(v));
  cap.loops = roots.size();
  return cap;
}

/// Whether a face lies in the plane, so that "inside" has no answer there.
inline bool face_in_plane(const ProxyMesh& whole, const CutPlane& plane, double near) {
  double area = 0, all = 0;
  for (std::uint32_t f = 0; f < whole.mesh.triangles.size(); ++f) {
    const bool in = std::ranges::all_of(whole.mesh.triangles[f], [&](std::uint32_t v) {
      return std::abs(glm::dot(plane.normal, whole.mesh.positions[v]) - plane.offset) < near;
    });
    all += whole.mesh.area(f);
    if (in) area += whole.mesh.area(f);
  }
  return area > 1e-6 * all;
}

/// The area of the plane inside a solid, by asking of some 20,000 points whether they are inside
/// (BRepClass3d_SolidClassifier): slow, to within 2 %, and with none of a section's ways to fail.
inline double classified_area(const TopoDS_Shape& solid, const CutPlane& plane, const Box3& box) {
  constexpr int kPoints = 20'000;
  const Vec3 u = any_orthogonal(plane.normal), v = glm::cross(plane.normal, u);
  Box2 flat;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 p(i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y,
                 i & 4U ? box.max.z : box.min.z);
    flat.add({glm::dot(u, p), glm::dot(v, p)});
  }
  BRepClass3d_SolidClassifier classifier(solid);
  int inside = 0;
  for (int i = 0; i < kPoints; ++i) {
    // A sequence that is even in no direction more than in others.
    const Vec2 share(std::fmod(0.5 + i * 0.7548776662466927, 1.0),
                     std::fmod(0.5 + i * 0.5698402909980532, 1.0));
    const Vec2 at = flat.min + (flat.max - flat.min) * share;
    const Vec3 p = at.x * u + at.y * v + plane.offset * plane.normal;
    classifier.Perform(gp_Pnt(p.x, p.y, p.z), 1e-9);
    inside += classifier.State() == TopAbs_IN ? 1 : 0;
  }
  const Vec2 size = flat.max - flat.min;
  return size.x * size.y * inside / kPoints;
}

struct OcctCap {
  bool done = false;
  double area = 0;
  std::size_t loops = 0;
  double seconds = 0;
};

/// What the shape and the plane have in common, as faces.
inline OcctCap occt_cap(const TopoDS_Shape& shape, const CutPlane& plane, double size) {
  OcctCap cap;
  const auto start = std::chrono::steady_clock::now();
  try {
    const Vec3 p = plane.offset * plane.normal;
    const gp_Pln pln(gp_Pnt(p.x, p.y, p.z), gp_Dir(plane.normal.x, plane.normal.y, plane.normal.z));
    const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(pln, -size, size, -size, size).Face();
    BRepAlgoAPI_Common common(sheet, shape);
    cap.done = common.IsDone();
    if (cap.done) {
      GProp_GProps props;
      BRepGProp::SurfaceProperties(common.Shape(), props);
      cap.area = props.Mass();
      for (TopExp_Explorer e(common.Shape(), TopAbs_WIRE); e.More(); e.Next()) ++cap.loops;
    }
  } catch (const Standard_Failure&) {
    cap.done = false;
  }
  cap.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return cap;
}

}  // namespace burin::test
