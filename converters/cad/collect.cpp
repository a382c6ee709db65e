#include "collect.h"

#include <burin/assembly/pieces.h>
#include <burin/base/ascii.h>

#include "colors.h"
#include "text.h"

#include <BRep_Builder.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace burin {
namespace {

std::string raw_name(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  // The 0 asks for UTF-8.
  return clean_name(TCollection_AsciiString(name->Get(), 0).ToCString());
}

/// Whether nothing but digits and what stands between them is left of a name.
bool is_count(std::string_view rest) {
  return rest.find_first_not_of("0123456789.:_- ") == std::string_view::npos;
}

/// Names that programs made up: none, "NAUO12", the words of the standard, OCCT's own.
bool is_made_up(const std::string& name) {
  constexpr std::array<std::string_view, 6> kMadeUp{
      "Open CASCADE STEP translator",   "=>[",           "Next assembly relationship",
      "Next assembly usage occurrence", "Rhino Product", "the product name"};
  const auto begins = [&](std::string_view words) {
    return equal_but_for_case(std::string_view(name).substr(0, words.size()), words);
  };
  if (name.empty() || std::ranges::any_of(kMadeUp, begins)) return true;
  return name.starts_with("NAUO") && is_count(std::string_view(name).substr(4));
}

/// Those, and numbers.
bool is_meaningless(const std::string& name) { return is_made_up(name) || is_count(name); }

/// Those, and what any solid is called, numbered or not.
bool is_meaningless_for_solid(const std::string& name) {
  constexpr std::array<std::string_view, 12> kAny{
      "solid", "body",   "part", "shell", "brep",      "manifold_solid_brep",
      "none",  "volume", "lump", "shape", "solidbody", "unnamed"};
  if (is_meaningless(name)) return true;
  return std::ranges::any_of(kAny, [&](std::string_view word) {
    return equal_but_for_case(std::string_view(name).substr(0, word.size()), word) &&
           is_count(std::string_view(name).substr(std::min(word.size(), name.size())));
  });
}

class Collector {
 public:
  Collector(const Handle(TDocStd_Document) & document, const CollectOptions& options,
            const RunContext& context)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        options_(options),
        context_(context) {}

  void run() {
    TDF_LabelSequence labels;
    shapes_->GetFreeShapes(labels);
    std::vector<TDF_Label> loose;
    for (const TDF_Label& root : labels) {
      if (options_.roots == Roots::Entities && is_loose(root)) {
        loose.push_back(root);
      } else if (const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(root); is_group(shape)) {
        group(shape, name_of(root, root, {}), LabelColors(colors_, root), {});
      } else {
        visit(root, root, {});
      }
    }
    join(loose);
  }

  std::vector<CadPart> parts;
  /// Leaves without any face, and what of others belongs to none.
  Loose left_out;
  /// The name of the first member of which something was.
  std::string first_left_out;

 private:
  struct Place {
    TopLoc_Location location;
    std::vector<std::string> assembly;
    /// Of an instance, which goes before that of what it is an instance of; of an assembly, which
    /// is that of members without one.
    Appearance instance_color, assembly_color;
  };

  /// Faces, or wires and points, that nobody gave a name or put together.
  static bool is_loose(const TDF_Label& root) {
    if (XCAFDoc_ShapeTool::IsAssembly(root) || !is_meaningless(raw_name(root))) return false;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(root);
    return !shape.IsNull() && shape.ShapeType() > TopAbs_SHELL;
  }

  /// Entities that are loose, as one part.
  void join(const std::vector<TDF_Label>& loose) {
    if (loose.empty()) return;
    TopoDS_Compound all;
    BRep_Builder().MakeCompound(all);
    for (const TDF_Label& root : loose) {
      context_.check();
      BRep_Builder().Add(all, XCAFDoc_ShapeTool::GetShape(root));
    }
    add(bodies_of(all), count_loose(all), options_.fallback, LabelColors(colors_, loose), {});
  }

  /// The name of a group, a subfigure or a solid, where somebody gave it one.
  const std::string* name_of_member(const TopoDS_Shape& shape) const {
    if (shape.ShapeType() > TopAbs_SOLID) return nullptr;
    const std::string* name = options_.members.Seek(shape);
    return name != nullptr && !is_meaningless(*name) ? name : nullptr;
  }

  /// Whether a shape is a group of which members have names.
  bool is_group(const TopoDS_Shape& shape) const {
    if (shape.IsNull() || shape.ShapeType() != TopAbs_COMPOUND) return false;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      if (name_of_member(it.Value()) != nullptr) return true;
    }
    return false;
  }

