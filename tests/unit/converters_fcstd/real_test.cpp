// Real documents against FreeCAD itself: what is visible, and its box.
#include "writing.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

namespace burin::test {
namespace {

/// For each document a line with its path, then for each visible shape its box and its label.
constexpr const char* kScript = R"(import FreeCAD, os, zipfile
import xml.etree.ElementTree as ET
out = open(os.environ["BURIN_TEST_OUT"], "w")
def visibility(path):
    shown = {}
    with zipfile.ZipFile(path) as z:
        if "GuiDocument.xml" in z.namelist():
            for v in ET.fromstring(z.read("GuiDocument.xml")).iter("ViewProvider"):
                for p in v.iter("Property"):
                    if p.get("name") == "Visibility":
                        shown[v.get("name")] = p[0].get("value") == "true"
    return shown
def tell(path):
    document = FreeCAD.openDocument(path)
    shown = visibility(path)
    inside = {c.Name for o in document.Objects if o.isDerivedFrom("PartDesign::Body") for c in o.Group}
    print("F", path, file=out)
    for o in document.Objects:
        shape = getattr(o, "Shape", None)
        if o.Name in inside or not shown.get(o.Name, o.Visibility): continue
        if shape is None or shape.isNull() or not shape.Faces: continue
        b = shape.optimalBoundingBox()
        print("S", b.XMin, b.YMin, b.ZMin, b.XMax, b.YMax, b.ZMax, o.Label, file=out)
    FreeCAD.closeDocument(document.Name)
try:
    for folder, _, names in sorted(os.walk(os.environ["BURIN_TEST_IN"])):
        for name in sorted(names):
            if name.lower().endswith(".fcstd"): tell(os.path.join(folder, name))
    out.close()
finally:
    os._exit(0)
)";

TEST_F(FcstdTest, RealDocumentsStandWhereFreecadPutsThem) {
  const std::filesystem::path data = std::filesystem::path(BURIN_TEST_DATA) / "fcstd";
  if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "no " << data;
  if (std::system("command -v freecadcmd >/dev/null") != 0) {
    GTEST_SKIP() << "freecadcmd is not installed (package freecad)";
  }
  const std::string script = folder_.write("tell_boxes.py", kScript), out = folder_ / "boxes";
  ::setenv("BURIN_TEST_OUT", out.c_str(), 1);
  ::setenv("BURIN_TEST_IN", data.c_str(), 1);
  ::setenv("FREECAD_USER_HOME", folder_.path().c_str(), 1);
  std::system(("timeout 200 freecadcmd " + script + " >/dev/null 2>&1").c_str());
  std::map<std::string, std::map<std::string, Box3>> reported;
  std::ifstream in(out);
  std::string line, file;
  while (std::getline(in, line)) {
    if (line.starts_with("F ")) {
      file = line.substr(2);
      reported[file];
      continue;
    }
    std::istringstream row(line.substr(2));
    Box3 box;
    row >> box.min.x >> box.min.y >> box.min.z >> box.max.x >> box.max.y >> box.max.z >> std::ws;
    std::string label;
    std::getline(row, label);
    reported[file][label] = box;
  }
  EXPECT_GE(reported.size(), 20u);
  for (const auto& [path, shapes] : reported) {
    RunContext context;
    if (shapes.empty()) {
      EXPECT_THROW(read_fcstd(path, {}, context), InputError) << path;
      continue;
    }
    const Scene scene = read_fcstd(path, {}, context);
    EXPECT_EQ(scene.parts.size(), shapes.size()) << path;
    for (const Part& part : scene.parts) {
      ASSERT_EQ(shapes.count(part.name), 1u) << path << " " << part.name;
      const Box3 want = shapes.at(part.name), have = box_of(part);
      // FreeCAD's boxes are as good as its tolerance.
      const double near = 1e-5 * glm::length(want.max - want.min);
      EXPECT_LT(glm::length(want.min - have.min), near) << path << " " << part.name;
      EXPECT_LT(glm::length(want.max - have.max), near) << path << " " << part.name;
    }
  }
}

}  // namespace
}  // namespace burin::test
