// Plug-ins as a user of the command has them: folders of shared libraries.
#include "models.h"

#include <burin_test/irregular.h>
#include <burin_test/sanitized.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace burin {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Plug-ins of one folder; neither the user's nor what was tried before.
class Plugins : public test::CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    use("samples");
  }
  void TearDown() override {
    for (const char* name : {"XDG_DATA_HOME", "XDG_CACHE_HOME", "BURIN_PLUGIN_PATH"}) {
      ::unsetenv(name);
    }
  }

  static std::string built(const std::string& name) {
    return std::string(BURIN_PLUGINS) + "/" + name;
  }
  static void use(const std::string& folder) {
    ::setenv("BURIN_PLUGIN_PATH", built(folder).c_str(), 1);
  }
  /// A folder with some of the broken ones.
  void use_bad(const std::vector<std::string>& names) {
    fs::create_directory(folder_ / "bad");
    for (const std::string& name : names) {
      fs::copy_file(built("bad/" + name + ".so"), folder_ / ("bad/" + name + ".so"));
    }
    ::setenv("BURIN_PLUGIN_PATH", (folder_ / "bad").c_str(), 1);
  }

  json drawn(const std::string& options) {
    EXPECT_EQ(run("draw @/ball.off -o @/a.json --paper 80x80 --quiet " + options), 0) << err_;
    return json::parse(test::slurp(folder_ / "a.json"));
  }
  void write_ball() { folder_.write("ball.off", test::off_text(test::icosphere(10, 12))); }
  static std::vector<std::string> messages(const json& drawing, const std::string& code) {
    std::vector<std::string> found;
    for (const json& d : drawing["diagnostics"]) {
      if (d["code"] == code) found.push_back(d["message"]);
    }
    return found;
  }
};

