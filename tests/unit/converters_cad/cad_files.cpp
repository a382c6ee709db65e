#include "cad_files.h"

#include <burin/base/error.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <gp_Ax1.hxx>

#include <numbers>

namespace burin::test {
namespace {

void name_label(const TDF_Label& label, const std::string& name) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), Standard_True));
}

Quantity_ColorRGBA to_color(const std::string& hex, double opacity) {
  Quantity_Color color;
  Quantity_Color::ColorFromHex(hex.c_str(), color);
  return {color, static_cast<float>(opacity)};
}

}  // namespace

TopoDS_Shape solid_box(double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(dx, dy, dz).Shape();
}

TopoDS_Shape solid_sphere(double radius) { return BRepPrimAPI_MakeSphere(radius).Shape(); }

TopoDS_Shape boxes_in_a_row(int count) {
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  for (int i = 0; i < count; ++i) {
    BRep_Builder().Add(all, solid_box(i + 1, 1, 1).Moved(TopLoc_Location(moved(10 * i, 0, 0))));
  }
  return all;
}

gp_Trsf moved(double x, double y, double z) {
  gp_Trsf t;
  t.SetTranslation(gp_Vec(x, y, z));
  return t;
}

gp_Trsf turned(double degrees) {
  gp_Trsf t;
  t.SetRotation(gp::OZ(), degrees * std::numbers::pi / 180);
  return t;
}

CadDocument::CadDocument() : document_(new TDocStd_Document("BinXCAF")) {
  STEPControl_Controller::Init();
  IGESControl_Controller::Init();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  XCAFDoc_ShapeTool::SetAutoNaming(Standard_False);
  shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
  colors_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
}

TDF_Label CadDocument::part(const TopoDS_Shape& shape, const std::string& name,
                            const std::string& hex) {
  const TDF_Label label = shapes_->AddShape(shape, Standard_False);
  name_label(label, name);
  if (!hex.empty()) color(label, hex);
  return label;
}

TDF_Label CadDocument::assembly(const std::string& name) {
  const TDF_Label label = shapes_->NewShape();
  name_label(label, name);
  return label;
}

TDF_Label CadDocument::use(const TDF_Label& assembly, const TDF_Label& what, const gp_Trsf& place,
                           const std::string& name) {
  const TDF_Label label = shapes_->AddComponent(assembly, what, TopLoc_Location(place));
  name_label(label, name);
  shapes_->UpdateAssemblies();
  return label;
}

void CadDocument::color(const TDF_Label& label, const std::string& hex, double opacity) {
  colors_->SetColor(label, to_color(hex, opacity), XCAFDoc_ColorSurf);
}

void CadDocument::color(const TDF_Label& part, const TopoDS_Shape& inside, const std::string& hex,
                        double opacity) {
  color(shapes_->AddSubShape(part, inside), hex, opacity);
}

std::string CadDocument::step(const std::string& file) const {
  STEPCAFControl_Writer writer;
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  EXPECT_TRUE(writer.Transfer(document_, STEPControl_AsIs));
  EXPECT_EQ(writer.Write(file.c_str()), IFSelect_RetDone);
  return file;
}

std::string CadDocument::step_in_files(const std::string& file) const {
  STEPCAFControl_Writer writer;
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  EXPECT_TRUE(writer.Transfer(document_, STEPControl_AsIs, "part_"));
  EXPECT_EQ(writer.Write(file.c_str()), IFSelect_RetDone);
  return file;
}

std::string CadDocument::iges(const std::string& file) const {
  IGESCAFControl_Writer writer;
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  EXPECT_TRUE(writer.Transfer(document_));
  EXPECT_TRUE(writer.Write(file.c_str()));
  return file;
}

Scene CadTest::read(const std::string& path) {
  RunContext context;
  return read_cad(path, context);
}

FileInfo CadTest::inspect(const std::string& path) {
  RunContext context;
  return inspect_cad(path, context);
}

std::string CadTest::error_of(const std::string& path) {
  try {
    read(path);
  } catch (const InputError& e) {
    EXPECT_EQ(e.file(), path);
    return e.what();
  }
  return {};
}

std::string CadTest::changed(const std::string& path, const std::string& what,
                             const std::string& into, const std::string& name) {
  std::string text = slurp(path);
  std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  for (; at != std::string::npos; at = text.find(what, at + into.size())) {
    text.replace(at, what.size(), into);
  }
  return folder_.write(name, text);
}

void expect_box(const Box3& box, Vec3 low, Vec3 high, double slack) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min[k], low[k], slack) << "axis " << k;
    EXPECT_NEAR(box.max[k], high[k], slack) << "axis " << k;
  }
}

std::int64_t count_of(const Diagnostics& diagnostics, const std::string& code) {
  std::int64_t n = 0;
  for (const Diagnostic& d : diagnostics.entries()) n += d.code == code ? d.count : 0;
  return n;
}

}  // namespace burin::test
