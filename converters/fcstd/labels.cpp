#include "labels.h"

#include <burin/assembly/items.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace burin::detail {
namespace {

// Containers in containers; they may hold themselves.
constexpr int kDeepestContainer = 100;

/// What objects of any type are called until a person says otherwise, those that come from STEP and
/// IGES among them.
constexpr std::array kAnything{"Array",
                               "Assembly",
                               "Body",
                               "Clone",
                               "Compound",
                               "COMPOUND",
                               "Feature",
                               "Group",
                               "Link",
                               "LinkElement",
                               "LinkGroup",
                               "Mesh",
                               "Open CASCADE STEP translator",
                               "Part",
                               "Part__Feature",
                               "Part__Compound",
                               "PathArray",
                               "PointArray",
                               "Shape",
                               "SHELL",
                               "Shell",
                               "Solid",
                               "SOLID",
                               "Unnamed"};

struct Words {
  std::string_view type;
  std::string_view word;
};

/// Where the last part of the type, which is the usual label, is not the label: what FreeCAD's
/// commands call such an object, in the languages in which they do so.
constexpr std::array kOfType{Words{"Part::Box", "Box"},
                             Words{"Part::Box", "Cube"},
                             Words{"Part::Box", "Würfel"},
                             Words{"Part::Box", "Cubo"},
                             Words{"Part::Box", "Sześcian"},
                             Words{"Part::Box", "Куб"},
                             Words{"Part::Box", "Krychle"},
                             Words{"Part::Box", "Kubus"},
                             Words{"Part::Box", "立方体"},
                             Words{"Part::Box", "立方體"},
                             Words{"Part::Cylinder", "Zylinder"},
                             Words{"Part::Cylinder", "Cylindre"},
                             Words{"Part::Cylinder", "Cilindro"},
                             Words{"Part::Cylinder", "Walec"},
                             Words{"Part::Cylinder", "Цилиндр"},
                             Words{"Part::Cylinder", "Válec"},
                             Words{"Part::Cylinder", "Cilinder"},
                             Words{"Part::Cylinder", "円柱"},
                             Words{"Part::Cylinder", "圆柱体"},
                             Words{"Part::Cylinder", "圓柱"},
                             Words{"Part::Sphere", "Kugel"},
                             Words{"Part::Sphere", "Sphère"},
                             Words{"Part::Sphere", "Esfera"},
                             Words{"Part::Sphere", "Sfera"},
                             Words{"Part::Sphere", "Сфера"},
                             Words{"Part::Sphere", "Koule"},
                             Words{"Part::Sphere", "Bol"},
                             Words{"Part::Sphere", "球体"},
                             Words{"Part::Sphere", "球體"},
                             Words{"Part::Cone", "Kegel"},
                             Words{"Part::Cone", "Cône"},
                             Words{"Part::Cone", "Cono"},
                             Words{"Part::Cone", "Stożek"},
                             Words{"Part::Cone", "Конус"},
                             Words{"Part::Cone", "Kužel"},
                             Words{"Part::Cone", "円錐"},
                             Words{"Part::Cone", "圆锥体"},
                             Words{"Part::Cone", "錐體"},
                             Words{"Part::Torus", "Tore"},
                             Words{"Part::Torus", "Toro"},
                             Words{"Part::Torus", "Тор"},
                             Words{"Part::Torus", "トーラス"},
                             Words{"Part::Torus", "圆环体"},
                             Words{"Part::Torus", "圓環"},
                             Words{"Part::MultiFuse", "Fusion"},
                             Words{"Part::Fuse", "Fusion"},
                             Words{"Part::MultiCommon", "Common"},
                             Words{"Part::Extrusion", "Extrude"},
                             Words{"Part::Revolution", "Revolve"}};

bool is_anything(std::string_view stem) {
  return std::ranges::find(kAnything, stem) != kAnything.end();
}

bool is_word_of(std::string_view type, std::string_view stem) {
  if (type.substr(type.rfind(':') + 1) == stem) return true;
  return std::ranges::any_of(kOfType,
                             [&](const Words& w) { return w.type == type && w.word == stem; });
}

/// Whether a member of a container can be seen in it.
bool is_seen(const FcObject& o) {
  const bool has_shape = !o.shape.empty() || !o.mesh.empty() || o.is_body();
  return o.visible && !is_aid(o) && !is_bookkeeping(o) &&
         (has_shape || o.is_link() || !o.members().empty());
}

}  // namespace

bool is_meaningless(const FcObject& object) {
  const std::string stem = instance_stem(object.label);
  if (stem.find_first_not_of("0123456789.:_- ") == stem.npos) return true;
  // Elements of arrays are called after the array: "Row_i3".
  return object.is("App::LinkElement") || is_anything(stem) || is_word_of(object.type, stem);
}

std::string given_name(const FcDocument& document, const FcObject& object) {
  const FcObject* o = &object;
  for (int depth = 0; depth < kDeepestContainer; ++depth) {
    if (!is_meaningless(*o)) return o->label;
    o = document.holder(*o);
    if (o == nullptr || !shows_one(document, *o)) break;
  }
  return {};
}

bool shows_one(const FcDocument& document, const FcObject& container) {
  int seen = 0;
  for (const std::string& name : container.members()) {
    const std::int32_t i = document.find(name);
    if (i >= 0 && is_seen(document.objects()[static_cast<std::size_t>(i)])) ++seen;
    if (seen > 1) return false;
  }
  return true;
}

bool is_aid(const FcObject& object) {
  for (const char* t :
       {"PartDesign::Plane", "PartDesign::Line", "PartDesign::Point",
        "PartDesign::CoordinateSystem", "PartDesign::ShapeBinder", "PartDesign::SubShapeBinder",
        "PartDesign::SubShapeBinderPython", "App::Origin", "App::Plane", "App::Line", "App::Point",
        "App::OriginFeature", "App::Placement", "App::PlacementPython",
        "App::LocalCoordinateSystem", "Part::LocalCoordinateSystem"}) {
    if (object.is(t)) return true;
  }
  // Those of FreeCAD 1.1 are Part::DatumPlane and so on.
  return object.type.starts_with("Sketcher::") || object.type.starts_with("Part::Datum");
}

bool is_bookkeeping(const FcObject& object) {
  if (object.proxy_module.find("asm3.") == std::string::npos) return false;
  return std::ranges::none_of(std::array{"Assembly", "AsmPartGroup", "AsmPlainGroup"},
                              [&](const char* c) { return object.proxy_class == c; });
}

}  // namespace burin::detail
