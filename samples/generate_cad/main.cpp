// burin_cad_samples FOLDER: writes the CAD samples as STEP files, the same bytes each time.
#include "models.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Protocol.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>

namespace {

using burin::samples::Assembly;
using burin::samples::Member;
namespace fs = std::filesystem;

/// Puts the colours in the order of what they colour: OCCT writes them in that of addresses.
void sort_colors(const Handle(StepData_StepModel) & model) {
  using Colors = StepVisual_MechanicalDesignGeometricPresentationRepresentation;
  std::vector<Handle(Standard_Transient)> others;
  std::map<int, Handle(Standard_Transient)> colors;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto color = Handle(Colors)::DownCast(model->Value(i));
    if (color.IsNull()) {
      if (colors.empty()) others.push_back(model->Value(i));
      continue;
    }
    const auto item = Handle(StepVisual_StyledItem)::DownCast(color->ItemsValue(1));
    colors[item.IsNull() ? i : model->Number(item->Item())] = color;
  }
  const Handle(Interface_Protocol) protocol = model->Protocol();
  model->ClearEntities();
  for (const auto& entity : others) model->AddEntity(entity);
  for (const auto& [number, color] : colors) model->AddWithRefs(color, protocol);
}

/// A document with one thing in it, and its file.
class StepFile {
 public:
  StepFile() : document_(new TDocStd_Document("BinXCAF")) {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetIVal("write.step.assembly", 1);
    // Readers find curves on surfaces themselves; written, they make a freeform part ten times as
    // large.
    Interface_Static::SetIVal("write.surfacecurve.mode", 0);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    colors_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
    XCAFDoc_ShapeTool::SetAutoNaming(Standard_False);
  }

  TDF_Label add(const TopoDS_Shape& shape, const std::string& name, const Quantity_Color& color) {
    const TDF_Label label = shapes_->AddShape(shape, Standard_False);
    TDataStd_Name::Set(label, name.c_str());
    colors_->SetColor(label, color, XCAFDoc_ColorSurf);
    return label;
  }

  void add(const Assembly& assembly) {
    std::vector<TDF_Label> parts;
    for (const auto& part : assembly.parts) parts.push_back(add(part.shape, part.name, part.color));
    const TDF_Label top = shapes_->NewShape();
    TDataStd_Name::Set(top, assembly.name.c_str());
    for (const Member& member : assembly.members) add(member, top, parts);
    shapes_->UpdateAssemblies();
  }

  void write(const fs::path& path, const std::string& product) {
    const Handle(Message_Messenger) messenger = Message::DefaultMessenger();
    messenger->ChangePrinters().Clear();
    STEPCAFControl_Writer writer;
    writer.SetColorMode(Standard_True);
    writer.SetNameMode(Standard_True);
    if (!writer.Transfer(document_, STEPControl_AsIs)) throw std::runtime_error("no STEP model");
    sort_colors(writer.ChangeWriter().Model());
    APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
    const auto text = [](const std::string& s) { return new TCollection_HAsciiString(s.c_str()); };
    header.SetName(text(product));
    header.SetTimeStamp(text("2026-01-01T00:00:00"));
    header.SetAuthorValue(1, text("Burin"));
    header.SetOrganizationValue(1, text("Burin"));
    header.SetOriginatingSystem(text("burin_cad_samples"));
    if (writer.Write(path.string().c_str()) != IFSelect_RetDone) {
      throw std::runtime_error("cannot write " + path.string());
    }
  }

 private:
  void add(const Member& member, const TDF_Label& into, const std::vector<TDF_Label>& parts) {
    const TDF_Label what =
        member.part >= 0 ? parts[static_cast<std::size_t>(member.part)] : group(member, parts);
    const TDF_Label label = shapes_->AddComponent(into, what, TopLoc_Location(member.place));
    TDataStd_Name::Set(label, member.name.c_str());
  }

  /// Groups of the same members are one product.
  TDF_Label group(const Member& member, const std::vector<TDF_Label>& parts) {
    std::string product = member.name;
    product.erase(product.find_last_not_of("0123456789 ") + 1);
    if (const auto it = groups_.find(product); it != groups_.end()) return it->second;
    const TDF_Label label = shapes_->NewShape();
    TDataStd_Name::Set(label, product.c_str());
    for (const Member& m : member.group) add(m, label, parts);
    groups_.emplace(product, label);
    return label;
  }

  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  std::map<std::string, TDF_Label> groups_;
};

int faces_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

void save(const TopoDS_Shape& shape, const std::string& name, const Quantity_Color& color,
          const fs::path& path) {
  StepFile file;
  file.add(shape, name, color);
  file.write(path, name);
  fmt::print("{:<24} {:>8} bytes {:>4} faces\n", path.filename().string(), fs::file_size(path),
             faces_of(shape));
}

void save(const Assembly& assembly, const fs::path& path) {
  StepFile file;
  file.add(assembly);
  file.write(path, assembly.name);
  int faces = 0;
  for (const auto& part : assembly.parts) faces += faces_of(part.shape);
  fmt::print("{:<24} {:>8} bytes {:>4} faces in {} parts\n", path.filename().string(),
             fs::file_size(path), faces, assembly.parts.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: burin_cad_samples FOLDER\n", stderr);
    return 2;
  }
  try {
    const fs::path folder = argv[1];
    using namespace burin::samples;
    save(pedestal(), "pedestal bearing", Quantity_Color(0.36, 0.48, 0.42, Quantity_TOC_sRGB),
         folder / "pedestal.step");
    save(propeller(), "propeller", Quantity_Color(0.80, 0.62, 0.30, Quantity_TOC_sRGB),
         folder / "propeller.step");
    save(coupling(), folder / "coupling.step");
    save(revised_coupling(), folder / "coupling_revised.step");
    save(pump(), folder / "gear_pump.step");
    return 0;
  } catch (const Standard_Failure& e) {
    fmt::print(stderr, "burin_cad_samples: {}: {}\n", e.DynamicType()->Name(),
               e.GetMessageString());
  } catch (const std::exception& e) {
    fmt::print(stderr, "burin_cad_samples: {}\n", e.what());
  }
  return 1;
}
