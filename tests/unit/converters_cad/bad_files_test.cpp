// Broken files: one error that says what to do, or what was left out.
#include <burin/base/error.h>

#include "cad_files.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools.hxx>
#include <Standard_Version.hxx>
#include <burin_test/shapes.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <random>
#include <regex>
#include <thread>

namespace burin {
namespace {

using test::CadDocument;

class BadFiles : public test::CadTest {
 protected:
  std::string box_step() {
    CadDocument document;
    document.part(test::solid_box(3, 4, 5), "box");
    document.part(test::solid_sphere(2), "ball");
    return document.step(folder_ / "box.step");
  }
  void expect_error(const std::string& path, const std::string& part) {
    const std::string message = error_of(path);
    EXPECT_NE(message.find(part), std::string::npos) << path << ": '" << message << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
};

TEST_F(BadFiles, ErrorsSayWhatToDo) {
  expect_error(folder_ / "none.step", "check the path");
  expect_error(folder_.write("empty.step", ""), "empty");
  std::filesystem::create_directory(folder_ / "folder.step");
  expect_error(folder_ / "folder.step", "folder");
  expect_error(folder_.write("rubbish.step", std::string("\1\2\0\3rubbish", 11)), "ISO-10303-21");
  expect_error(folder_.write("rubbish.igs", "rubbish"), "IGES");
  expect_error(folder_.write("rubbish.brep", "rubbish"), "BREP");
  expect_error(folder_.write("head.step", "ISO-10303-21;\nHEADER;\n"), "export the model again");
  expect_error(folder_.write("nothing.step",
                             "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                             "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('CONFIG_CONTROL_"
                             "DESIGN'));\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n"
                             "ENDSEC;\nEND-ISO-10303-21;\n"),
               "no faces");
  expect_error(
      changed(box_step(), "CARTESIAN_POINT('',(", "CARTESIAN_POINT('',(1.E300+", "far.step"),
      "export the model again");
}

/// Entities from #9001 on: two bodies of AP242's triangles, the second of them double of `exact`.
std::string tessellated(const std::string& exact) {
  return "#9001=COORDINATES_LIST('',4,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.),(0.,0.,1.)));\n"
         "#9002=TRIANGULATED_FACE('',#9001,4,((0.,0.,1.)),$,(),((1,3,2),(1,2,4)));\n"
         "#9003=COMPLEX_TRIANGULATED_FACE('',#9001,4,((0.,0.,1.)),$,(),((1,4,3)),());\n"
         "#9004=TESSELLATED_SOLID('',(#9002,#9003),$);\n"
         "#9005=TESSELLATED_SHELL('',(#9002)," +
         exact + ");\n";
}

TEST_F(BadFiles, TrianglesInPlaceOfSurfacesAreTold) {
  const std::string text = test::slurp(box_step());
  const auto with = [&](const std::string& entities) {
    std::string all = text;
    all.insert(all.rfind("ENDSEC;"), entities);
    return folder_.write("with.step", all);
  };
  const Scene scene = read(with(tessellated("#1")));
  EXPECT_EQ(scene.parts.size(), 2u);
  // OCCT 7.8 knows them. These belong to no product.
  constexpr bool kRead = OCC_VERSION_HEX >= 0x070700;
  EXPECT_EQ(test::count_of(scene.diagnostics, "step.tessellated"), kRead ? 0 : 1);
  EXPECT_EQ(test::count_of(read(with(tessellated("$"))).diagnostics, "step.tessellated"),
            kRead ? 0 : 2);

  const std::string only =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
      "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING"
      "_MIM_LF'));\nENDSEC;\nDATA;\n" +
      tessellated("$") +
      "#1=APPLICATION_CONTEXT('managed model based 3d engineering');\n"
      "#2=PRODUCT_CONTEXT('',#1,'mechanical');\n#3=PRODUCT('part','part','',(#2));\n"
      "#4=PRODUCT_DEFINITION_FORMATION('','',#3);\n"
      "#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"
      "#6=PRODUCT_DEFINITION('design','',#4,#5);\n#7=PRODUCT_DEFINITION_SHAPE('','',#6);\n"
      "#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);\n"
      "#9=TESSELLATED_SHAPE_REPRESENTATION('',(#9004,#9005),#10);\n"
      "#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))"
      "REPRESENTATION_CONTEXT('',''));\n"
      "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
      "#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
      "#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
      "ENDSEC;\nEND-ISO-10303-21;\n";
  const std::string file = folder_.write("only.step", only);
  if (kRead) {
    const Scene triangles = read(file);
    ASSERT_EQ(triangles.parts.size(), 1u);
    test::expect_box(triangles.parts[0].form->bounds(Mat3(1)), {0, 0, 0}, {1, 1, 1});
  } else {
    expect_error(file, "holds tessellated geometry only (triangles of AP242: 2 bodies, 2 faces)");
  }
}

TEST_F(BadFiles, ErrorsOfSyntaxNameTheLine) {
  const std::string file = folder_.write("line.step",
                                         "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('X'));\nENDSEC;"
                                         "\nDATA;\n#1=CARTESIAN_POINT('',(1.,2.,3.);\n"
                                         "ENDSEC;\nEND-ISO-10303-21;\n");
  try {
    read(file);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_EQ(e.line(), 6);
  }
}

TEST_F(BadFiles, WhatStandsBeforeACutIsRead) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "first");
  document.part(test::solid_sphere(2), "second");
  const std::string text = test::slurp(document.step(folder_ / "two.step"));
  const std::size_t middle = text.find("'second'");
  ASSERT_NE(middle, std::string::npos);
  const Scene scene = read(folder_.write("cut.step", text.substr(0, middle)));
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "first");
  EXPECT_EQ(test::count_of(scene.diagnostics, "step.truncated"), 1);
  const auto cut = text.begin() + static_cast<std::ptrdiff_t>(middle);
  const std::string line = fmt::format("in line {};", 1 + std::count(text.begin(), cut, '\n'));
  EXPECT_NE(scene.diagnostics.entries()[0].message.find(line), std::string::npos)
      << scene.diagnostics.entries()[0].message;
}

TEST_F(BadFiles, ACutBeforeAnyFaceIsWhatIsSaid) {
  const std::string text = test::slurp(box_step());
  for (const std::size_t end : {text.find("DATA;") + 60, text.find("ADVANCED_FACE") + 60}) {
    expect_error(folder_.write("cut.step", text.substr(0, end)), "the file ends early");
  }
}

TEST_F(BadFiles, AByteOrderMarkIsNoFault) {
  const std::string text = test::slurp(box_step());
  const Scene scene = read(folder_.write("mark.step", "\xef\xbb\xbf" + text));
  EXPECT_EQ(scene.parts.size(), read(folder_.write("plain.step", text)).parts.size());
  EXPECT_TRUE(scene.diagnostics.empty());
}

TEST_F(BadFiles, OtherFilesWithThatSuffixAreCalledWhatTheyAre) {
  expect_error(folder_.write("a.step", "\xff\xfeI"), "UTF-16");
  expect_error(folder_.write("b.step", "version https://git-lfs.github.com/spec/v1\n"), "Git LFS");
  expect_error(folder_.write("c.step", "<!DOCTYPE html><html>"), "web page");
  expect_error(folder_.write("d.iges", "PK\x03\x04 rest"), "zip archive");
}

TEST_F(BadFiles, AbsurdKnotsAreRefused) {
  // Splines, whose weights make them entities of another kind than those without.
  CadDocument document;
  document.part(BRepBuilderAPI_NurbsConvert(test::solid_sphere(2)).Shape(), "ball");
  document.part(BRepBuilderAPI_NurbsConvert(test::solid_box(3, 4, 5)).Shape(), "box");
  const std::string text = test::slurp(document.step(folder_ / "splines.step"));
  ASSERT_EQ(read(folder_ / "splines.step").parts.size(), 2u);
  // Of each list of knots, which stands before their kind: no reference to an entity.
  const std::regex last_knot(R"([(,]\s*([0-9.E+-]+)(?=\)\s*,\s*\.[A-Z_]+\.\s*\)))");
  int tried = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), last_knot), end; it != end; ++it) {
    std::string changed = text;
    changed.replace(static_cast<std::size_t>(it->position(1)), it->str(1).size(), "1.E308");
    expect_error(folder_.write("knot.step", changed), "with the knot");
    ++tried;
  }
  EXPECT_GT(tried, 6);
}

