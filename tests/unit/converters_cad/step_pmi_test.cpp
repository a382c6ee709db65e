// What a STEP file says of sizes, tolerances, datums and notes, and how it shows it.
#include "pmi/step_pmi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

/// Units, a product, and a context in inches.
constexpr const char* kHead =
    "DATA;\n"
    "#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#2=(CONVERSION_BASED_UNIT('inch',#3)LENGTH_UNIT()NAMED_UNIT(#9));\n"
    "#3=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#1);\n"
    "#4=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
    "#5=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#2,#4))"
    "REPRESENTATION_CONTEXT('',''));\n"
    "#6=PRODUCT_DEFINITION_SHAPE('','',#7);\n"
    "#10=SHAPE_ASPECT('','',#6,.T.);\n"
    "#11=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#10,#5,#12);\n"
    "#12=ADVANCED_FACE('',(),#5,.T.);\n";

StepPmi pmi_of(const std::string& body) {
  const std::string text = kHead + body;
  return read_step_pmi(StepText(text, RunContext()));
}

std::string size(const std::string& name, const std::string& value) {
  return "#20=DIMENSIONAL_SIZE(#10,'" + name +
         "');\n#21=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#20,#22);\n"
         "#22=SHAPE_DIMENSION_REPRESENTATION('',(" +
         value + "),#5);\n";
}

std::string measure(int number, const std::string& name, const std::string& value,
                    const std::string& unit = "#1", const std::string& more = "") {
  return "#" + std::to_string(number) +
         "=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()"
         "MEASURE_WITH_UNIT(LENGTH_MEASURE(" +
         value + ")," + unit + ")" + more + "REPRESENTATION_ITEM('" + name + "'));\n";
}

PmiItem only(const StepPmi& pmi) {
  EXPECT_EQ(pmi.items.size(), 1u);
  return pmi.items.empty() ? PmiItem() : pmi.items.front().item;
}

TEST(StepPmi, WritesSizesWithTheirDeviations) {
  const std::string range = "#30=PLUS_MINUS_TOLERANCE(#31,#20);\n#31=TOLERANCE_VALUE(#32,#33);\n";
  const StepPmi pmi = pmi_of(size("diameter", "#23") + measure(23, "nominal value", "35.") + range +
                             measure(32, "", "-0.2") + measure(33, "", "0."));
  const PmiItem item = only(pmi);
  EXPECT_EQ(item.kind, PmiKind::Dimension);
  EXPECT_EQ(item.text, "⌀ 35 +0/-0.2");
  EXPECT_EQ(item.value, 35);
  EXPECT_EQ(item.lower, -0.2);
  EXPECT_EQ(item.unit, "mm");
  EXPECT_EQ(pmi.items.front().faces, (std::vector<std::int64_t>{12}));
  EXPECT_EQ(pmi.items.front().product, 7);
}

TEST(StepPmi, WritesNumbersInTheUnitAndThePlacesOfTheFile) {
  const std::string format = "QUALIFIED_REPRESENTATION_ITEM((#40))";
  const std::string range =
      "#30=PLUS_MINUS_TOLERANCE(#31,#20);\n#31=TOLERANCE_VALUE(#32,#33);\n"
      "#40=VALUE_FORMAT_TYPE_QUALIFIER('NR2 1.3');\n";
  const PmiItem item =
      only(pmi_of(size("radius", "#23") + measure(23, "nominal value", "0.5", "#2", format) +
                  range + measure(32, "", "-0.01", "#2") + measure(33, "", "0.01", "#2")));
  EXPECT_EQ(item.text, "R 0.500 ±0.01 in");
  EXPECT_EQ(item.value, 0.5);
  EXPECT_EQ(item.unit, "in");
}

TEST(StepPmi, WritesLimitsFitsAndModifiers) {
  EXPECT_EQ(only(pmi_of(size("diameter", "#23,#24") + measure(23, "upper limit", "35.2") +
                        measure(24, "lower limit", "34.8")))
                .text,
            "⌀ 34.8 to 35.2");
  EXPECT_EQ(only(pmi_of(size("diameter", "#23") + measure(23, "nominal value", "20.") +
                        "#30=PLUS_MINUS_TOLERANCE(#31,#20);\n"
                        "#31=LIMITS_AND_FITS('H','','7','');\n"))
                .text,
            "⌀ 20 H7");
  EXPECT_EQ(only(pmi_of(size("spherical radius", "#23,#24") + measure(23, "nominal value", "2.") +
                        "#24=DESCRIPTIVE_REPRESENTATION_ITEM('dimensional note','square');\n"))
                .text,
            "SR 2 (square)");
  EXPECT_EQ(only(pmi_of("#20=DIMENSIONAL_LOCATION('linear distance',$,#10,#10);\n")).text,
            "linear distance without a value");
}

