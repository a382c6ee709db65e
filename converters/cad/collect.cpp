#include "collect.h"

#include "colors.h"
#include "text.h"

#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <utility>

namespace burin {
namespace {

std::string raw_name(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  // The 0 asks for UTF-8.
  return clean_name(TCollection_AsciiString(name->Get(), 0).ToCString());
}

/// Names that programs made up: numbers, "NAUO12", OCCT's own.
bool says_nothing(const std::string& name) {
  if (name.starts_with("Open CASCADE STEP translator") || name.starts_with("=>[")) return true;
  const std::string rest = name.starts_with("NAUO") ? name.substr(4) : name;
  return rest.find_first_not_of("0123456789.:_- ") == std::string::npos;
}

class Collector {
 public:
  Collector(const Handle(TDocStd_Document) & document, const std::string& fallback,
            const RunContext& context)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        fallback_(fallback),
        context_(context) {}

  void run() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) visit(root, root, {});
  }

  std::vector<CadPart> parts;
  /// Leaves without any face, and what of others belongs to none.
  std::int64_t left_out = 0;

 private:
  struct Place {
    TopLoc_Location location;
    std::vector<std::string> assembly;
    /// Of an instance, which goes before that of what it is an instance of; of an assembly, which
    /// is that of members without one.
    std::string instance_color, assembly_color;
  };

  std::string name_of(const TDF_Label& instance, const TDF_Label& product) const {
    for (const TDF_Label& label : {instance, product}) {
      if (std::string name = raw_name(label); !says_nothing(name)) return name;
    }
    return fallback_;
  }

  /// `instance` is the label that stands in the assembly, `product` what it refers to.
  void visit(const TDF_Label& instance, const TDF_Label& product, Place place) {
    context_.check();
    const std::string name = name_of(instance, product);
    if (place.instance_color.empty() && instance != product) {
      place.instance_color = label_color(colors_, instance);
    }
    if (!XCAFDoc_ShapeTool::IsAssembly(product)) return leaf(product, name, place);
    place.assembly.push_back(name);
    if (std::string color = label_color(colors_, product); !color.empty()) {
      place.assembly_color = std::move(color);
    }
    TDF_LabelSequence members;
    XCAFDoc_ShapeTool::GetComponents(product, members);
    for (const TDF_Label& member : members) {
      TDF_Label referred;
      if (!XCAFDoc_ShapeTool::GetReferredShape(member, referred)) referred = member;
      Place at = place;
      at.location = place.location * XCAFDoc_ShapeTool::GetLocation(member);
      visit(member, referred, std::move(at));
    }
  }

  void leaf(const TDF_Label& product, const std::string& name, const Place& place) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    const std::vector<TopoDS_Shape> pieces =
        shape.IsNull() ? std::vector<TopoDS_Shape>() : split_shape(shape);
    const std::int64_t loose = shape.IsNull() ? 0 : count_loose(shape);
    left_out += pieces.empty() && loose == 0 ? 1 : loose;
    const LabelColors colors(colors_, product);
    std::string definition = raw_name(product);
    if (says_nothing(definition)) definition.clear();
    for (const TopoDS_Shape& piece : pieces) {
      CadPart part = make_part(piece, place.location, name);
      part.assembly = place.assembly;
      part.definition = definition;
      part.color = place.instance_color.empty() ? colors.of(piece) : place.instance_color;
      if (part.color.empty()) part.color = place.assembly_color;
      parts.push_back(std::move(part));
    }
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  std::string fallback_;
  const RunContext& context_;
};

}  // namespace

std::vector<CadPart> collect_parts(const Handle(TDocStd_Document) & document,
                                   const std::string& fallback, Diagnostics& diagnostics,
                                   const RunContext& context) {
  Collector collector(document, fallback, context);
  collector.run();
  tell_left_out(collector.parts, collector.left_out, diagnostics);
  make_names_unique(collector.parts);
  return std::move(collector.parts);
}

}  // namespace burin
