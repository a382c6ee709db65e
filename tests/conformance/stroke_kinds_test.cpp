/// Every kind of strokes on every form: there are strokes, or the drawing says why not.

#include <burin/field/catalogue.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/session.h>

#include "forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace burin {
namespace {

using test::FormCase;

class StrokeKindsOnAnyForm : public testing::TestWithParam<FormCase> {
 protected:
  void SetUp() override {
    static test::OfOneForm<Drawn> kept;
    drawn_ = &kept.get(GetParam().name, [] {
      auto drawn = std::make_unique<Drawn>();
      drawn->scene.parts.push_back({"part", "", GetParam().make()});
      return drawn;
    });
  }

  // Draws it small, in the same ink everywhere, and looks for strokes or for the reason of none.
  void expect_strokes_or_reason(const Style& style, const std::string& kind) {
    IllustrateOptions options;
    options.images["waves"] = waves_;
    RunContext context;
    const Camera camera = Camera::fit([&](const Mat3& axes) { return drawn_->scene.bounds(axes); },
                                      {.direction = {1, -1.2, 0.7}, .paper = {40, 30}});
    const Drawing drawing = drawn_->session.draw(drawn_->scene, camera, style, options, context);
    const bool reported =
        std::ranges::any_of(drawing.diagnostics.entries(),
                            [](const Diagnostic& d) { return d.code.starts_with("strokes.no_"); });
    EXPECT_TRUE(drawing.stats.strokes > 0 || reported) << kind;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        for (const Vec2& p : path.points) ASSERT_TRUE(std::isfinite(p.x + p.y)) << kind;
      }
    }
  }

  static Style plain(const std::string& field, const std::string& placing) {
    Style style = builtin_style("engraving");
    style.tone = {.law = "constant", .ambient = 0.4, .highlight = 1, .rim = 0};
    style.hatch.cross_from = 2;
    style.hatch.length_min = 0.5;
    style.hatch.image = "waves";
    style.hatch.field.name = field;
    style.hatch.placing = placing;
    return style;
  }

 private:
  // A session, so that the form is realised once for all kinds.
  struct Drawn {
    Scene scene;
    Session session;
  };

  static std::shared_ptr<const Image> make_waves() {
    constexpr int kSide = 64;
    auto image = std::make_shared<Image>(Image{kSide, kSide, {}});
    for (int i = 0; i < kSide * kSide; ++i) {
      image->values.push_back(
          static_cast<float>(0.5 + 0.4 * std::sin(0.2 * (i % kSide)) * std::cos(0.1 * i / kSide)));
    }
    return image;
  }

  Drawn* drawn_ = nullptr;
  std::shared_ptr<const Image> waves_ = make_waves();
};

// The words that a key takes.
std::vector<std::string> words_of(const std::string& key) {
  for (const StyleKey& k : style_keys(builtin_style("engraving"))) {
    if (k.name != key) continue;
    if (const auto* list = std::get_if<WordList>(&k.takes)) return list->words;
  }
  return {};
}

TEST_P(StrokeKindsOnAnyForm, OfEveryFieldAreDrawnOrSayWhyNot) {
  ASSERT_GE(field::catalogue().size(), 14u);
  for (const field::FieldKind& field : field::catalogue()) {
    for (const char* placing : {"even", "points"}) {
      expect_strokes_or_reason(plain(std::string(field.name), placing),
                               std::string(field.name) + ", " + placing);
    }
  }
}

TEST_P(StrokeKindsOnAnyForm, OfEveryPlacingAreDrawnOrSayWhyNot) {
  const std::vector<std::string> placings = words_of("hatch.placing");
  ASSERT_GE(placings.size(), 5u);
  for (const std::string& placing : placings) {
    // Levels are those of a field that has some.
    Style style = plain(placing == "levels" ? "planes" : "smoothed", placing);
    expect_strokes_or_reason(style, placing);
    if (!takes_motif(style.hatch)) continue;
    style.hatch.motif = "M0 0 L1 0 L0.5 1 Z";
    expect_strokes_or_reason(style, placing + " with a motif");
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, StrokeKindsOnAnyForm, testing::ValuesIn(test::form_cases()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace burin