TEST_F(Plugins, AreListedWithWhatTheyOffer) {
  ASSERT_EQ(run("plugins"), 0) << err_;
  for (const char* word :
       {"spiral 1.0", "burin.direction/1", "burin.law/1", "burin.form/1", "burin.reader/1",
        "burin.symbol/1", "gyroids", "tiny", "grain", "datum"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word << "\n" << out_;
  }
  EXPECT_EQ(out_.find("refused"), std::string::npos) << out_;
  ASSERT_EQ(run("plugins --json"), 0);
  const json told = json::parse(out_);
  EXPECT_EQ(told["plugins"].size(), 5U);
  EXPECT_EQ(told["path"][0], built("samples"));
}

TEST_F(Plugins, AreRefusedInOneLineEachAndTheOthersStay) {
  use("bad");
  ASSERT_EQ(run("plugins --json"), 0) << err_;
  std::map<std::string, std::string> refused;
  const json told = json::parse(out_);
  for (const json& p : told["plugins"]) {
    std::string why = p["refused"];
    if (why.empty()) why = p["offers"][0]["refused"];
    refused[fs::path(p["file"].get<std::string>()).stem()] = why;
    EXPECT_EQ(why.find('\n'), std::string::npos);
  }
  const std::map<std::string, std::string> expected = {
      {"make", "no licence"},
      {"crash_in_make", "crashes when it is tried out (signal 6"},
      {"crash", "crashes when it is tried out (signal 11"},
      {"hang", "did not end its trial within 5 s"},
      {"exit", "the trial gave no answer"},
      {"null", "does not work with plug-ins of version 1"},
      {"abi", "made for version 2"},
      {"symbol", "no symbol burin_plugin"},
      {"name", "a name that is not made of"},
      {"option", "a number outside its range"},
      {"taken", "taken by Burin's own"},
      {"nan", "no number"},
      {"count", "behind the end of an array"},
      {"lie", "answers otherwise"},
      {"symbol_color", "a fill whose colour is not #rrggbb"},
      {"symbol_size", "no width and height in mm"},
      {"symbol_later", ""},
      {"nan_later", ""},
      {"error_later", ""},
  };
  ASSERT_EQ(refused.size(), expected.size());
  for (const auto& [name, why] : expected) {
    if (test::kSanitized && name.starts_with("crash")) continue;  // the sanitizer ends it first
    EXPECT_NE(refused[name].find(why), std::string::npos) << name << ": " << refused[name];
    EXPECT_EQ(refused[name].empty(), why.empty()) << name << ": " << refused[name];
  }
}

/// A note of the ball in a symbol of a plug-in.
std::string note_in(const std::string& symbol, const std::string& more = "") {
  return R"({"burin": "illustration", "version": 1, "parts": [{"file": "ball.off"}],
"paper": "80x80", "notes": [{"at": "ball", "text": "A|flat", "symbol": ")" +
         symbol + "\"" + more + "}]}";
}

TEST_F(Plugins, SymbolsStandAtTheEndsOfNotes) {
  write_ball();
  const auto notes = [&](const std::string& more) {
    folder_.write("a.burin.json", note_in("datum", more));
    EXPECT_EQ(run("draw @/a.burin.json -o @/a.json --quiet"), 0) << err_;
    const json drawing = json::parse(test::slurp(folder_ / "a.json"));
    for (const json& layer : drawing["layers"]) {
      if (layer["name"] == "notes") return layer;
    }
    return json();
  };
  const json plain = notes("");
  ASSERT_EQ(plain["texts"].size(), 2U);
  EXPECT_EQ(plain["texts"][0]["text"], "A");
  EXPECT_EQ(plain["texts"][1]["text"], "flat");
  const auto frames = [](const json& layer) {
    double width = 0;
    int count = 0;
    for (const json& path : layer["paths"]) {
      if (!path.value("closed", false)) continue;
      ++count;
      width = path["width"][0];
    }
    EXPECT_EQ(count, 2);
    return width;
  };
  EXPECT_NEAR(frames(notes(", \"datum_bold\": true")), 2 * frames(plain), 1e-9);
  folder_.write("a.burin.json", note_in("datum", ", \"datum_bold\": 7"));
  EXPECT_EQ(run("draw @/a.burin.json -o @/a.json"), 2);
  EXPECT_NE(err_.find("datum_bold"), std::string::npos) << err_;
  folder_.write("a.burin.json", note_in("datun"));
  EXPECT_EQ(run("draw @/a.burin.json -o @/a.json"), 2);
  EXPECT_NE(err_.find("datum"), std::string::npos) << err_;
}

TEST_F(Plugins, ASymbolThatFailsLeavesTheWords) {
  write_ball();
  use_bad({"symbol_later"});
  folder_.write("a.burin.json", note_in("later"));
  ASSERT_EQ(run("draw @/a.burin.json -o @/a.json --quiet"), 0) << err_;
  const json drawing = json::parse(test::slurp(folder_ / "a.json"));
  const auto told = messages(drawing, "plugin.quarantined");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("no bar please"), std::string::npos) << told[0];
  bool words = false;
  for (const json& layer : drawing["layers"]) {
    for (const json& text : layer.value("texts", json::array())) words |= text["text"] == "A|flat";
  }
  EXPECT_TRUE(words);
}

TEST_F(Plugins, DirectionsAndLawsDrawByNameWithTheirOptions) {
  write_ball();
  const std::string engraving = "--style engraving --set hatch.field=";
  const json plain = drawn(engraving + "fixed");
  const json spiral = drawn(engraving + "spiral");
  const json steep = drawn(engraving + "spiral --set hatch.spiral.climb=60");
  EXPECT_GT(spiral["stats"]["strokes"], 20);
  EXPECT_NE(spiral["layers"], plain["layers"]);
  EXPECT_NE(spiral["layers"], steep["layers"]);
  EXPECT_TRUE(messages(spiral, "plugin.quarantined").empty());
  const std::string grain = "--style stipple --set tone.law=grain";
  EXPECT_NE(drawn(grain)["layers"], drawn("--style stipple")["layers"]);
  EXPECT_NE(drawn(grain)["layers"], drawn(grain + " --set tone.grain.steps=1")["layers"]);

  EXPECT_EQ(run("draw @/ball.off -o @/b.svg --set hatch.spiral.climb=100"), 2);
  expect_error("takes -89 to 89, not '100'");
  EXPECT_EQ(run("draw @/ball.off -o @/b.svg --set hatch.spiral.climd=1"), 2);
  expect_error("hatch.spiral.climb");
}

TEST_F(Plugins, SameBytesForAnyNumberOfThreads) {
  write_ball();
  for (const char* options : {"--style engraving --set hatch.field=spiral --threads ",
                              "--style stipple --set tone.law=grain --threads "}) {
    drawn(options + std::string("1"));
    const std::string one = test::slurp(folder_ / "a.json");
    drawn(options + std::string("4"));
    EXPECT_EQ(test::slurp(folder_ / "a.json"), one) << options;
  }
}

TEST_F(Plugins, OptionsAreToldLikeOurOwn) {
  ASSERT_EQ(run("styles --keys"), 0);
  EXPECT_NE(out_.find("hatch.spiral.climb"), std::string::npos);
  EXPECT_NE(out_.find("tone.grain.steps"), std::string::npos);
  ASSERT_EQ(run("options --style-schema"), 0);
  const json schema = json::parse(out_)["properties"];
  EXPECT_EQ(schema["hatch"]["properties"]["spiral.climb"]["maximum"], 89);
  EXPECT_EQ(schema["tone.grain.steps"]["type"], "integer");
  const json words = schema["hatch.field"]["enum"];
  EXPECT_NE(std::find(words.begin(), words.end(), "spiral"), words.end());
  EXPECT_TRUE(schema["strokes"]["items"]["properties"].contains("spiral.climb"));
  ASSERT_EQ(run("draw --help"), 0);
  for (const char* word : {"--tiny-scale", "--gyroids-period", "--gyroids-surface"}) {
    EXPECT_NE(out_.find(word), std::string::npos) << word;
  }
  ASSERT_EQ(run("options --json"), 0);
  EXPECT_NE(out_.find("gyroids_wall"), std::string::npos);
}

TEST_F(Plugins, StylesAndIllustrationsNameThem) {
  write_ball();
  folder_.write("own.json", R"({"base": "engraving", "hatch": {"field": "spiral",
    "spiral.climb": 40}, "strokes": [{}, {"field": "spiral", "spiral.climb": -40}]})");
  const json two = drawn("--style @/own.json");
  EXPECT_GT(two["stats"]["strokes"], 40);
  folder_.write("all.burin.json", R"({"burin": "illustration", "version": 1,
    "parts": [{"file": "form:gyroids", "gyroids_size": 20}, {"file": "ball.off"}],
    "style": "own.json", "paper": "80x80"})");
  ASSERT_EQ(run("draw @/all.burin.json -o @/b.json --quiet"), 0) << err_;
  const json both = json::parse(test::slurp(folder_ / "b.json"));
  ASSERT_EQ(both["parts"].size(), 2U);
  EXPECT_EQ(both["parts"][0]["name"], "gyroids");
  EXPECT_EQ(both["parts"][0]["source"], "form:gyroids");
}

