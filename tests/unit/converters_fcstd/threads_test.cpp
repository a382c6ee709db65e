// Threads of the holes of a document that FreeCAD makes.
#include <burin/arrange/arrange.h>
#include <burin/threads/metric.h>

#include "writing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace burin::test {
namespace {

/// A plate of 60 x 40 x 20 that stands upright, with holes from its upper side: two of M6 all
/// through, one of M10 that is 14 deep and has a thread of 10, one of M8x1, one of 1/4 UNC with a
/// countersink, one whose thread is modelled, and one without any.
constexpr const char* kMakeHoles = R"(import FreeCAD, Part, os
from FreeCAD import Vector as V
try:
    doc = FreeCAD.newDocument("plate")
    body = doc.addObject("PartDesign::Body", "Body")
    body.Placement = FreeCAD.Placement(V(7, 8, 9), FreeCAD.Rotation(V(1, 0, 0), 90))
    box = doc.addObject("PartDesign::AdditiveBox", "Box")
    body.addObject(box)
    box.Length, box.Width, box.Height = 60, 40, 20
    doc.recompute()
    def hole(name, circles, **keys):
        sketch = doc.addObject("Sketcher::SketchObject", "Sketch" + name)
        body.addObject(sketch)
        sketch.Support = (box, ["Face6"])
        sketch.MapMode = "FlatFace"
        for x, y, construction in circles:
            sketch.addGeometry(Part.Circle(V(x, y, 0), V(0, 0, 1), 3), construction)
        doc.recompute()
        made = doc.addObject("PartDesign::Hole", name)
        body.addObject(made)
        made.Profile = sketch
        for key, value in keys.items():
            setattr(made, key, value)
            doc.recompute()
    iso = dict(Threaded=True, ThreadType="ISOMetricProfile")
    hole("M6", [(10, 10, False), (10, 30, False), (20, 20, True)], **iso, ThreadSize="M6", DepthType="ThroughAll")
    hole("M10", [(30, 10, False)], **iso, ThreadSize="M10", DepthType="Dimension", Depth=14, ThreadDepthType="Dimension", ThreadDepth=10)
    hole("Fine", [(30, 30, False)], Threaded=True, ThreadType="ISOMetricFineProfile", ThreadSize="M8x1.0", DepthType="ThroughAll")
    hole("Inch", [(50, 10, False)], Threaded=True, ThreadType="UNC", ThreadSize="1/4", DepthType="ThroughAll",
         HoleCutType="Countersink", HoleCutDiameter=10)
    hole("Plain", [(50, 30, False)], DepthType="ThroughAll", Diameter=5)
    doc.saveAs(os.environ["BURIN_TEST_OUT"])
finally:
    os._exit(0)
)";

class HolesTest : public FcstdTest {
 protected:
  void SetUp() override {
    FcstdTest::SetUp();
    if (std::system("command -v freecadcmd >/dev/null") != 0) {
      GTEST_SKIP() << "freecadcmd is not installed (package freecad)";
    }
    const std::string file = folder_.write("make_holes.py", this->script());
    document_ = folder_ / "plate.FCStd";
    ::setenv("BURIN_TEST_OUT", document_.c_str(), 1);
    ::setenv("FREECAD_USER_HOME", folder_.path().c_str(), 1);
    std::system(("timeout 100 freecadcmd " + file + " >/dev/null 2>&1").c_str());
  }
  virtual const char* script() const { return kMakeHoles; }
  /// Those of a designation.
  static std::vector<Thread> threads(const Scene& scene, const std::string& designation) {
    std::vector<Thread> out = scene.parts.at(0).threads;
    std::erase_if(out, [&](const Thread& t) { return t.designation != designation; });
    return out;
  }
  std::string document_;
};

TEST_F(HolesTest, HaveTheThreadsThatTheDocumentSays) {
  RunContext context;
  const Scene scene = read_fcstd(document_, {}, context);
  ASSERT_EQ(scene.parts.size(), 1U);
  EXPECT_EQ(scene.parts[0].threads.size(), 5U);
  const auto m6 = threads(scene, "M6"), m10 = threads(scene, "M10"), fine = threads(scene, "M8x1"),
             inch = threads(scene, "1/4-20 UNC");
  ASSERT_EQ(m6.size(), 2U);
  ASSERT_EQ(m10.size(), 1U);
  ASSERT_EQ(fine.size(), 1U);
  ASSERT_EQ(inch.size(), 1U);
  EXPECT_NEAR(m6[0].major, 3, 1e-9);
  EXPECT_NEAR(m6[0].minor, 0.5 * minor_diameter(6, 1), 1e-9);
  EXPECT_NEAR(fine[0].minor, 0.5 * minor_diameter(8, 1), 1e-9);
  EXPECT_NEAR(inch[0].major, 3.175, 1e-9);
  EXPECT_NEAR(m10[0].end - m10[0].begin, 10, 1e-9);
  // (30, 10, 20) of the body, whose z is -y of the document.
  EXPECT_LT(glm::distance(m10[0].axis.point, Vec3(37, -12, 19)), 1e-9);
  EXPECT_LT(glm::distance(m10[0].axis.along, Vec3(0, 1, 0)), 1e-9);
}

