#pragma once
/// The forms that the conformance suite runs over. A new form adds its lines to `form_cases`.

#include <burin/forms/charted/nurbs.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/section/section.h>
#include <burin/surface/placed_form.h>

#include <BRepPrimAPI_MakeTorus.hxx>
#include <burin_test/brep_shapes.h>
#include <burin_test/cad.h>
#include <burin_test/charts.h>
#include <burin_test/irregular.h>
#include <burin_test/nurbs_shapes.h>
#include <burin_test/shapes.h>
#include <burin_test/turned.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burin::test {

struct FormCase {
  std::string name;
  std::function<std::shared_ptr<const Form>()> make;
  /// No boundary, so that the normals point out of a volume.
  bool closed = true;
  /// Degrees that frames' normals may be off those of the proxy.
  double normal_tolerance = 20;
  /// Curvature jumps over smooth edges, where it is that of either face.
  bool curvature_jumps = false;
  /// mm that a point may lie beside its place of the proxy, over the tolerance: a long triangle of
  /// a cone or a ball is narrower at one end, which its share of (u,v) is not.
  double slip = 0;
  /// How far normals of two faces may differ where they meet smoothly.
  double joint = 1e-9;
};

inline std::shared_ptr<const Form> mesh_form(TriMesh mesh) {
  return std::make_shared<MeshForm>(std::move(mesh));
}

inline std::shared_ptr<const Form> recognised_form(TriMesh mesh) {
  return std::make_shared<RecognisedForm>(std::move(mesh), RunContext{});
}

inline std::shared_ptr<const Form> parametric_form(
    std::vector<std::shared_ptr<const Chart>> patches) {
  return std::make_shared<ParametricForm>(std::move(patches));
}

inline std::shared_ptr<const Form> implicit_form(const Expression& f,
                                                 Mesher mesher = Mesher::Auto) {
  return std::make_shared<ImplicitForm>(make_function(f), std::nullopt, RunContext{}, 0,
                                        ImplicitProxyOptions{mesher});
}

/// Three cylinders along the axes, blended.
inline Expression implicit_blend() {
  const Expression c = implicit::cylinder(1, 6);
  return implicit::smooth_unite(implicit::smooth_unite(c, implicit::rotate(c, {90, 0, 0}), 0.5),
                                implicit::rotate(c, {0, 90, 0}), 0.5);
}

/// Turned by 37 degrees about z, half as large, away from the origin.
inline Placement elsewhere() {
  const Mat3 turn(0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1);
  return {turn * 0.5, {-4, 9, 2}};
}

/// Stretched and sheared: what it maps is similar to nothing that it was.
inline Placement sheared() { return {Mat3(1.6, 0, 0, 0.5, 0.7, 0.2, -0.3, 0, 1.1), {5, -3, 2}}; }
/// The same, and mirrored.
inline Placement mirrored_sheared() {
  const Mat3 mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  return {mirror * sheared().linear, {-7, 1, 4}};
}
/// A mirror image, which keeps all lengths.
inline Placement mirrored() { return {Mat3(0, 1, 0, 1, 0, 0, 0, 0, 1), {2, 2, -6}}; }

/// A plane across no axis.
inline CutPlane slanted(double offset) { return {glm::normalize(Vec3(1, 2, 3)), offset}; }

/// What lies beyond this plane and another across it.
inline CutRegion quarter(double offset) {
  return {slanted(offset), {glm::normalize(Vec3(3, 0, -1)), 0.05}};
}

/// An opening from above, of the size of its depth, around a place.
inline CutRegion opening(Vec3 center, double size) {
  CutRegion region{{{0, 0, 1}, center.z}};
  for (const Vec3 n :
       {Vec3(0.8, 0.6, 0), Vec3(-0.6, 0.8, 0), Vec3(-0.8, -0.6, 0), Vec3(0.6, -0.8, 0)}) {
    region.push_back({n, glm::dot(n, center) - size});
  }
  return region;
}