TEST_F(Plugins, FormsAreDrawnAndMeasured) {
  ASSERT_EQ(run("info form:gyroids --gyroids-size 20 --json"), 0) << err_;
  const json part = json::parse(out_)["files"][0]["parts"][0];
  EXPECT_NEAR(part["bounds"]["max"][0].get<double>(), 10, 1e-6);
  // Walls of 2 mm with some 2.4 / period mm2 a mm3 of surface.
  EXPECT_NEAR(part["volume"].get<double>() / 8000, 2 * 3.09 / 15, 0.06);
  ASSERT_EQ(run("draw form:gyroids --gyroids-size 20 -o @/g.json --quiet --style outline --verify"),
            0)
      << err_;
  ASSERT_EQ(run("draw form:nothing -o @/g.json"), 2);
  expect_error("there are gyroids");
  use("other");
  ASSERT_EQ(run("info form:ring --json"), 0) << err_;
  const json ring = json::parse(out_)["files"][0]["parts"][0];
  constexpr double kPi = 3.141592653589793;
  EXPECT_NEAR(ring["volume"].get<double>(), 2 * kPi * kPi * 10 * 9, 2);
  EXPECT_TRUE(ring["closed"].get<bool>());
}

TEST_F(Plugins, ReadersReadAndSayTheLineOfAFault) {
  const std::string shelf = std::string(BURIN_SOURCE_DIR) + "/samples/plugins/shelf.tiny";
  ASSERT_EQ(run("info " + shelf + " --json"), 0) << err_;
  const json file = json::parse(out_)["files"][0];
  ASSERT_EQ(file["parts"].size(), 5U);
  EXPECT_EQ(file["parts"][0]["name"], "left");
  EXPECT_NEAR(file["parts"][0]["volume"].get<double>(), 2 * 20 * 60, 1e-6);
  ASSERT_EQ(run("info " + shelf + " --tiny-scale 2 --json"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["files"][0]["parts"][0]["volume"].get<double>(), 8 * 2400, 1e-6);
  ASSERT_EQ(run("draw " + shelf + " -o @/a.svg --quiet"), 0) << err_;
  folder_.write("bad.tiny", "box a 0 0 0 1 1 1\nbox b 0 0 0 1 1\n");
  ASSERT_EQ(run("draw @/bad.tiny -o @/b.svg"), 3);
  expect_error("bad.tiny:2: a box has a name and six numbers");
  folder_.write("none.tiny", "# nothing\n");
  ASSERT_EQ(run("draw @/none.tiny -o @/b.svg"), 3);
  expect_error("finds no part");
  EXPECT_FALSE(fs::exists(folder_ / "b.svg"));
}

TEST_F(Plugins, WritersWriteAndLeaveNothingHalfDone) {
  use("other");
  ASSERT_EQ(run("draw @/box.off -o @/a.lst -o @/a.json --style outline --quiet --set lst.digits=3"),
            0)
      << err_;
  const std::string list = test::slurp(folder_ / "a.lst");
  std::int64_t paths = 0;
  const json drawing = json::parse(test::slurp(folder_ / "a.json"));
  for (const json& layer : drawing["layers"]) {
    paths += static_cast<std::int64_t>(layer["paths"].size());
  }
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), paths);
  EXPECT_NE(list.find("contour 2 0.700"), std::string::npos) << list;
  EXPECT_EQ(run("draw @/box.off -o @/b.lst --quiet --set lst.digits=0"), 4);
  expect_error("writes nothing");
  EXPECT_FALSE(fs::exists(folder_ / "b.lst"));
  ASSERT_EQ(run("convert @/a.json -o @/c.lst --quiet --set lst.digits=3"), 0) << err_;
}