TEST(StepPmi, CountsAnglesInDegrees) {
  const PmiItem item = only(pmi_of(
      "#20=ANGULAR_LOCATION('angle',$,#10,#10,.EQUAL.);\n"
      "#21=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#20,#22);\n"
      "#22=SHAPE_DIMENSION_REPRESENTATION('',(#23),#5);\n"
      "#23=(MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE("
      "1.0471975511965976),#4)PLANE_ANGLE_MEASURE_WITH_UNIT()REPRESENTATION_ITEM('nominal value'));"
      "\n"));
  EXPECT_EQ(item.text, "angle 60°");
  EXPECT_NEAR(*item.value, 60, 1e-12);
}

/// Three datums and a system of them.
constexpr const char* kDatums =
    "#50=DATUM('',$,#6,.F.,'A');\n#51=DATUM('',$,#6,.F.,'B');\n#52=DATUM('',$,#6,.F.,'C');\n"
    "#53=DATUM_SYSTEM('',$,#6,.F.,(#54,#55));\n"
    "#54=DATUM_REFERENCE_COMPARTMENT('',$,#6,.F.,#50,$);\n"
    "#55=DATUM_REFERENCE_COMPARTMENT('',$,#6,.F.,COMMON_DATUM_LIST((#56,#57)),"
    "(SIMPLE_DATUM_REFERENCE_MODIFIER(.MAXIMUM_MATERIAL_REQUIREMENT.)));\n"
    "#56=DATUM_REFERENCE_ELEMENT('',$,#6,.F.,#51,$);\n"
    "#57=DATUM_REFERENCE_ELEMENT('',$,#6,.F.,#52,$);\n"
    "#58=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.75),#1);\n";

TEST(StepPmi, WritesTolerancesWithZoneModifiersAndDatums) {
  const PmiItem item = only(pmi_of(
      std::string(kDatums) +
      "#60=(GEOMETRIC_TOLERANCE('Position.1','',#58,#10)"
      "GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#53))"
      "GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.MAXIMUM_MATERIAL_REQUIREMENT.))POSITION_TOLERANCE());\n"
      "#61=TOLERANCE_ZONE('',$,#6,.F.,(#60),#62);\n"
      "#62=TOLERANCE_ZONE_FORM('cylindrical or circular');\n"));
  EXPECT_EQ(item.kind, PmiKind::Tolerance);
  EXPECT_EQ(item.what, "position");
  EXPECT_EQ(item.text, "position ⌀ 0.75 (M) | A | B-C (M)");
  EXPECT_EQ(item.datums, (std::vector<std::string>{"A", "B-C (M)"}));
  EXPECT_EQ(item.modifiers, (std::vector<std::string>{"maximum material requirement"}));
}

TEST(StepPmi, KnowsTolerancesOfOneTypeAndThoseThatAreUneven) {
  EXPECT_EQ(
      only(pmi_of(std::string(kDatums) + "#60=PERPENDICULARITY_TOLERANCE('','',#58,#10,(#53));\n"))
          .text,
      "perpendicularity 0.75 | A | B-C (M)");
  EXPECT_EQ(only(pmi_of(std::string(kDatums) +
                        "#60=(GEOMETRIC_TOLERANCE('','',#58,#10)SURFACE_PROFILE_TOLERANCE()"
                        "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE(#58));\n"))
                .text,
            "surface profile 0.75 (U) 0.75");
}