inline std::vector<FormCase> form_cases() {
  return {
      {"MeshTorus", [] { return mesh_form(torus(3, 1, 60, 30)); }},
      {"MeshIrregularEllipsoid",
       [] {
         return mesh_form(irregular_ellipsoid({3, 2, 1}, 4000));
       }},
      {"MeshCylinder", [] { return mesh_form(cylinder(2, 5, 48)); }},
      {"MeshBox",
       [] {
         return mesh_form(box({0, 0, 0}, {1, 2, 3}));
       }},
      {"MeshFillet", [] { return mesh_form(filleted_edge(1, 4, 6, 6, 5).mesh); }, false},
      {"MeshNoisy", [] { return mesh_form(noisy(irregular_torus(3, 1, 4000), 0.05)); }, true, 45},
      {"MeshTinyFarAway",
       [] {
         return mesh_form(
             mapped(torus(3e-3, 1e-3, 60, 30), [](Vec3 p) { return p + Vec3(100, -50, 30); }));
       }},
      {"NurbsTorus", [] { return parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}); }},
      {"NurbsSphere", [] { return parametric_form({make_nurbs_chart(sphere_nurbs(2))}); }},
      {"ParametricEllipsoid",
       [] {
         return parametric_form({ellipsoid_chart({3, 2, 1})});
       }},
      {"ParametricHalfPipe", [] { return parametric_form({cylinder_chart(2, 5, 4)}); }, false},
      {"SixPatchEllipsoid",
       [] {
         return parametric_form(six_patches({3, 2, 1}));
       }},
      {"ParametricBox",
       [] {
         return parametric_form(box_patches({1, 2, 3}));
       }},
      {"NurbsSheet",
       [] { return parametric_form({make_nurbs_chart(random_nurbs(3, 3, 9, 7, true, true, 5))}); },
       false},
      {"ImplicitTorus", [] { return implicit_form(implicit::torus(3, 1)); }},
      {"ImplicitEllipsoid",
       [] {
         const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();
         return implicit_form(x * x / 9 + y * y / 4 + z * z - 1);
       }},
      {"ImplicitBlend", [] { return implicit_form(implicit_blend()); }},
      {"ImplicitBoxMinusSphere",
       [] {
         return implicit_form(implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2)));
       }},
      {"ImplicitTorusDelaunay",
       [] { return implicit_form(implicit::torus(3, 1), Mesher::Delaunay); }},
      {"ImplicitBlendDelaunay", [] { return implicit_form(implicit_blend(), Mesher::Delaunay); }},
      {"ImplicitBoxMinusSphereDelaunay",
       [] {
         return implicit_form(implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2)),
                              Mesher::Delaunay);
       }},
      {"BrepBox", [] { return brep_form(box_shape(1, 2, 3)); }},
      {"BrepCylinder", [] { return brep_form(cylinder_shape(2, 5)); }},
      {"BrepFilletedBox", [] { return brep_form(filleted_box_shape(0.25)); }, true, 20, true},
      {"BrepTorus", [] { return brep_form(BRepPrimAPI_MakeTorus(3, 1).Shape()); }},
      {"BrepPlateWithHole", [] { return brep_form(plate_with_hole_shape()); }},
      {"BrepMirroredFarAway",
       [] {
         Placement p{Mat3(-1, 0, 0, 0, 0, 1, 0, 1, 0), {1e4, -2e4, 500}};
         p.linear *= 0.1;
         return brep_form(filleted_box_shape(0.5), p);
       },
       true, 20, true},
      {"RecognisedCylinder",
       [] {
         return recognised_form(turned({{2, 0}, {2, 5}}, 24));
       }},
      {"RecognisedCones",
       [] {
         return recognised_form(turned({{2, 0}, {2, 2}, {1, 4}, {1, 5}}, 30));
       },
       true, 20, false, 0.05},
      {"RecognisedBall", [] { return recognised_form(turned(sphere_profile(2, 32), 32)); }, true,
       20, false, 0.002, 1e-7},
      {"MeshPlaced", [] { return placed(mesh_form(torus(3, 1, 60, 30)), elsewhere()); }},
      {"PlacedNurbs",
       [] { return placed(parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}), elsewhere()); }},
      {"PlacedImplicit",
       [] {
         const Expression f = implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2));
         return placed(implicit_form(f), elsewhere());
       }},
      {"PlacedBrep", [] { return placed(brep_form(filleted_box_shape(0.25)), elsewhere()); }, true,
       20, true},
      {"MeshSheared", [] { return placed(mesh_form(torus(3, 1, 60, 30)), sheared()); }},
      {"MeshMirroredSheared",
       [] { return placed(mesh_form(torus(3, 1, 60, 30)), mirrored_sheared()); }},
      {"ShearedNurbs",
       [] { return placed(parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}), sheared()); }},
      {"MirroredShearedPatches",
       [] {
         return placed(parametric_form(six_patches({3, 2, 1})), mirrored_sheared());
       }},
      {"ShearedHalfPipe",
       [] { return placed(parametric_form({cylinder_chart(2, 5, 4)}), mirrored_sheared()); },
       false},
      {"ShearedImplicit",
       [] {
         const Expression f = implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2));
         return placed(implicit_form(f), sheared());
       }},
      {"MirroredShearedImplicit",
       [] { return placed(implicit_form(implicit::torus(3, 1)), mirrored_sheared()); }},
      {"MirroredImplicit",
       [] {
         const Expression f = implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2));
         return placed(implicit_form(f), mirrored());
       }},
      {"ShearedBrep", [] { return placed(brep_form(filleted_box_shape(0.25)), sheared()); }, true,
       // Its triangles turn by 12 degrees where they are made; stretched across by more.
       25, true},
      {"MirroredShearedBrep",
       [] { return placed(brep_form(cylinder_shape(2, 5)), mirrored_sheared()); }},
      {"MirroredBrep", [] { return placed(brep_form(plate_with_hole_shape()), mirrored()); }},
      {"ShearedRecognisedCylinder",
       [] {
         return placed(recognised_form(turned({{2, 0}, {2, 5}}, 24)), sheared());
       }},
      {"MirroredShearedRecognisedBall",
       [] {
         // Its rings meet within 1e-9 of its size, where an ellipsoid's curvatures differ by as
         // much.
         return placed(recognised_form(turned(sphere_profile(2, 32), 32)), mirrored_sheared());
       },
       true, 20, true, 0.004, 1e-7},
      {"MeshCutSheared",
       [] {
         return placed(cut_form(mesh_form(torus(3, 1, 60, 30)), slanted(0.4), 0, ""),
                       mirrored_sheared());
       }},
      {"MeshCut", [] { return cut_form(mesh_form(torus(3, 1, 60, 30)), slanted(0.4), 0, ""); }},
      {"CutNurbs",
       [] {
         return cut_form(parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}), slanted(0.4), 0,
                         "");
       }},
      {"CutImplicit",
       [] {
         const Expression f = implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2));
         return cut_form(implicit_form(f), slanted(0.1), 0, "");
       }},
      {"CutBrep", [] { return cut_form(brep_form(filleted_box_shape(0.25)), slanted(0.6), 0, ""); },
       true, 20, true},
      {"MeshQuarter", [] { return cut_form(mesh_form(torus(3, 1, 60, 30)), quarter(0.4), 0, ""); }},
      {"QuarterNurbs",
       [] {
         return cut_form(parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}), quarter(0.4), 0,
                         "");
       }},
      {"QuarterImplicit",
       [] {
         const Expression f = implicit::subtract(implicit::box(2, 2, 2), implicit::sphere(1.2));
         return cut_form(implicit_form(f), quarter(0.1), 0, "");
       }},
      {"QuarterBrep",
       [] { return cut_form(brep_form(filleted_box_shape(0.25)), quarter(2), 0, ""); }, true, 20,
       true},
      {"MeshOpened",
       [] {
         return cut_form(mesh_form(torus(3, 1, 60, 30)), opening({3, 0.1, 0.2}, 0.55), 0, "");
       }},
      {"OpenedNurbs",
       [] {
         return cut_form(parametric_form({make_nurbs_chart(torus_nurbs(3, 1))}),
                         opening({3, 0.1, 0.2}, 0.55), 0, "");
       }},
      {"OpenedImplicit",
       [] {
         return cut_form(implicit_form(implicit::torus(3, 1)), opening({3, 0.1, 0.2}, 0.55), 0, "");
       }},
      {"OpenedBrep",
       [] {
         return cut_form(brep_form(filleted_box_shape(0.25)), opening({2, 1.5, 1.6}, 0.5), 0, "");
       },
       true, 20, true},
  };
}

/// What a test makes of a form, made once for all tests after each other that ask for it of the
/// same form.
template <class Made>
class OfOneForm {
 public:
  template <class Make>
  Made& get(const std::string& name, const Make& make) {
    if (name_ != name || !made_) {
      made_.reset();
      made_ = make();
      name_ = name;
    }
    return *made_;
  }

 private:
  std::string name_;
  std::unique_ptr<Made> made_;
};

struct RealisedForm {
  std::shared_ptr<const Form> form;
  std::shared_ptr<const Surface> surface;
};

/// A form and its surface, 0.01 mm off at the most.
inline const RealisedForm& realised(const FormCase& which) {
  static OfOneForm<RealisedForm> kept;
  return kept.get(which.name, [&] {
    RunContext context;
    auto made = std::make_unique<RealisedForm>();
    made->form = which.make();
    made->surface = made->form->realise({.tolerance = 0.01}, context);
    return made;
  });
}

}  // namespace burin::test