TEST_F(Plugins, WritersGetColorsAndAreas) {
  use("other");
  ASSERT_EQ(run("draw @/box.off -o @/a.lar -o @/a.lbr -o @/a.json --style flat --quiet"
                " --set fill.color=#ff8000 --set fill.ink=Spot --set line.color=#003060"),
            0)
      << err_;
  const std::string list = test::slurp(folder_ / "a.lar");
  EXPECT_TRUE(list.starts_with("#003060 1 Spot\n")) << list;
  const json areas = json::parse(test::slurp(folder_ / "a.json"))["areas"];
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'),
            static_cast<std::int64_t>(areas.size()) + 1);
  EXPECT_NE(list.find("0 -1 -1 #ffd9b3 1.000 Spot 0.300 [] "), std::string::npos) << list;
  // Where a plug-in has both, the newer interface writes.
  EXPECT_EQ(list, test::slurp(folder_ / "a.lbr"));
}

TEST_F(Plugins, StrokeKindsStandOnPoints) {
  use("other");
  write_ball();
  const json stars = drawn("--style pencil --set hatch.placing=stars");
  EXPECT_GT(stars["stats"]["strokes"], 50);
  EXPECT_NE(stars["layers"],
            drawn("--style pencil --set hatch.placing=stars --set hatch.stars.rays=3")["layers"]);
}

