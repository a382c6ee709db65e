/// Bodies of parts, chosen one by one.

#include <burin/assembly/items.h>
#include <burin/assembly/pieces.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

/// board (one body), chip of three bodies twice, a lid of two.
Scene scene_of_pieces() {
  Scene s;
  const auto add = [&](std::string name, std::vector<std::string> assembly, int bodies) {
    Part part;
    part.name = std::move(name);
    part.assembly = std::move(assembly);
    part.definition = part.name.substr(0, 4);
    part.color = "#102030";
    for (int i = 1; i <= bodies; ++i) {
      part.pieces.push_back({"solid " + std::to_string(i), nullptr, i == 2 ? "#ff0000" : ""});
    }
    s.parts.push_back(std::move(part));
  };
  add("board", {"card"}, 0);
  add("chip", {"card"}, 3);
  add("chip #2", {"card"}, 3);
  add("lid", {}, 2);
  return s;
}

std::vector<std::string> paths(const Scene& scene) {
  std::vector<std::string> all;
  for (const Part& part : scene.parts) all.push_back(path_of(part));
  return all;
}

using Strings = std::vector<std::string>;
using Parts = std::vector<std::size_t>;

TEST(Pieces, AreChosenByTheNameThatSomebodyGave) {
  for (const char* selector :
       {"lid/housing", "lid/solid 1", "/lid/hous*", "lid/solid 1 (housing)"}) {
    Scene s = scene_of_pieces();
    s.parts[3].pieces[0].name = piece_name("solid 1", "housing");
    EXPECT_EQ(split_pieces(s, Strings{selector}), (Parts{3})) << selector;
    EXPECT_EQ(path_of(s.parts[3]), "lid/solid 1 (housing)");
    EXPECT_EQ(path_of(s.parts[4]), "lid/solid 2");
    EXPECT_EQ(select(s, selector), (Parts{3})) << selector;
    EXPECT_EQ(select(s, "lid"), (Parts{3, 4}));
  }
}

TEST(Pieces, AreSplitWhereASelectorNamesOneByItsPath) {
  Scene s = scene_of_pieces();
  EXPECT_EQ(split_pieces(s, Strings{"chip/solid 2"}), (Parts{1, 1}));
  // The numbers of the other parts stay.
  EXPECT_EQ(paths(s), (Strings{"card/board", "card/chip/solid 1", "card/chip #2", "lid",
                               "card/chip/solid 2", "card/chip/solid 3"}));
  EXPECT_EQ(select(s, "chip/solid 2"), (Parts{4}));
  EXPECT_EQ(select(s, "/card/chip"), (Parts{1, 4, 5}));
  EXPECT_EQ(select(s, "chip"), (Parts{1, 2, 4, 5})) << "the other one is called so, too";
  EXPECT_EQ(select(s, "card"), (Parts{0, 1, 2, 4, 5}));
  EXPECT_EQ(s.parts[4].color, "#ff0000");
  EXPECT_EQ(s.parts[5].color, "#102030");
  EXPECT_EQ(s.parts[5].definition, "chip, solid 3");
  EXPECT_EQ(s.parts[2].pieces.size(), 3u);
}

TEST(Pieces, PatternsOfPathsNameThemInAllPartsThatTheyLeadTo) {
  for (const auto& [selector, count] :
       {std::pair("*/solid 2", 9), std::pair("/card/chip*/solid ?", 8), std::pair("**/solid 3", 8),
        std::pair("/lid/*", 5), std::pair("lid/solid 2", 5)}) {
    Scene s = scene_of_pieces();
    split_pieces(s, Strings{selector});
    EXPECT_EQ(s.parts.size(), static_cast<std::size_t>(count)) << selector;
  }
}

TEST(Pieces, StayTogetherWhereASelectorLeadsToTheirPart) {
  // Names of one level are those of parts: else "*2" would mean bodies of all parts.
  for (const char* selector : {"chip", "*", "card/*", "card/**", "solid 2", "*2", "@index=1", "/",
                               "", "chip/solid 7", "board/solid 1"}) {
    Scene s = scene_of_pieces();
    EXPECT_TRUE(split_pieces(s, Strings{selector}).empty()) << selector;
    EXPECT_EQ(s.parts.size(), 4u) << selector;
  }
}

TEST(Pieces, OfGlassAndMetalAreSplitWhereThatIsAskedFor) {
  Scene s = scene_of_pieces();
  s.parts[1].pieces[1].opacity = 0.25;
  for (Piece& piece : s.parts[3].pieces) piece.opacity = 0.5;
  Scene same = s;
  EXPECT_TRUE(split_pieces(same, {}).empty());
  EXPECT_EQ(split_pieces(s, {}, true), (Parts{1, 1}));
  EXPECT_EQ(s.parts[1].opacity, 1);
  EXPECT_EQ(s.parts[4].opacity, 0.25);
  // A body without a colour of its own has what its part has.
  s.parts[3].opacity = 0.5;
  split_pieces(s, Strings{"lid/solid 1"});
  EXPECT_EQ(s.parts[3].opacity, 0.5);
  EXPECT_EQ(s.parts[3].whole->name, "lid");
}

TEST(Pieces, OfOnePartAreOneItem) {
  Scene s = scene_of_pieces();
  for (std::size_t i = 0; i < s.parts.size(); ++i) {
    const double size = 1 + static_cast<double>(i);
    s.parts[i].form = std::make_shared<MeshForm>(test::box({0, 0, 0}, {size, 2, 3}));
    for (Piece& piece : s.parts[i].pieces) piece.form = s.parts[i].form;
  }
  s.parts[2].form = s.parts[1].form;
  split_pieces(s, Strings{"chip/solid 2"});
  RunContext context;
  const std::vector<Item> items = find_items(s, {}, s.diagnostics, context);
  ASSERT_EQ(items.size(), 3u);
  EXPECT_EQ(items[1].name, "chip");
  EXPECT_EQ(items[1].parts, (Parts{1, 2, 4, 5}));
  EXPECT_EQ(items[1].color, "#102030");
}

TEST(Pieces, AreNamedWhereASelectorFindsNothing) {
  try {
    select(scene_of_pieces(), "chip/solid 7");
    ADD_FAILURE();
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("chip/solid"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace burin
