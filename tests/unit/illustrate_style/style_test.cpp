#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/illustrate/style.h>
#include <burin/stroke/stroke.h>
#include <burin/tone/tone.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace burin {
namespace {

std::string usage_message(const std::function<void()>& f) {
  try {
    f();
  } catch (const UsageError& e) {
    return e.what();
  }
  return "no UsageError";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Style, EveryMemberHasOneKey) {
  // Doubles, switches, words and vectors of Style, counted by hand: a new member needs a key.
  const auto keys = style_keys(Style());
  std::set<std::string> names;
  for (const StyleKey& key : keys) {
    names.insert(key.name);
    EXPECT_FALSE(key.meaning.empty());
    EXPECT_FALSE(takes_text(key).empty());
    // Colours that are those of the sheet.
    const std::set<std::string> empty{"line.color",       "hatch.color", "shadow.color", "fill.ink",
                                      "fill.hatch_color", "pmi.color",   "pmi.view"};
    const bool may_be_empty = empty.contains(key.name);
    EXPECT_EQ(key.value.empty(), may_be_empty) << key.name;
  }
  EXPECT_EQ(names.size(), keys.size());
  EXPECT_EQ(keys.size(), 15u /*line*/ + 11u /*feature*/ + 35u + 17u + 2u /*tones*/ + 13u /*fill*/ +
                             3u /*shadow*/ + 3u /*halo*/ + 3u /*depth*/ + 3u /*sheet*/ +
                             6u /*callout*/ + 5u /*dimension*/ + 3u /*break*/ + 4u /*pmi*/ +
                             4u /*svg*/ + 1u /*json*/);
}

TEST(Style, KeysTakeTheirOwnValues) {
  for (const StyleInfo& info : builtin_styles()) {
    const Style style = builtin_style(info.name);
    Style copy;
    for (const StyleKey& key : style_keys(style)) set_style_key(copy, key.name, key.value);
    copy.name = style.name;
    EXPECT_EQ(style_to_json(copy), style_to_json(style));
    EXPECT_NO_THROW(check_style(style));
  }
}

TEST(Style, SetsMembersByType) {
  Style s;
  set_style_key(s, "line.outer", "1.25");
  EXPECT_EQ(s.line.outer, 1.25);
  set_style_key(s, "hatch.enabled", "false");
  EXPECT_FALSE(s.hatch.enabled);
  set_style_key(s, "hatch.field", "fixed");
  EXPECT_EQ(s.hatch.field.name, "fixed");
  set_style_key(s, "tone.light", " 1, -2.5,3e-1");
  EXPECT_EQ(s.tone.light, Vec3(1, -2.5, 0.3));
  set_style_key(s, "svg.flatten", "polylines");
  EXPECT_TRUE(values_in<SvgOptions>(s.formats).flatten);
  set_style_key(s, "svg.flatten", "none");
  EXPECT_FALSE(values_in<SvgOptions>(s.formats).flatten);
  set_style_key(s, "json.points3", "false");
  EXPECT_FALSE(values_in<JsonOptions>(s.formats).points3);
}

TEST(Style, RefusesWhatAKeyDoesNotTake) {
  const std::pair<const char*, const char*> wrong[] = {
      {"line.outer", "thick"},       {"line.outer", "0"},       {"line.outer", "nan"},
      {"line.outer", "1e9"},         {"line.outer", ""},        {"line.outer", "0.5mm"},
      {"hatch.enabled", "maybe"},    {"hatch.field", "circle"}, {"hatch.direction", "0,0,0"},
      {"hatch.direction", "1,2"},    {"tone.light", "1,2,3,4"}, {"svg.flatten", "maybe"},
      {"feature.crease_angle", "-1"}};
  for (const auto& [key, value] : wrong) {
    Style s;
    const std::string message = usage_message([&, k = key, v = value] { set_style_key(s, k, v); });
    EXPECT_TRUE(contains(message, key)) << message;
    EXPECT_TRUE(contains(message, "takes")) << message;
    EXPECT_EQ(style_to_json(s), style_to_json(Style()));
  }
  Style s;
  EXPECT_EQ(usage_message([&] { set_style_key(s, "line.crease", "11"); }),
            "style key 'line.crease' takes 0.01 to 10, not '11'");
}

TEST(Style, UnknownKeysNameTheNearest) {
  Style s;
  EXPECT_TRUE(contains(usage_message([&] { set_style_key(s, "line.outr", "1"); }), "'line.outer'"));
  EXPECT_TRUE(contains(usage_message([&] { set_style_key(s, "hatch.spacingmin", "1"); }),
                       "'hatch.spacing_min'"));
  EXPECT_TRUE(contains(usage_message([&] { builtin_style("engravng"); }), "'engraving'"));
}

TEST(Style, MinimaStayBelowMaxima) {
  Style s;
  set_style_key(s, "hatch.spacing_min", "5");
  EXPECT_TRUE(contains(usage_message([&] { check_style(s); }), "hatch.spacing_max"));
}

/// Every key of a style with its value.
std::map<std::string, std::string> values_of(const Style& style) {
  std::map<std::string, std::string> out;
  for (const StyleKey& key : style_keys(style)) out[key.name] = key.value;
  return out;
}

TEST(Style, IsTechnicalByDefault) {
  EXPECT_EQ(Style().name, "technical");
  EXPECT_EQ(values_of(Style()), values_of(builtin_style(Style().name)));
  EXPECT_EQ(values_of(parse_style("{}", "empty.json")), values_of(Style()));
}

TEST(Style, PresetsDiffer) {
  EXPECT_FALSE(builtin_style("outline").hatch.enabled);
  EXPECT_GT(builtin_style("technical").hatch.cross_from, 1);
  EXPECT_LT(builtin_style("engraving").hatch.cross_from, 1);
  EXPECT_EQ(builtin_style("outline").line.outer, 0.7);
  for (const StyleInfo& info : builtin_styles())
    EXPECT_EQ(builtin_style(info.name).name, info.name);
}

TEST(StyleFile, ReadsGroupsDotsBaseAndComments) {
  const Style s = parse_style(R"({
    // a comment
    "base": "engraving", "line.outer": 0.5,
    "hatch": {"spacing_min": 0.4, "field": "fixed", "direction": [1, 0, 0]},
    "svg": {"flatten": "polylines"}, "json.points3": false
  })",
                              "dir/fine.json");
  EXPECT_EQ(s.name, "fine");
  EXPECT_EQ(s.line.outer, 0.5);
  EXPECT_EQ(s.line.contour, builtin_style("engraving").line.contour);
  EXPECT_EQ(s.hatch.spacing_min, 0.4);
  EXPECT_EQ(s.hatch.field.name, "fixed");
  EXPECT_EQ(s.hatch.field.direction, Vec3(1, 0, 0));
  EXPECT_TRUE(values_in<SvgOptions>(s.formats).flatten);
  EXPECT_FALSE(values_in<JsonOptions>(s.formats).points3);
  EXPECT_EQ(parse_style(R"({"name": "x"})", "f").name, "x");
}

