/// Selectors: parts of an assembly by name, path and attribute.

#include <burin/assembly/select.h>
#include <burin/base/error.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace burin {
namespace {

Scene scene() {
  Scene s;
  const auto add = [&](std::string name, std::vector<std::string> assembly, std::string file,
                       std::string color) {
    Part part;
    part.name = std::move(name);
    part.assembly = std::move(assembly);
    part.source = std::move(file);
    part.color = std::move(color);
    s.parts.push_back(std::move(part));
  };
  add("body", {"pump"}, "models/pump.step", "#88C0FF");    // 0
  add("bolt", {"pump", "cover"}, "models/pump.step", "");  // 1
  add("bolt", {"pump", "foot"}, "models/pump.step", "");   // 2
  add("M6 bolt", {"pump", "foot"}, "models/pump.step", "");
  add("lid", {}, "lid.stl", "#88c0ff");  // 4
  return s;
}

using Parts = std::vector<std::size_t>;

TEST(Select, ANameIsThatOfPartsAndOfAssembliesAtAnyDepth) {
  const Scene s = scene();
  EXPECT_EQ(select(s, "bolt"), (Parts{1, 2}));
  EXPECT_EQ(select(s, "*bolt"), (Parts{1, 2, 3}));
  EXPECT_EQ(select(s, "b?lt"), (Parts{1, 2}));
  EXPECT_EQ(select(s, "foot"), (Parts{2, 3}));
  EXPECT_EQ(select(s, "pump"), (Parts{0, 1, 2, 3}));
  EXPECT_EQ(select(s, "*"), (Parts{0, 1, 2, 3, 4}));
}

TEST(Select, APathLeadsFromAnyDepthOrWithASlashFromTheTop) {
  const Scene s = scene();
  EXPECT_EQ(select(s, "foot/bolt"), (Parts{2}));
  EXPECT_EQ(select(s, "pump/*/bolt"), (Parts{1, 2}));
  EXPECT_EQ(select(s, "/pump/foot"), (Parts{2, 3}));
  EXPECT_EQ(select(s, "/pump/**/*bolt"), (Parts{1, 2, 3}));
  EXPECT_EQ(select(s, "/lid"), (Parts{4}));
  EXPECT_THROW(select(s, "/bolt"), UsageError);
  EXPECT_THROW(select(s, "pump/bolt"), UsageError);
}

// Files of macOS hold accents behind their letters, keyboards type them within.
TEST(Select, AnAccentMayStandInItsLetterOrBehindIt) {
  const char* const within[] = {"Schl\u00fcssel", "\u1ebf", "\u0439",
                                "\u304c",         "\uac01", "a\u00fcb"};
  const char* const behind[] = {"Schlu\u0308ssel", "e\u0302\u0301",      "\u0438\u0306",
                                "\u304b\u3099",    "\u1100\u1161\u11a8", "au\u0308b"};
  for (std::size_t i = 0; i < std::size(within); ++i) {
    Scene s = scene();
    for (const char* name : {within[i], behind[i]}) {
      s.parts[0].name = name;
      EXPECT_EQ(select(s, within[i]), (Parts{0})) << name;
      EXPECT_EQ(select(s, behind[i]), (Parts{0})) << name;
      EXPECT_EQ(select(s, std::string(behind[i]) + "*"), (Parts{0})) << name;
    }
  }
  Scene s = scene();
  s.parts[0].name = "Schlu\u0308ssel";
  EXPECT_EQ(select(s, "Schl?ssel"), (Parts{0})) << "? is a letter, of one byte or more";
  EXPECT_THROW(select(s, "Schlussel"), UsageError);
  EXPECT_THROW(select(s, "l\u00efd"), UsageError) << "lid";
}

TEST(Select, ANameMeansWhatReadersHaveNumbered) {
  Scene s = scene();
  s.parts[2].name = "bolt #2";
  s.parts[2].assembly = {"pump", "cover"};
  s.parts[3].assembly = {"pump", "foot #2"};
  EXPECT_EQ(select(s, "bolt"), (Parts{1, 2}));
  EXPECT_EQ(select(s, "cover/b*t"), (Parts{1, 2}));
  EXPECT_EQ(select(s, "foot"), (Parts{3}));
  EXPECT_EQ(select(s, "bolt #2"), (Parts{2}));
  EXPECT_EQ(select(s, "/pump/cover/bolt"), (Parts{1}));
}

// "No part is named '1/4 inch bolt'; names: '1/4 inch bolt'" was the answer.
TEST(Select, NamesMayHaveSlashesWithin) {
  Scene s = scene();
  s.parts[1].name = "1/4 inch bolt";
  s.parts[4].assembly = {"pump", "n/a"};
  EXPECT_EQ(select(s, "1/4 inch bolt"), (Parts{1}));
  EXPECT_EQ(select(s, "cover/1/4 inch bolt"), (Parts{1}));
  EXPECT_EQ(select(s, "/pump/cover/1/4 inch bolt"), (Parts{1}));
  EXPECT_EQ(select(s, "n/a"), (Parts{4}));
  EXPECT_THROW(select(s, "4 inch bolt"), UsageError);
  EXPECT_THROW(select(s, "/1/4 inch bolt"), UsageError);
}

TEST(Select, AttributesAreColourNumberAndFile) {
  const Scene s = scene();
  EXPECT_EQ(select(s, "@color=#88c0ff"), (Parts{0, 4}));
  EXPECT_EQ(select(s, "@index=3"), (Parts{3}));
  EXPECT_EQ(select(s, "@file=pump.*"), (Parts{0, 1, 2, 3}));
  EXPECT_EQ(select(s, "@file=lid.stl"), (Parts{4}));
  EXPECT_THROW(select(s, "@index=5"), UsageError);
  EXPECT_THROW(select(s, "@weight=5"), UsageError);
}

TEST(Select, NothingFoundNamesTheNearest) {
  const Scene s = scene();
  const auto message = [&](const char* selector) -> std::string {
    try {
      select(s, selector);
    } catch (const UsageError& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_EQ(message("bolts"),
            "no part is named 'bolts'; names of parts and assemblies: 'bolt', "
            "'body', 'foot', 'M6 bolt', 'cover' and 2 more");
  EXPECT_NE(message("pump/foot/bolts").find("'pump/foot/bolt'"), std::string::npos);
  EXPECT_NE(message("").find("not empty"), std::string::npos);
}

TEST(Select, TheHighestNameThatMatchesSaysHowCloselyAPartIsNamed) {
  const Scene s = scene();
  const Parts ones{1, 4};  // pump/cover/bolt, lid
  EXPECT_EQ(levels_above(s, ones, "bolt"), (Parts{0, 0}));
  EXPECT_EQ(levels_above(s, ones, "pump/*/bolt"), (Parts{0, 0}));
  EXPECT_EQ(levels_above(s, ones, "@index=1"), (Parts{0, 0}));
  EXPECT_EQ(levels_above(s, ones, "c*"), (Parts{1, 0}));
  EXPECT_EQ(levels_above(s, ones, "*"), (Parts{2, 0}));
  EXPECT_EQ(levels_above(s, ones, "**"), (Parts{2, 0}));
}

TEST(Select, APatternMeansWhatIsInTheOneAssemblyBeforeItself) {
  Scene s;
  const auto add = [&](std::string name, std::vector<std::string> assembly) {
    s.parts.emplace_back();
    s.parts.back().name = std::move(name);
    s.parts.back().assembly = std::move(assembly);
  };
  add("gear A", {"gear pump", "drive"});
  add("gear B", {"gear pump"});
  add("body", {"gear pump"});
  EXPECT_EQ(select(s, "gear*"), (Parts{0, 1}));
  EXPECT_EQ(levels_above(s, Parts{0, 1}, "gear*"), (Parts{0, 0})) << "more closely than drive";
  EXPECT_EQ(select(s, "gear pump"), (Parts{0, 1, 2}));
  EXPECT_EQ(select(s, "/gear*"), (Parts{0, 1, 2}));
  EXPECT_EQ(select(s, "gear p*"), (Parts{0, 1, 2}));
  EXPECT_EQ(select(s, "*"), (Parts{0, 1, 2}));
  add("gear", {});
  EXPECT_EQ(select(s, "gear*"), (Parts{0, 1, 2, 3})) << "no assembly holds all";
}

TEST(Select, ANameOfTheOneAssemblyAndOfAPartMeansThePart) {
  Scene s;
  for (const char* name : {"rod", "nut", "rod #2", "washer"}) {
    s.parts.emplace_back();
    s.parts.back().name = name;
    s.parts.back().assembly = {"rod"};
  }
  EXPECT_EQ(select(s, "rod"), (Parts{0, 2}));
  EXPECT_EQ(levels_above(s, Parts{0, 2}, "rod"), (Parts{0, 0}));
  EXPECT_EQ(select(s, "/rod"), (Parts{0, 1, 2, 3})) << "the path from the top is the assembly";
  for (Part& part : s.parts) part.name = "rod";
  EXPECT_EQ(select(s, "rod"), (Parts{0, 1, 2, 3}));
}

// A pattern of many stars against a long name is the classic that takes exponential time.
TEST(Select, ManyStarsEndAtOnce) {
  Scene s;
  Part part;
  part.name = std::string(2000, 'a');
  s.parts.push_back(part);
  std::string pattern;
  for (int i = 0; i < 200; ++i) pattern += "a*";
  EXPECT_THROW(select(s, pattern + "b"), UsageError);
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "**/";
  EXPECT_EQ(select(s, deep + "a*"), (Parts{0}));
}

}  // namespace
}  // namespace burin
