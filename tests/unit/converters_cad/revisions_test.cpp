/// Revisions of the CAD samples, rewritten and changed by OCCT.
#include <burin/base/run_context.h>
#include <burin/diff/difference.h>

#include "cad_files.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Version.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_Location.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {
namespace {

/// A STEP file as OCCT has it, to be changed and written again.
class Revised {
 public:
  explicit Revised(const std::string& file) : document_(new TDocStd_Document("BinXCAF")) {
    const test::CadDocument quiet;  // OCCT says nothing from here on
    STEPCAFControl_Reader reader;
    reader.SetNameMode(Standard_True);
    reader.SetColorMode(Standard_True);
    reader.ReadFile(file.c_str());
    reader.Transfer(document_);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
  }

  void remove(const std::string& name) { shapes_->RemoveComponent(instance(name)); }
  /// Shifted, and turned about its own z axis.
  void move(const std::string& name, const gp_Trsf& shift, const gp_Trsf& turn) {
    const TDF_Label label = instance(name);
    const TopLoc_Location place = XCAFDoc_ShapeTool::GetLocation(label);
    XCAFDoc_Location::Set(label, TopLoc_Location(shift) * place * TopLoc_Location(turn));
  }
  /// A hole through what the instance is of, along z.
  void drill(const std::string& name, double x, double y, double radius) {
    TDF_Label part;
    XCAFDoc_ShapeTool::GetReferredShape(instance(name), part);
    const TopoDS_Shape drill =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, -500), gp::DZ()), radius, 1000).Shape();
    shapes_->SetShape(part, BRepAlgoAPI_Cut(XCAFDoc_ShapeTool::GetShape(part), drill).Shape());
  }
  std::string write(const std::string& file, const char* unit = "MM") {
    shapes_->UpdateAssemblies();
    Interface_Static::SetCVal("write.step.unit", unit);
    STEPCAFControl_Writer writer;
    writer.SetNameMode(Standard_True);
    writer.SetColorMode(Standard_True);
#if OCC_VERSION_HEX >= 0x070800
    // It names the unit that is asked for, and goes on writing millimetres.
    Handle(StepData_StepModel)::DownCast(writer.ChangeWriter().WS()->Model())
        ->SetWriteLengthUnit(std::string_view(unit) == "INCH" ? 25.4 : 1);
#endif
    writer.Transfer(document_, STEPControl_AsIs);
    const bool written = writer.Write(file.c_str()) == IFSelect_RetDone;
    Interface_Static::SetCVal("write.step.unit", "MM");
    EXPECT_TRUE(written);
    return file;
  }

 private:
  static std::string own_name(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    return TCollection_AsciiString(name->Get()).ToCString();
  }
  /// An instance of its own name, or of that of its shape.
  static bool is_called(const TDF_Label& label, const std::string& name) {
    TDF_Label shape;
    if (own_name(label) == name) return true;
    return XCAFDoc_ShapeTool::GetReferredShape(label, shape) && own_name(shape) == name;
  }
  static bool find(const TDF_Label& in, const std::string& name, TDF_Label& found) {
    TDF_Label assembly = in;
    if (XCAFDoc_ShapeTool::IsReference(in)) XCAFDoc_ShapeTool::GetReferredShape(in, assembly);
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetComponents(assembly, parts);
    for (int i = 1; i <= parts.Length(); ++i) {
      found = parts.Value(i);
      if (is_called(found, name)) return true;
      if (const TDF_Label inside = found; find(inside, name, found)) return true;
    }
    return false;
  }
  TDF_Label instance(const std::string& name) const {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    TDF_Label found;
    for (int i = 1; i <= roots.Length(); ++i) {
      if (find(roots.Value(i), name, found)) return found;
    }
    ADD_FAILURE() << "no instance " << name;
    return found;
  }

  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
};

class Revisions : public test::CadTest {
 protected:
  static std::string sample(const std::string& name) {
    return std::string(BURIN_SOURCE_DIR) + "/samples/" + name;
  }

  Difference compared(const std::string& before, const std::string& after) {
    const Scene was = read(before), is = read(after);
    RunContext context;
    Diagnostics said;
    Difference d = compare_revisions(was, is, std::vector<bool>(was.parts.size(), true),
                                     std::vector<bool>(is.parts.size(), true), said, context);
    EXPECT_TRUE(said.empty());
    return d;
  }

  /// All but those that are the same.
  static std::map<std::string, PartChange> changes(const Difference& d) {
    std::map<std::string, PartChange> found;
    for (const PartDifference& part : d.parts) {
      if (part.change() == PartChange::Same) continue;
      found[part.after.empty() ? part.before : part.after] = part.change();
    }
    return found;
  }
};

TEST_F(Revisions, RewrittenByOcctInMmAndInchesIsTheSame) {
  for (const char* name : {"coupling.step", "gear_pump.step"}) {
    for (const char* unit : {"MM", "INCH"}) {
      Revised revised(sample(name));
      const Difference d = compared(sample(name), revised.write(folder_ / "b.step", unit));
      EXPECT_TRUE(d.same()) << name << " " << unit << ": " << changes(d).size();
      EXPECT_GT(d.parts.size(), 20U);
    }
  }
}

TEST_F(Revisions, OneBoltSetIsGone) {
  Revised revised(sample("coupling.step"));
  revised.remove("bolt set 4");
  const Difference d = compared(sample("coupling.step"), revised.write(folder_ / "b.step"));
  EXPECT_EQ(d.count(PartChange::Removed), 4U);
  EXPECT_EQ(d.count(PartChange::Removed) + d.count(PartChange::Same), d.parts.size());
  for (const auto& [path, change] : changes(d)) {
    EXPECT_NE(path.find("bolt set 4/"), std::string::npos) << path;
  }
}

TEST_F(Revisions, OnePartMovedOneTurnedOneDrilled) {
  Revised revised(sample("gear_pump.step"));
  gp_Trsf stay;
  revised.move("dowel 1", test::moved(0, 0, 25), stay);
  revised.drill("gear A", 0, 12, 2);
  const Difference d = compared(sample("gear_pump.step"), revised.write(folder_ / "b.step"));
  std::map<std::string, PartChange> found;
  for (const auto& [path, change] : changes(d)) found[path.substr(path.rfind('/') + 1)] = change;
  EXPECT_EQ(found.size(), 2U);
  for (const PartDifference& part : d.parts) {
    if (part.change() == PartChange::Moved) {
      EXPECT_EQ(part.after.substr(part.after.rfind('/') + 1), "dowel 1");
      EXPECT_NEAR(glm::distance(part.motion->by, Vec3(0, 0, 25)), 0, 1e-6);
    }
    if (part.change() == PartChange::Changed) {
      EXPECT_EQ(part.changes(), std::vector{PartChange::Changed});
      EXPECT_LT(part.numbers_after->volume, part.numbers_before->volume);
    }
  }
  EXPECT_EQ(d.count(PartChange::Moved), 1U);
  EXPECT_EQ(d.count(PartChange::Changed), 1U);
}

}  // namespace
}  // namespace burin