TEST(StyleFile, RoundTrip) {
  for (const StyleInfo& info : builtin_styles()) {
    Style s = builtin_style(info.name);
    s.tone.light = {1.0 / 3, -2e-7, 12345.678};
    s.hatch.taper = 0.1 + 0.2;
    put(s.formats, SvgOptions{.flatten = true});
    const std::string text = style_to_json(s);
    const Style back = parse_style(text, "other");
    EXPECT_EQ(style_to_json(back), text);
    EXPECT_EQ(back.tone.light, s.tone.light);
    EXPECT_EQ(back.hatch.taper, s.hatch.taper);
    EXPECT_EQ(back.name, info.name);
  }
}

TEST(StyleFile, ErrorsNameFileAndLine) {
  try {
    parse_style("{\n\"line.outer\": 0.5,\n\"line.crease\" 3}", "my.json");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.file(), "my.json");
    EXPECT_EQ(e.line(), 3);
  }
  EXPECT_THROW(parse_style("[1,2]", "f"), InputError);
  EXPECT_THROW(parse_style("", "f"), InputError);
  const auto message = [](const char* text) {
    return usage_message([&] { parse_style(text, "my.json"); });
  };
  EXPECT_TRUE(
      message("{\n \"line\": {\n  \"outr\": 1}}").starts_with("my.json:3: unknown style key"));
  EXPECT_TRUE(message("{\n\"lines\": {}}").starts_with("my.json:2: unknown style key 'lines'"));
  EXPECT_TRUE(message("{\"hatch\": 3}").starts_with("my.json:1: unknown style key 'hatch'"));
  EXPECT_TRUE(message("{\"line\": {\"outer\": {\"a\": 1}}}").starts_with("my.json:1: style key"));
  EXPECT_TRUE(message("{\n\n\"base\": \"engravin\"}").starts_with("my.json:3: unknown style"));
  EXPECT_TRUE(message("{\"line.outer\": [1, 2]}").starts_with("my.json:1: style key 'line.outer'"));
  EXPECT_TRUE(message("{\"line.outer\": null}").starts_with("my.json:1: style key 'line.outer'"));
  EXPECT_TRUE(message("{\"name\": 3}").starts_with("my.json:1: style key 'name'"));
  EXPECT_TRUE(
      message("{\"hatch.width_min\": 5}").starts_with("my.json: style key 'hatch.width_min'"));
}