TEST_F(BadFiles, AnEdgeThatIsMadeOfItselfIsRefused) {
  // OCCT follows it until the stack ends.
  std::string text = test::slurp(box_step());
  const std::regex edge(R"(#(\d+) = ORIENTED_EDGE\('',\*,\*,#(\d+),)");
  text = std::regex_replace(text, edge, "#$1 = ORIENTED_EDGE('',*,*,#$1,");
  expect_error(folder_.write("loop.step", text), "export the model again");
  // And the next file is read as ever.
  EXPECT_EQ(read(folder_ / "box.step").parts.size(), 2u);
}

TEST_F(BadFiles, EntitiesOfOneNumberAreTold) {
  // OCCT goes round for ever where the first line after these is another's.
  const std::string text = test::slurp(box_step());
  const std::regex plane(R"(#(\d+) = PLANE\()");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, plane));
  const std::string twice = fmt::format(
      "#{0} = CARTESIAN_POINT('',(9.,9.,9.));\n#{0}\t= PLANE('#{0}=x',#{0});\nENDSEC;\n"
      "END-ISO",
      found[1].str());
  const Scene scene = read(changed(folder_ / "box.step", "ENDSEC;\nEND-ISO", twice, "twice.step"));
  ASSERT_EQ(scene.parts.size(), 2u);
  const auto reported =
      std::ranges::find(scene.diagnostics.entries(), "step.same_number", &Diagnostic::code);
  ASSERT_NE(reported, scene.diagnostics.entries().end());
  EXPECT_EQ(reported->count, 2);
  EXPECT_NE(reported->message.find("#" + found[1].str()), std::string::npos) << reported->message;
}

