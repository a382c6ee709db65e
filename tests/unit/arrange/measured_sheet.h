#pragma once
/// Sheets with rows of dimensions.

#include <burin/arrange/arrange.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

inline FeatureRow at(Vec3 p) { return {.at = p}; }

class MeasuredSheet : public testing::Test {
 protected:
  using Kind = DimensionRow::Kind;
  using Texts = std::map<std::string, std::vector<std::string>>;

  void begin(Part part) {
    scene_ = {};
    plan_ = {};
    scene_.parts = {std::move(part)};
    plan_.view.paper = {297, 210};
    plan_.style.feature.crease_angle = 30;
  }
  DimensionRow& add(Kind kind, std::vector<FeatureRow> of) {
    DimensionRow row;
    row.kind = kind;
    row.of = std::move(of);
    return plan_.dimensions.emplace_back(row);
  }
  SheetOfViews planned() {
    arrange_parts(scene_, plan_, context_);
    return plan_sheet(scene_, plan_);
  }
  /// Of the dimensions of each view.
  Texts texts() {
    Texts texts;
    for (const PlacedView& view : planned().views) {
      for (const Dimension& one : view.dimensions.list) texts[view.name].push_back(one.text);
    }
    return texts;
  }
  std::string told(const char* code = "dimensions.not_drawn") const {
    for (const Diagnostic& one : scene_.diagnostics.entries()) {
      if (one.code == code) return one.message;
    }
    return "";
  }

  Scene scene_;
  Illustration plan_;
  RunContext context_;
};

}  // namespace burin::test