TEST(StyleFile, ReadsKindsOfStrokes) {
  const Style s = parse_style(R"({
    "base": "engraving", "strokes": [
      {"field": "isoparametric", "tone": {"ambient": 0.2}},
      {"kind": "dots", "select": "a;b", "share": 2},
      {"field": "principal", "tone.law": "silhouette"}],
    "strokes.2.width_max": 0.5, "hatch.taper": 1.5, "strokes.4.kind": "pencil"
  })",
                              "kinds.json");
  EXPECT_EQ(s.hatch.field.name, "isoparametric");
  EXPECT_EQ(s.tone.ambient, 0.2);
  ASSERT_EQ(stroke_kind_count(s), 4u);
  const HatchStyle& dots = hatch_of(s, 2);
  EXPECT_EQ(dots.placing, "dots");
  EXPECT_EQ(dots.select, "a;b");
  EXPECT_EQ(dots.share, 2);
  EXPECT_EQ(dots.width_max, 0.5);
  EXPECT_EQ(dots.taper, 1.5);  // from the first
  EXPECT_EQ(tone_of(s, 2), s.tone);
  const HatchStyle& third = hatch_of(s, 3);
  EXPECT_EQ(third.placing, "even");  // of the first, not of the one before
  EXPECT_EQ(third.select, "*");
  EXPECT_EQ(third.field.name, "principal");
  EXPECT_EQ(tone_of(s, 3).law, "silhouette");
  EXPECT_EQ(hatch_of(s, 4).placing, "discs");
  const Style back = parse_style(style_to_json(s), "back.json");
  EXPECT_TRUE(back == s);
}

TEST(Style, KeysOfTheNextKindMakeIt) {
  Style s = builtin_style("outline");
  set_style_key(s, "strokes.2.placing", "dots");
  ASSERT_EQ(stroke_kind_count(s), 2u);
  EXPECT_FALSE(hatch_of(s, 1).enabled);
  EXPECT_TRUE(hatch_of(s, 2).enabled);
  EXPECT_TRUE(has_strokes(s));
  set_style_key(s, "strokes.1.taper", "7");
  EXPECT_EQ(s.hatch.taper, 7);
  const auto keys = style_keys(s);
  const auto key = std::ranges::find(keys, "strokes.2.placing", &StyleKey::name);
  ASSERT_NE(key, keys.end());
  EXPECT_EQ(key->value, "dots");
  EXPECT_EQ(
      parse_style(R"({"base": "outline", "strokes": [{}, {"placing": "dots"}]})", "f").strokes, [] {
        Style other = builtin_style("outline");
        set_style_key(other, "strokes.2.placing", "dots");
        return other.strokes;
      }());
}

TEST(Style, RefusesKindsOfStrokesInOneLine) {
  const auto set = [](const char* key, const char* value) {
    return usage_message([&] {
      Style s;
      set_style_key(s, key, value);
    });
  };
  EXPECT_TRUE(contains(set("strokes.3.placing", "dots"), "the next is number 2"));
  EXPECT_TRUE(contains(set("strokes.2.plcing", "dots"), "'strokes.2.placing'"));
  EXPECT_TRUE(contains(set("strokes.2.width_max", "11"), "'strokes.2.width_max' takes 0.01 to 10"));
  EXPECT_TRUE(contains(set("strokes.2.kind", "dot"), "'dots'"));
  EXPECT_TRUE(contains(set("strokes.0.kind", "dots"), "strokes.1.placing"));
  EXPECT_TRUE(contains(set("strokes.12.kind", "dots"), "strokes.1.placing"));
  EXPECT_TRUE(contains(set("strokes.2", "dots"), "strokes.1.placing"));
  Style s;
  set_style_key(s, "strokes.2.width_min", "5");
  EXPECT_TRUE(contains(usage_message([&] { check_style(s); }),
                       "'strokes.2.width_min' (5) is more than 'strokes.2.width_max'"));
  const auto message = [](const char* text) {
    return usage_message([&] { parse_style(text, "my.json"); });
  };
  EXPECT_TRUE(message("{\n\"strokes\": 3}").starts_with("my.json:2: style key 'strokes' takes"));
  EXPECT_TRUE(message("{\"strokes\": [\n{},\n4]}").starts_with("my.json:3: a stroke kind is"));
  EXPECT_TRUE(message("{\"strokes\": [\n{\n\"tone\": {\"lw\": 1}}]}")
                  .starts_with("my.json:3: unknown style key 'strokes.1.tone.lw'"));
  EXPECT_TRUE(message("{\"strokes\": [{},{},{},{},{},{},{},{},{},{}]}")
                  .starts_with("my.json:1: a style has at most 9"));
}

