// Descriptions of choices: what they take, what they say of themselves, how structs carry them.
#include <burin/base/error.h>
#include <burin/options/json_lines.h>
#include <burin/options/meant.h>
#include <burin/options/request.h>
#include <burin/options/row.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace burin {
namespace {

using nlohmann::json;

const Option kWidth{"width", "how wide", NumberRange{0.5, 10, "mm"}};
const Option kCount{"count", "how many", WholeRange{2, 3}};
const Option kMerge{"merge", "whether", Switch{}};
const Option kFlatten{"flatten", "how", Switch{"polylines", "none"}};
const Option kCap{"cap", "which end", WordList{{"butt", "round", "square"}}};
const Option kLight{"light", "whence", Direction{}};
const Option kAll[] = {kWidth, kCount, kMerge, kFlatten, kCap, kLight};

std::string read_back(const Option& option, const std::string& text) {
  const auto value = parse_value(option, text);
  return value ? value_text(option, *value) : "refused";
}

TEST(Options, TakeWhatTheySay) {
  EXPECT_EQ(read_back(kWidth, " +2.50 "), "2.5");
  EXPECT_EQ(read_back(kWidth, "10"), "10");
  EXPECT_EQ(read_back(kCount, "3"), "3");
  EXPECT_EQ(read_back(kMerge, "yes"), "true");
  EXPECT_EQ(read_back(kMerge, "False"), "false");
  EXPECT_EQ(read_back(kFlatten, "polylines"), "polylines");
  EXPECT_EQ(read_back(kFlatten, "off"), "none");
  EXPECT_EQ(read_back(kCap, "round"), "round");
  EXPECT_EQ(read_back(kLight, "1, -2,0.5"), "1,-2,0.5");
}

TEST(Options, RefuseAllElse) {
  for (const char* text : {"", "0.4", "10.1", "nan", "inf", "2mm", "2 3", "1e400"}) {
    EXPECT_EQ(read_back(kWidth, text), "refused") << text;
  }
  for (const char* text : {"1", "4", "2.0", "-2", "99999999999999999999"}) {
    EXPECT_EQ(read_back(kCount, text), "refused") << text;
  }
  for (const char* text : {"", "maybe", "2"}) EXPECT_EQ(read_back(kMerge, text), "refused") << text;
  for (const char* text : {"", "Round", "rounds"}) {
    EXPECT_EQ(read_back(kCap, text), "refused") << text;
  }
  for (const char* text : {"0,0,0", "1,2", "1,2,3,4", "1,2,nan", "1;2;3"}) {
    EXPECT_EQ(read_back(kLight, text), "refused") << text;
  }
}

TEST(Options, SayWhatTheyTake) {
  EXPECT_EQ(takes_text(kWidth), "0.5 to 10");
  EXPECT_EQ(takes_text(kFlatten), "polylines or none");
  EXPECT_EQ(takes_text(kCap), "butt, round or square");
  Option own = kWidth;
  own.phrase = "a width";
  EXPECT_EQ(takes_text(own), "a width");
  std::string kinds;
  for (const Option& option : kAll) kinds += std::string(kind_of(option)) + " ";
  EXPECT_EQ(kinds, "number whole flag flag word direction ");
}

TEST(Options, TellProgramsOfThemselves) {
  const json width = json::parse(to_json(kWidth, {{"value", "3"}}));
  EXPECT_EQ(width["kind"], "number");
  EXPECT_EQ(width["low"], 0.5);
  EXPECT_EQ(width["unit"], "mm");
  EXPECT_EQ(width["value"], "3");
  EXPECT_EQ(json::parse(to_json(kFlatten))["words"], json({"none", "polylines"}));
  EXPECT_EQ(json::parse(value_schema(kWidth))["maximum"], 10);
  EXPECT_EQ(json::parse(value_schema(kMerge))["type"], "boolean");
  EXPECT_EQ(json::parse(value_schema(kFlatten))["enum"], json({"none", "polylines"}));
  EXPECT_EQ(json::parse(value_schema(kLight))["minItems"], 3);
}

struct Pen {
  double thin = 1, thick = 2;
  enum class Cap { Butt, Round } cap = Cap::Butt;
  std::string ink = "black";
};
struct Desk {
  Pen pen;
  bool lamp = false;
};

std::vector<OptionRow<Pen>> pen_rows() {
  return {options::number("thin", &Pen::thin, {0, 10}, "thinnest", "thick"),
          options::number("thick", &Pen::thick, {0, 10}, "widest"),
          options::word("cap", &Pen::cap, {"butt", "round"}, "its ends"),
          options::word("ink", &Pen::ink, {"black", "red"}, "its ink")};
}

TEST(OptionRows, ReachTheirMembersThroughLargerStructs) {
  std::vector<OptionRow<Desk>> rows = {options::flag("lamp", &Desk::lamp, "light")};
  options::append(rows, "pen.", &Desk::pen, pen_rows());
  Desk desk;
  std::string said;
  for (const OptionRow<Desk>& row : rows)
    said += row.name + "=" + value_text(row, row.get(desk)) + " ";
  EXPECT_EQ(said, "lamp=false pen.thin=1 pen.thick=2 pen.cap=butt pen.ink=black ");
  rows[3].set(desk, *parse_value(rows[3], "round"));
  rows[4].set(desk, *parse_value(rows[4], "red"));
  EXPECT_EQ(desk.pen.cap, Pen::Cap::Round);
  EXPECT_EQ(desk.pen.ink, "red");
  EXPECT_FALSE(options::first_fault(rows, desk));
  desk.pen.thin = 3;
  EXPECT_EQ(options::first_fault(rows, desk), "'pen.thin' (3) is more than 'pen.thick' (2)");
}

TEST(OptionRows, FindWhatNoTextWouldSet) {
  const auto fault = [](const Pen& pen) {
    return options::first_fault(pen_rows(), pen).value_or("");
  };
  EXPECT_EQ(fault({}), "");
  EXPECT_EQ(fault({.thin = -1}), "'thin' takes 0 to 10, not '-1'");
  EXPECT_EQ(fault({.thick = std::numeric_limits<double>::quiet_NaN()}),
            "'thick' takes 0 to 10, not 'nan'");
  EXPECT_EQ(fault({.cap = static_cast<Pen::Cap>(7)}), "'cap' takes butt or round, not '7'");
  EXPECT_EQ(fault({.ink = "blue"}), "'ink' takes black or red, not 'blue'");
}

const std::vector<RequestRow<Pen>> kPenRequest = {
    {{.option = {"thick_line", "widest", NumberRange{0, 10}}, .group = "Pen", .fallback = "4"},
     [](Pen& pen, const Asked& a) { pen.thick = std::get<double>(a.value); }},
    {{.option = {"ink", "its ink", FreeText{}}, .group = "Pen", .many = true},
     [](Pen& pen, const Asked& a) {
       pen.ink.clear();
       for (const std::string& text : a.texts) pen.ink += text;
     }}};

TEST(Requests, ApplyWhatIsGivenAndElseTheDefault) {
  Pen pen;
  apply(kPenRequest, {}, Spelling::Options, pen);
  EXPECT_EQ(pen.thick, 4);
  EXPECT_EQ(pen.ink, "black");
  apply(kPenRequest, {{"thick_line", {"1", "7"}}, {"ink", {"red", "blue"}}, {"other", {"x"}}},
        Spelling::Options, pen);
  EXPECT_EQ(pen.thick, 7);
  EXPECT_EQ(pen.ink, "redblue");
}

TEST(Requests, ErrorsNameTheOptionAsTheDoorSpellsIt) {
  const auto message = [](Spelling spelling) -> std::string {
    Pen pen;
    try {
      apply(kPenRequest, {{"thick_line", {"11"}}}, spelling, pen);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_EQ(message(Spelling::Options), "option --thick-line takes 0 to 10, not '11'");
  EXPECT_EQ(message(Spelling::Keywords), "argument thick_line takes 0 to 10, not '11'");
}

TEST(Messages, NameOptionsAsTheDoorDoes) {
  std::vector<RequestOption> options(2);
  options[0].option.name = "raw_skip";
  options[1].option.name = "iso";
  const auto at = [&](const std::string& message, Spelling spelling) {
    return spelled_message(message, options, spelling);
  };
  const std::string said = "give `iso 0.5 mm`, or `raw_skip`";
  EXPECT_EQ(at(said, Spelling::Options), "give --iso 0.5 mm, or --raw-skip");
  EXPECT_EQ(at(said, Spelling::Keywords), "give iso=0.5 mm, or raw_skip");
  // Words of a file are nobody's options.
  for (const std::string other : {"", "`", "``", "no `part` here", "a`b", "`part`s `"}) {
    EXPECT_EQ(at(other, Spelling::Options), other);
  }
  EXPECT_EQ(at("a`b needs `iso`", Spelling::Options), "a`b needs --iso");
}

TEST(JsonLines, AreThoseOfMembersAndElements) {
  const JsonLines lines(
      "{\n"
      "  \"parts\": [ // two\n"
      "    {\"file\": \"a\"},\n"
      "    {\n"
      "      \"file\": \"b\"}],\n"
      "\n"
      "  \"parts2\": [1,\n"
      "   \"x\"],\n"
      "  \"view\": {\"from\": \"iso\"}}");
  EXPECT_EQ(lines.line("/parts"), 2);
  EXPECT_EQ(lines.line("/parts/0"), 3);
  EXPECT_EQ(lines.line("/parts/0/file"), 3);
  EXPECT_EQ(lines.line("/parts/1"), 4);
  EXPECT_EQ(lines.line("/parts/1/file"), 5);
  EXPECT_EQ(lines.line("/parts2"), 7);
  EXPECT_EQ(lines.line("/parts2/1"), 8);
  EXPECT_EQ(lines.line("/view/from"), 9);
  EXPECT_EQ(lines.line("/parts/1/place/scale"), 4);  // of what holds it
  EXPECT_EQ(lines.line("/nothing"), 1);
  EXPECT_EQ(JsonLines("{\"a\": ").line("/a"), 1);
}

// In meaning first, then in letters; nothing where nothing is near.
TEST(Words, AreMeantAsPeopleSayThem) {
  const std::vector<KnownWord> known = {
      {"--parts-list", {"bom", "bill of materials"}},
      {"--section", {"cut", "cross section"}},
      {"--section-box", {"clip box"}},
      {"--hidden", {"hidden lines"}},
      {"--output", {"out"}},
      {"png.dpi", {"resolution"}, "that is --set png.dpi=VALUE"},
  };
  const auto name = [&](const char* word) {
    const KnownWord* found = meant(word, known);
    return found ? found->name : std::string("none");
  };
  EXPECT_EQ(name("--bom"), "--parts-list");
  EXPECT_EQ(name("--BillOfMaterials"), "--parts-list");
  EXPECT_EQ(name("--crossSection"), "--section");
  EXPECT_EQ(name("--sections"), "--section");
  EXPECT_EQ(name("--cuts"), "--section");
  EXPECT_EQ(name("--clip_box"), "--section-box");
  EXPECT_EQ(name("--ouptut"), "--output");
  EXPECT_EQ(name("--outp"), "--output");
  EXPECT_EQ(name("--section-plane"), "--section");
  EXPECT_EQ(name("--show-hidden"), "--hidden");
  EXPECT_EQ(name("--hidden-line-style"), "--hidden");
  EXPECT_EQ(name("--Resolution"), "png.dpi");
  EXPECT_EQ(hint("resolution", known), "; that is --set png.dpi=VALUE");
  EXPECT_EQ(hint("--bom", known), "; the nearest is '--parts-list'");
  for (const char* word : {"--flavour", "--xyzzy", "--", "", "-q", "--box", "--bot",
                           "--temperature", "\xc3\xa9\xc3\xa9\xc3\xa9"}) {
    EXPECT_EQ(name(word), "none") << word;
  }
  EXPECT_EQ(meant("anything", {}), nullptr);
}

}  // namespace
}  // namespace burin