TEST(StepPmi, NamesDatumsAndTargets) {
  const StepPmi pmi = pmi_of(std::string(kDatums) +
                             "#60=DATUM_FEATURE('Datum.1',$,#6,.T.);\n"
                             "#61=SHAPE_ASPECT_RELATIONSHIP('','',#60,#51);\n"
                             "#62=PLACED_DATUM_TARGET_FEATURE('','point',#6,.T.,'2');\n"
                             "#63=SHAPE_ASPECT_RELATIONSHIP('','',#62,#50);\n");
  ASSERT_EQ(pmi.items.size(), 2u);
  EXPECT_EQ(pmi.items[0].item.text, "B");
  EXPECT_EQ(pmi.items[0].item.kind, PmiKind::Datum);
  EXPECT_EQ(pmi.items[1].item.text, "A2 (point)");
  EXPECT_EQ(pmi.items[1].item.kind, PmiKind::DatumTarget);
}

/// A callout with a line and two triangles that make a square, on a plane at z = 2 inches, turned
/// a quarter about z; and the view that shows it.
constexpr const char* kShown =
    "#70=(DRAUGHTING_MODEL()REPRESENTATION('',(#71,#72,#73),#5));\n"
    "#71=CAMERA_MODEL_D3('View 1',#90,$);\n"
    "#72=DRAUGHTING_CALLOUT('Size.1',(#74,#75));\n"
    "#73=ANNOTATION_PLANE('',(),#76,(#72));\n"
    "#74=TESSELLATED_ANNOTATION_OCCURRENCE('',(),#77);\n"
    "#75=ANNOTATION_PLACEHOLDER_OCCURRENCE('',(),#77,.GPS_DATA.,1.);\n"
    "#76=PLANE('',#78);\n"
    "#77=(GEOMETRIC_REPRESENTATION_ITEM()REPOSITIONED_TESSELLATED_ITEM(#78)"
    "REPRESENTATION_ITEM('')TESSELLATED_GEOMETRIC_SET((#79,#80))TESSELLATED_ITEM());\n"
    "#78=AXIS2_PLACEMENT_3D('',#81,#82,#83);\n"
    "#79=TESSELLATED_CURVE_SET('',#84,((1,2),(2,3,4,2)));\n"
    "#80=COMPLEX_TRIANGULATED_SURFACE_SET('',#84,4,((0.,0.,1.)),(),((1,2,4,3)),());\n"
    "#81=CARTESIAN_POINT('',(0.,0.,2.));\n#82=DIRECTION('',(0.,0.,1.));\n"
    "#83=DIRECTION('',(0.,1.,0.));\n"
    "#84=COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(1.,1.,0.),(0.,1.,0.)));\n"
    "#90=AXIS2_PLACEMENT_3D('',#91,#92,#93);\n#91=CARTESIAN_POINT('',(0.,0.,9.));\n"
    "#92=DIRECTION('',(0.,0.,-1.));\n#93=DIRECTION('',(-1.,0.,0.));\n";

TEST(StepPmi, PutsWhatIsShownInMillimetresOfThePart) {
  const StepPmi pmi = pmi_of(
      size("diameter", "#23") + measure(23, "nominal value", "35.") + kShown +
      "#95=DRAUGHTING_MODEL_ITEM_ASSOCIATION('PMI representation to presentation link','',#20,#70,"
      "#72);\n");
  const PmiItem item = only(pmi);
  EXPECT_EQ(item.name, "Size.1");
  EXPECT_EQ(item.views, (std::vector<std::string>{"View 1"}));
  ASSERT_EQ(item.lines.size(), 2u);
  EXPECT_FALSE(item.lines[0].closed);
  EXPECT_TRUE(item.lines[1].closed);
  EXPECT_EQ(item.lines[1].points.size(), 3u);
  EXPECT_NEAR(glm::distance(item.lines[0].points[1], Vec3(0, 25.4, 50.8)), 0, 1e-12);
  // The diagonal of the square is no edge of it.
  ASSERT_EQ(item.filled.size(), 1u);
  EXPECT_EQ(item.filled[0].points.size(), 4u);
  ASSERT_TRUE(item.plane);
  EXPECT_EQ(item.plane->normal, Vec3(0, 0, 1));
  EXPECT_EQ(item.plane->along, Vec3(0, 1, 0));
  ASSERT_EQ(pmi.views.size(), 1u);
  EXPECT_EQ(pmi.views[0].to_viewer, Vec3(0, 0, 1));
  EXPECT_EQ(pmi.views[0].up, Vec3(0, 1, 0));
  EXPECT_TRUE(pmi.unknown.empty());
}

