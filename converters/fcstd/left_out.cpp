#include "left_out.h"

#include <burin/base/short_list.h>

#include "labels.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace burin::detail {
namespace {

// So many are named; of documents with hundreds of loose wires the first.
constexpr std::size_t kNamed = 50;

struct Kind {
  std::string_view type;
  const char* words;
};

/// What can be seen of types that have neither shape nor mesh, by the beginning of the type.
constexpr std::array kKinds{Kind{"Points::", "clouds of points"},
                            Kind{"Fem::FemMesh", "meshes of FEM"},
                            Kind{"Fem::FemPost", "results of FEM"},
                            Kind{"App::VRMLObject", "scenes of VRML"},
                            Kind{"App::InventorObject", "scenes of Inventor"},
                            Kind{"App::Annotation", "texts and dimensions"},
                            Kind{"App::MeasureDistance", "texts and dimensions"},
                            Kind{"Measure::", "texts and dimensions"},
                            Kind{"Image::", "pictures"},
                            Kind{"Path::", "tool paths"},
                            Kind{"Robot::", "robots"}};

/// Annotations of Draft have no place of their own.
bool is_annotation(const FcObject& o) {
  if (!o.proxy_module.starts_with("draftobjects.")) return false;
  return std::ranges::any_of(std::array{"Text", "Label", "Dimension", "DimensionBase"},
                             [&](std::string_view c) { return o.proxy_class.ends_with(c); });
}

const char* kind_of(const FcObject& o) {
  if (is_annotation(o)) return "texts and dimensions";
  const auto kind =
      std::ranges::find_if(kKinds, [&](const Kind& k) { return o.type.starts_with(k.type); });
  return kind == kKinds.end() ? nullptr : kind->words;
}

/// Joints of assemblies stand at a place where there is nothing to see.
bool is_joint(const FcObject& o) { return o.proxy_module.starts_with("JointObject"); }

}  // namespace

void LeftOut::add(Severity severity, const char* code, const std::string& why,
                  const std::string& name) {
  auto it = std::ranges::find_if(reasons_, [&](const Reason& r) { return r.why == why; });
  if (it == reasons_.end()) it = reasons_.insert(it, {severity, code, why, {}});
  it->names.push_back(name);
}

void LeftOut::report(Diagnostics& diagnostics) const {
  for (const Reason& r : reasons_) {
    diagnostics.add(r.severity, r.code, static_cast<std::int64_t>(r.names.size()),
                    r.why + ": " + short_list(r.names, kNamed, in_quotes));
  }
}

void leave_out_shapeless(const FcObject& object, const std::string& name, LeftOut& left_out) {
  if (const char* kind = kind_of(object)) {
    return left_out.add(Severity::Warning, "fcstd.not_drawn",
                        fmt::format("{} are not drawn; left out", kind), name);
  }
  const bool could_have =
      object.has_placement && !is_joint(object) && !is_aid(object) && !object.has_group;
  if (!could_have && !object.is_body()) return;
  left_out.add(Severity::Warning, "fcstd.no_shape",
               "visible, but without a shape in the document (recompute it in FreeCAD); left out",
               name);
}

void leave_out_aid(const FcObject& object, const std::string& name, LeftOut& left_out) {
  if (object.type.find("ShapeBinder") != std::string::npos) {
    left_out.add(Severity::Warning, "fcstd.aids",
                 "shape binders are aids of modelling and not drawn unless `object` names them; "
                 "left out",
                 name);
  } else if (object.type.starts_with("Sketcher::")) {
    left_out.add(Severity::Info, "fcstd.aids", "sketches have no faces; left out", name);
  }
}

void leave_out_faceless(const std::string& name, LeftOut& left_out) {
  left_out.add(Severity::Warning, "fcstd.no_faces",
               "visible, but without any face (wires, points); left out", name);
}

}  // namespace burin::detail
