#pragma once
/// CAD files written by OCCT into a folder that goes with the test.

#include <burin/converters/cad_reader.h>

#include <Quantity_Color.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <burin_test/folder.h>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace burin::test {

TopoDS_Shape solid_box(double dx, double dy, double dz);
TopoDS_Shape solid_sphere(double radius);
/// Boxes of 1 x 1 x 1, 2 x 1 x 1, ... mm, each 10 mm beside the one before, as one compound.
TopoDS_Shape boxes_in_a_row(int count);
gp_Trsf moved(double x, double y, double z);
/// Turned about the z axis.
gp_Trsf turned(double degrees);

/// A document of named, coloured shapes and assemblies.
class CadDocument {
 public:
  CadDocument();
  /// A part; `hex` is its colour as "#rrggbb".
  TDF_Label part(const TopoDS_Shape& shape, const std::string& name, const std::string& hex = {});
  TDF_Label assembly(const std::string& name);
  TDF_Label use(const TDF_Label& assembly, const TDF_Label& what, const gp_Trsf& place,
                const std::string& name);
  void color(const TDF_Label& label, const std::string& hex, double opacity = 1);
  /// Of a shape inside a part: a solid or a face.
  void color(const TDF_Label& part, const TopoDS_Shape& inside, const std::string& hex,
             double opacity = 1);

  std::string step(const std::string& file) const;
  /// The assembly alone; its parts in files of their own beside it, "part_NAME.stp".
  std::string step_in_files(const std::string& file) const;
  std::string iges(const std::string& file) const;

 private:
  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
};

/// A folder, and reading what stands in it.
class CadTest : public ::testing::Test {
 protected:
  Scene read(const std::string& path);
  FileInfo inspect(const std::string& path);
  /// The message of the InputError that reading the file throws; empty where it throws none.
  std::string error_of(const std::string& path);
  /// Writes `text` with the first or all occurrences of `what` changed.
  std::string changed(const std::string& path, const std::string& what, const std::string& into,
                      const std::string& name);
  Folder folder_;
};

void expect_box(const Box3& box, Vec3 low, Vec3 high, double slack = 1e-6);
std::int64_t count_of(const Diagnostics& diagnostics, const std::string& code);

}  // namespace burin::test