TEST(Nearest, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("veiw", "view"), 1u);
  const std::vector<std::string> known{"view", "verbose", "paper"};
  EXPECT_EQ(nearest("veiw", known), "view");
  EXPECT_EQ(nearest("x", {}), "");
}

TEST(StyleFiles, ANumberThatIsTooLargeIsNamedWithItsLine) {
  try {
    parse_style("{\"name\": \"a\",\n\"line.outer\": 1e999}", "mine.json");
    FAIL() << "it was read";
  } catch (const InputError& e) {
    EXPECT_EQ(e.line(), 2);
    EXPECT_NE(std::string(e.what()).find("too large"), std::string::npos) << e.what();
  }
}

TEST(StyleFiles, KeysThatHoldForAWholeDrawingCannotDifferByPart) {
  Style whole;
  set_style_key(whole, "sheet.ink", "#808080");
  const auto message = [&](const char* text) {
    return usage_message([&] { parse_style(text, "red.json", Style(), &whole); });
  };
  EXPECT_EQ(message("{\n\"sheet.ink\": \"#ff0000\"}"),
            "red.json:2: style key 'sheet.ink' holds for the whole drawing and cannot differ by "
            "part: parts have 'line.color' instead");
  EXPECT_TRUE(contains(message("{\"sheet\": {\n\"paper\": \"#ff0000\"}}"),
                       "red.json:2: style key 'sheet.paper' holds for the whole drawing"));
  for (const char* key :
       {"\"halo.gap\": 1", "\"depth.far\": 0.5", "\"svg.flatten\": true", "\"line.dash\": 5",
        "\"callout.circle\": false", "\"json.points3\": false", "\"sheet.clip\": false"}) {
    EXPECT_TRUE(contains(message(("{" + std::string(key) + "}").c_str()), "cannot differ by part"))
        << key;
  }
  // As the drawing has it, or as it was: nothing is asked for that is lost.
  EXPECT_EQ(message(R"({"sheet.ink": "#808080", "halo.gap": 0, "line.color": "#ff0000"})"),
            "no UsageError");
  EXPECT_EQ(message(R"({"base": "scratchboard", "line.outer": 2, "tone.ambient": 0.5})"),
            "no UsageError");
  EXPECT_EQ(keys_without_effect(builtin_style("scratchboard"), whole),
            (std::vector<std::string>{"sheet.ink", "sheet.paper"}));
  EXPECT_TRUE(keys_without_effect(builtin_style("engraving"), whole).empty());
  for (const StyleKey& key : style_keys(Style())) {
    const bool of_part =
        key.name.starts_with("hatch.") || key.name.starts_with("tone.") ||
        key.name.starts_with("feature.") || key.name.starts_with("fill.") ||
        (key.name.starts_with("line.") && key.name != "line.dash" && key.name != "line.gap");
    EXPECT_STREQ(key.scope(), of_part ? "part" : "drawing") << key.name;
  }
}

TEST(Style, ColorsMayBeThoseOfTheSheet) {
  for (const char* key : {"line.color", "hatch.color", "strokes.2.color"}) {
    Style s;
    set_style_key(s, key, "#12ab9F");
    EXPECT_NO_THROW(check_style(s));
    set_style_key(s, key, "");
    EXPECT_NO_THROW(check_style(s));
    set_style_key(s, key, "red");
    EXPECT_NO_THROW(check_style(s)) << "colours have names";
    set_style_key(s, key, "reddish");
    EXPECT_TRUE(contains(usage_message([&] { check_style(s); }),
                         "such as steelblue or nothing, not 'reddish'"))
        << key;
  }
}

}  // namespace
}  // namespace burin