TEST(StepPmi, GivesACalloutThatStatesNothingItsWords) {
  const std::string note =
      "#20=PROPERTY_DEFINITION('semantic text','',#10);\n"
      "#21=PROPERTY_DEFINITION_REPRESENTATION(#20,#22);\n"
      "#22=REPRESENTATION('',(#23,#24,#25),#5);\n"
      "#23=DESCRIPTIVE_REPRESENTATION_ITEM('','2X #{diameter}5');\n"
      "#24=DESCRIPTIVE_REPRESENTATION_ITEM('','/n');\n"
      "#25=DESCRIPTIVE_REPRESENTATION_ITEM('','  THRU');\n"
      "#95=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#20,#70,#72);\n";
  const PmiItem item = only(pmi_of(note + kShown));
  EXPECT_EQ(item.kind, PmiKind::Note);
  EXPECT_EQ(item.text, "2X ⌀5 THRU");
  const PmiItem alone = only(pmi_of(kShown));
  EXPECT_EQ(alone.kind, PmiKind::Other);
  EXPECT_EQ(alone.text, "Size.1");
}

TEST(StepPmi, SharesOneFrameOfTwoTolerances) {
  const StepPmi pmi =
      pmi_of(std::string(kDatums) + kShown +
             "#60=FLATNESS_TOLERANCE('','',#58,#10);\n#61=FLATNESS_TOLERANCE('','',#58,#10);\n"
             "#62=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite','',#60,#61);\n"
             "#95=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#60,#70,#72);\n");
  ASSERT_EQ(pmi.items.size(), 2u);
  EXPECT_TRUE(pmi.items[0].item.shown());
  EXPECT_FALSE(pmi.items[1].item.shown());
  EXPECT_EQ(pmi.items[1].item.shown_with, 0);
}

TEST(StepPmi, DrawsPolylinesAndArcsAndNamesOtherCurves) {
  const StepPmi pmi = pmi_of(
      "#70=DRAUGHTING_CALLOUT('Note',(#71));\n#71=ANNOTATION_CURVE_OCCURRENCE('',(),#72);\n"
      "#72=GEOMETRIC_CURVE_SET('',(#73,#74,#75));\n#73=POLYLINE('',(#80,#81));\n"
      "#74=TRIMMED_CURVE('',#76,(#81),(#82),.T.,.CARTESIAN.);\n#75=OFFSET_CURVE_3D('');\n"
      "#76=CIRCLE('',#77,1.);\n#77=AXIS2_PLACEMENT_3D('',#80,$,$);\n"
      "#80=CARTESIAN_POINT('',(0.,0.,0.));\n#81=CARTESIAN_POINT('',(1.,0.,0.));\n"
      "#82=CARTESIAN_POINT('',(0.,1.,0.));\n");
  const PmiItem item = only(pmi);
  ASSERT_EQ(item.lines.size(), 2u);
  for (const Vec3& point : item.lines[1].points) {
    EXPECT_NEAR(glm::length(point), 1, 1e-12);
    EXPECT_GE(point.x, -1e-12);
  }
  EXPECT_NEAR(glm::distance(item.lines[1].points.back(), Vec3(0, 1, 0)), 0, 1e-12);
  EXPECT_EQ(pmi.unknown, (std::map<std::string, std::int64_t>{{"OFFSET_CURVE_3D", 1}}));
}

TEST(StepPmi, EndsInWhatGoesRound) {
  const StepPmi pmi = pmi_of(
      "#20=DIMENSIONAL_SIZE(#21,'diameter');\n#21=COMPOSITE_SHAPE_ASPECT('','',#6,.T.);\n"
      "#22=SHAPE_ASPECT_RELATIONSHIP('','',#21,#21);\n"
      "#23=DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#20,#24);\n"
      "#24=REPRESENTATION('',(#24),#5);\n"
      "#70=DRAUGHTING_CALLOUT('Note',(#70,#71));\n#71=COMPOSITE_CURVE('',(#72),.F.);\n"
      "#72=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#71);\n"
      "#73=(CONVERSION_BASED_UNIT('x',#74)NAMED_UNIT(*));\n"
      "#74=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.),#73);\n"
      "#75=FLATNESS_TOLERANCE('','',#74,#10);\n");
  EXPECT_EQ(pmi.items.size(), 2u);
}

}  // namespace
}  // namespace burin