TEST_F(Plugins, OneThatFailsWhileDrawingIsLeftOutWithADiagnostic) {
  use_bad({"nan_later", "error_later"});
  write_ball();
  const json plain = drawn("--style engraving --set hatch.field=fixed-auto");
  for (const auto& [name, why] : {std::pair{"nan-later", "no number"},
                                  std::pair{"error-later", "fails (error 1): too far off"}}) {
    const json drawing = drawn("--style engraving --set hatch.field=" + std::string(name));
    const auto told = messages(drawing, "plugin.quarantined");
    ASSERT_EQ(told.size(), 1U) << name;
    EXPECT_NE(told[0].find(why), std::string::npos) << told[0];
    EXPECT_NE(told[0].find("hatch.field=fixed-auto"), std::string::npos) << told[0];
    EXPECT_EQ(drawing["stats"]["strokes"], plain["stats"]["strokes"]);
  }
}

TEST_F(Plugins, AFormThatFailsTakesItsPartsAlongAndNoOthers) {
  use("other");
  // While it is read, which looks for its bounds, and while it is drawn.
  for (const char* most : {"1", "70000"}) {
    ASSERT_EQ(run("draw form:ball @/box.off -o @/a.json --quiet --ball-most " + std::string(most)),
              0)
        << err_;
    const json drawing = json::parse(test::slurp(folder_ / "a.json"));
    const auto told = messages(drawing, "plugin.quarantined");
    ASSERT_EQ(told.size(), 1U) << most;
    EXPECT_NE(told[0].find("goes on without"), std::string::npos) << told[0];
    EXPECT_EQ(drawing["parts"].size(), std::string(most) == "1" ? 1U : 2U);
  }
  EXPECT_EQ(run("draw form:ball -o @/b.json --quiet --ball-most 1"), 1);
  expect_error("the form 'ball'");
}

TEST_F(Plugins, RefusedOnesAreToldInEachDrawingAndTriedOnce) {
  if (test::kSanitized) GTEST_SKIP() << "the sanitizer ends a crash in its own way";
  use_bad({"crash"});
  write_ball();
  for (int i = 0; i < 2; ++i) {
    const auto told = messages(drawn("--style outline"), "plugin.refused");
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NE(told[0].find("crashes"), std::string::npos);
  }
  EXPECT_TRUE(fs::exists(folder_ / "cache/burin/plugins.json"));
  // What stands in the cache is believed as long as the file is the same.
  std::string cached = test::slurp(folder_ / "cache/burin/plugins.json");
  cached.replace(cached.find("it crashes"), 10, "it was bad");
  folder_.write("cache/burin/plugins.json", cached);
  EXPECT_NE(messages(drawn("--style outline"), "plugin.refused").at(0).find("it was bad"),
            std::string::npos);
  folder_.write("cache/burin/plugins.json", "{\"format\": 7");
  EXPECT_NE(messages(drawn("--style outline"), "plugin.refused").at(0).find("crashes"),
            std::string::npos);
}

TEST_F(Plugins, NothingIsLoadedFromTheFolderOfAnInputOrARelativeOne) {
  write_ball();
  fs::copy_file(built("bad/crash.so"), folder_ / "crash.so");
  ::unsetenv("BURIN_PLUGIN_PATH");
  EXPECT_TRUE(messages(drawn("--style outline"), "plugin.refused").empty());
  ::setenv("BURIN_PLUGIN_PATH", ".:plugins", 1);
  ASSERT_EQ(run("plugins"), 0);
  EXPECT_NE(out_.find("takes absolute paths"), std::string::npos) << out_;
}

}  // namespace
}  // namespace burin