  /// Members with names are groups or parts themselves; what else there is is a part of its name.
  void group(const TopoDS_Shape& shape, const std::string& name, const LabelColors& colors,
             std::vector<std::string> assembly) {
    context_.check();
    if (!is_group(shape)) return add(bodies_of(shape), count_loose(shape), name, colors, assembly);
    assembly.push_back(name);
    TopoDS_Compound rest;
    BRep_Builder().MakeCompound(rest);
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      if (const std::string* member = name_of_member(it.Value()); member != nullptr) {
        group(it.Value(), *member, colors, assembly);
      } else {
        BRep_Builder().Add(rest, it.Value());
      }
    }
    if (rest.NbChildren() == 0) return;
    add(bodies_of(rest), count_loose(rest), name, colors, assembly);
  }

  /// A part of what stands at the top of an IGES file, or in a group there.
  void add(std::vector<CadBody> bodies, const Loose& loose, const std::string& name,
           const LabelColors& colors, const std::vector<std::string>& assembly) {
    leave_out(bodies.empty() && loose.count() == 0 ? Loose{0, 1} : loose, name);
    if (bodies.empty()) return;
    CadPart part = make_part(std::move(bodies), name);
    part.assembly = assembly;
    std::ranges::transform(*part.bodies, part.colors.begin(),
                           [&](const CadBody& body) { return colors.of(body); });
    part.faces = colors.faces_of(*part.bodies, part.colors);
    parts.push_back(std::move(part));
  }

  void leave_out(const Loose& loose, const std::string& name) {
    if (left_out.count() == 0 && loose.count() > 0) first_left_out = name;
    left_out.curves += loose.curves;
    left_out.others += loose.others;
  }

  std::string name_of(const TDF_Label& instance, const TDF_Label& product,
                      const std::vector<std::string>& assembly) const {
    std::string of_product = raw_name(product);
    std::string name = raw_name(instance);
    if (!is_meaningless(name) && !is_number_of(of_product, name)) return name;
    if (!is_meaningless(of_product)) return of_product;
    // Of one part alone the file says more; members of an assembly have their numbers.
    if (assembly.empty()) return options_.fallback;
    return is_made_up(of_product) ? assembly.back() : of_product;
  }

  /// Whether an instance is called by its product's number, "4711-22.1" of 4711-22.
  bool is_number_of(const std::string& product, std::string_view name) const {
    const auto [first, end] = options_.numbers.equal_range(product);
    return std::any_of(first, end, [&](const auto& entry) {
      return name.starts_with(entry.second) && is_count(name.substr(entry.second.size()));
    });
  }

  /// `instance` is the label that stands in the assembly, `product` what it refers to.
  void visit(const TDF_Label& instance, const TDF_Label& product, Place place) {
    context_.check();
    const std::string name = name_of(instance, product, place.assembly);
    if (place.instance_color.color.empty() && instance != product) {
      place.instance_color = label_color(colors_, instance);
    }
    if (!XCAFDoc_ShapeTool::IsAssembly(product)) return leaf(product, name, place);
    place.assembly.push_back(name);
    if (Appearance color = label_color(colors_, product); !color.color.empty()) {
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

  /// What a label of a shape holds: read once, shared by its instances.
  struct Product {
    std::shared_ptr<const std::vector<CadBody>> bodies;
    std::vector<Appearance> colors;
    std::shared_ptr<const std::vector<CadFaces>> faces;
    /// What of it belongs to no face; one thing where there is nothing at all.
    Loose left_out;
  };

  /// The bodies of a product with the names that its solids were given.
  std::vector<CadBody> named_bodies(const TopoDS_Shape& shape) const {
    std::vector<CadBody> bodies = bodies_of(shape);
    for (CadBody& body : bodies) {
      const std::string* name = options_.solids.Seek(body.shape.Located(TopLoc_Location()));
      if (name != nullptr && !is_meaningless_for_solid(*name))
        body.name = piece_name(body.name, *name);
    }
    return bodies;
  }

  const Product& product_of(const TDF_Label& label) {
    TCollection_AsciiString entry;
    TDF_Tool::Entry(label, entry);
    const auto [at, is_new] = products_.try_emplace(entry.ToCString());
    if (!is_new) return at->second;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    CadPart part = make_part(shape.IsNull() ? std::vector<CadBody>() : named_bodies(shape), {});
    const Loose loose = shape.IsNull() ? Loose() : count_loose(shape);
    const LabelColors colors(colors_, label);
    std::ranges::transform(*part.bodies, part.colors.begin(),
                           [&](const CadBody& body) { return colors.of(body); });
    part.faces = colors.faces_of(*part.bodies, part.colors);
    const bool nothing = part.bodies->empty() && loose.count() == 0;
    at->second = {std::move(part.bodies), std::move(part.colors), std::move(part.faces),
                  nothing ? Loose{0, 1} : loose};
    return at->second;
  }

  void leaf(const TDF_Label& label, const std::string& name, const Place& place) {
    const Product& product = product_of(label);
    leave_out(product.left_out, name);
    if (product.bodies->empty()) return;
    CadPart part;
    part.name = name;
    part.assembly = place.assembly;
    part.definition = raw_name(label);
    if (is_meaningless(part.definition)) part.definition.clear();
    part.bodies = product.bodies;
    part.colors = product.colors;
    if (place.instance_color.color.empty()) part.faces = product.faces;
    part.placement = placement_of(place.location);
    for (Appearance& color : part.colors) {
      if (!place.instance_color.color.empty()) color = place.instance_color;
      if (color.color.empty()) color = place.assembly_color;
    }
    parts.push_back(std::move(part));
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  const CollectOptions& options_;
  const RunContext& context_;
  std::map<std::string, Product> products_;
};

}  // namespace

std::vector<CadPart> collect_parts(const Handle(TDocStd_Document) & document,
                                   const CollectOptions& options, Diagnostics& diagnostics,
                                   const RunContext& context) {
  Collector collector(document, options, context);
  collector.run();
  report_left_out(collector.parts, collector.left_out, collector.first_left_out, diagnostics);
  make_names_unique(collector.parts);
  return std::move(collector.parts);
}

}  // namespace burin