TEST_F(BadFiles, NumbersInNamesAreNames) {
  CadDocument document;
  document.part(test::solid_box(3, 4, 5), "bolt #12=M6, it's");
  const Scene scene = read(document.step(folder_ / "name.step"));
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "bolt #12=M6, it's");
  EXPECT_EQ(test::count_of(scene.diagnostics, "step.same_number"), 0);
}

TEST_F(BadFiles, NumbersBeyond32BitsAreRead) {
  std::string text = test::slurp(box_step());
  text = std::regex_replace(text, std::regex(R"(#(\d+))"), "#9900000000000000000000$1");
  const Scene scene = read(folder_.write("large.step", text));
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_EQ(test::count_of(scene.diagnostics, "step.broken_entities"), 0);
  expect_error(changed(folder_ / "large.step", "ENDSEC;\nEND-ISO",
                       "#2147483647 = PLANE('',$);\nENDSEC;\nEND-ISO", "full.step"),
               "up to the end of 32 bits");
}

TEST_F(BadFiles, NoCutCrashes) {
  const std::string step = test::slurp(box_step());
  ASSERT_TRUE(BRepTools::Write(test::solid_sphere(2), (folder_ / "ball.brep").c_str()));
  const std::string brep = test::slurp(folder_ / "ball.brep");
  for (int i = 1; i < 25; ++i) {
    for (const auto& [text, name] : {std::pair(step, "cut.step"), std::pair(brep, "cut.brep")}) {
      const std::string cut = text.substr(0, text.size() * static_cast<std::size_t>(i) / 25);
      try {
        EXPECT_FALSE(read(folder_.write(name, cut)).parts.empty());
      } catch (const InputError& e) {
        EXPECT_STRNE(e.what(), "");
      }
    }
  }
}

TEST_F(BadFiles, NoWrongByteCrashes) {
  const std::string step = test::slurp(box_step());
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int i = 0; i < 160; ++i) {
    std::string text = step;
    for (int k = 0; k < 20; ++k)
      text[400 + below(text.size() - 400)] = "0123456789#,()'$*A;"[below(19)];
    try {
      EXPECT_FALSE(read(folder_.write("wrong.step", text)).parts.empty());
    } catch (const InputError& e) {
      EXPECT_STRNE(e.what(), "");
    }
  }
}

TEST_F(BadFiles, ACancelledRunReadsNothing) {
  const std::string file = box_step();
  RunContext context;
  context.cancel();
  EXPECT_THROW(read_cad(file, context), Cancelled);
}

TEST_F(BadFiles, CancelStopsAReadingUnderWay) {
  CadDocument document;
  const TDF_Label top = document.assembly("top");
  for (int i = 0; i < 150; ++i) {
    const TDF_Label part = document.part(test::solid_box(1, 2, 3 + i), "p");
    document.use(top, part, gp_Trsf(), "u");
  }
  const std::string file = document.step(folder_ / "many.step");
  double reached = 0;
  RunContext* running = nullptr;
  RunContext context([&](const std::string&, double share) {
    reached = std::max(reached, share);
    if (share > 0.35) running->cancel();
  });
  running = &context;
  context.begin_stage(RunStage::Read);
  EXPECT_THROW(read_cad(file, context), Cancelled);
  EXPECT_GT(reached, 0.35);
  EXPECT_LT(reached, 1);
}

TEST_F(BadFiles, SeveralThreadsMayRead) {
  const std::string file = box_step();
  std::atomic<int> parts = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] { parts += static_cast<int>(read(file).parts.size()); });
  }
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(parts, 8);
}

}  // namespace
}  // namespace burin