/// A plate of 100 x 100 x 10 with tapped holes of M4: each in another pattern.
constexpr const char* kMakePatterns = R"(import FreeCAD, Part, os
from FreeCAD import Vector as V
try:
    doc = FreeCAD.newDocument("plate")
    body = doc.addObject("PartDesign::Body", "Body")
    box = doc.addObject("PartDesign::AdditiveBox", "Box")
    body.addObject(box)
    box.Length, box.Width, box.Height = 100, 100, 10
    doc.recompute()
    def hole(name, x, y):
        sketch = doc.addObject("Sketcher::SketchObject", "Sketch" + name)
        body.addObject(sketch)
        sketch.Support = (box, ["Face6"])
        sketch.MapMode = "FlatFace"
        sketch.addGeometry(Part.Circle(V(x, y, 0), V(0, 0, 1), 2), False)
        doc.recompute()
        made = doc.addObject("PartDesign::Hole", name)
        body.addObject(made)
        made.Profile = sketch
        for key, value in dict(Threaded=True, ThreadType="ISOMetricProfile", ThreadSize="M4", DepthType="ThroughAll").items():
            setattr(made, key, value)
            doc.recompute()
        return made, sketch
    def pattern(kind, originals, **keys):
        made = doc.addObject("PartDesign::" + kind, kind)
        body.addObject(made)
        made.Originals = originals
        for key, value in keys.items():
            setattr(made, key, value)
        body.Tip = made
        doc.recompute()
        return made
    one, sketch = hole("Row", 10, 10)
    pattern("LinearPattern", [one], Direction=(sketch, ["H_Axis"]), Length=60, Occurrences=4)
    two, sketch = hole("Mirrored", 30, 90)
    axis = [o for o in body.Origin.OriginFeatures if o.Name.startswith("YZ_Plane")][0]
    datum = doc.addObject("PartDesign::Plane", "Middle")
    body.addObject(datum)
    datum.Placement = FreeCAD.Placement(V(50, 0, 0), FreeCAD.Rotation(V(0, 1, 0), 90))
    pattern("Mirrored", [two], MirrorPlane=(datum, [""]))
    three, sketch = hole("Ring", 70, 50)
    centre = doc.addObject("Sketcher::SketchObject", "Centre")
    body.addObject(centre)
    centre.Placement = FreeCAD.Placement(V(50, 50, 10), FreeCAD.Rotation())
    pattern("PolarPattern", [three], Axis=(centre, ["N_Axis"]), Angle=360, Occurrences=5)
    four, sketch = hole("Edge", 90, 20)
    pattern("LinearPattern", [four], Direction=(box, ["Edge8"]), Length=20, Occurrences=2)
    doc.saveAs(os.environ["BURIN_TEST_OUT"])
finally:
    os._exit(0)
)";

class PatternsTest : public HolesTest {
 protected:
  const char* script() const override { return kMakePatterns; }
};

TEST_F(PatternsTest, RepeatTheThreadsOfTheirHoles) {
  RunContext context;
  Scene scene = read_fcstd(document_, {}, context);
  ASSERT_EQ(scene.parts.size(), 1U);
  std::vector<Vec2> at;
  for (const Thread& thread : scene.parts[0].threads) at.emplace_back(thread.axis.point);
  const auto has = [&](Vec2 p) {
    return std::ranges::any_of(at, [&](Vec2 q) { return glm::distance(p, q) < 1e-6; });
  };
  EXPECT_EQ(at.size(), 4U + 2U + 5U + 1U);
  for (const double x : {10.0, 30.0, 50.0, 70.0}) EXPECT_TRUE(has({x, 10})) << x;
  EXPECT_TRUE(has({30, 90}));
  EXPECT_TRUE(has({70, 90}));
  for (int k = 0; k < 5; ++k) {
    const double a = 2 * std::numbers::pi * k / 5;
    EXPECT_TRUE(has({50 + 20 * std::cos(a), 50 + 20 * std::sin(a)})) << k;
  }
  const auto& told = scene.diagnostics.entries();
  EXPECT_TRUE(std::ranges::any_of(
      told, [](const Diagnostic& d) { return d.code == "fcstd.thread_pattern"; }));
  // All of them are on cylinders of the shape.
  Illustration illustration;
  arrange_parts(scene, illustration, context);
  EXPECT_EQ(scene.parts[0].threads.size(), 12U);
  for (const Thread& thread : scene.parts[0].threads) EXPECT_GE(thread.face, 0);
}

TEST_F(HolesTest, AreFoundOnTheShape) {
  RunContext context;
  Scene scene = read_fcstd(document_, {}, context);
  Illustration illustration;
  arrange_parts(scene, illustration, context);
  ASSERT_EQ(scene.parts[0].threads.size(), 5U);
  for (const Thread& thread : scene.parts[0].threads) {
    EXPECT_GE(thread.face, 0) << thread.designation;
    const int open = (thread.open_begin ? 1 : 0) + (thread.open_end ? 1 : 0);
    EXPECT_EQ(open, thread.designation == "M10" ? 1 : 2) << thread.designation;
    const double length = thread.end - thread.begin;
    // That of the inch thread begins in the countersink, of 82 degrees.
    if (thread.designation == "M10") {
      EXPECT_NEAR(length, 10, 1e-6);
    }
    if (thread.designation == "M6") {
      EXPECT_NEAR(length, 20, 1e-6);
    }
    if (thread.designation == "1/4-20 UNC") {
      EXPECT_NEAR(length, 20 - (5 - 3.175) / std::tan(41 * std::numbers::pi / 180), 1e-6);
    }
  }
  const auto& said = scene.diagnostics.entries();
  EXPECT_TRUE(std::ranges::none_of(
      said, [](const Diagnostic& one) { return one.code.starts_with("threads."); }));
}

}  // namespace
}  // namespace burin::test
