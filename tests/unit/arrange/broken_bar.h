#pragma once
/// A bar of which the middle is left out.

#include <burin/arrange/arrange.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

/// 20 x 20 x 400, seen from the front, with a break from 50 to 350.
class BrokenBar : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = {};
    scene_.parts = {part("bar", {0, 0, 0}, {20, 20, 400})};
    plan_ = {};
    plan_.view.paper = {297, 210};
    plan_.view.direction = {0, -1, 0};
    plan_.breaks = {along_z(50, 350)};
  }
  static Part part(const std::string& name, Vec3 low, Vec3 high) {
    return {name, "a.step", std::make_shared<MeshForm>(box(low, high))};
  }
  static Break along_z(double from, double to) {
    return {.axis = Vec3(0, 0, 1), .stretch = std::pair(from, to)};
  }
  void draw() {
    arrange_parts(scene_, plan_, context_);
    sheet_ = plan_sheet(scene_, plan_);
    drawing_ = illustrate(scene_, sheet_, plan_, context_);
  }
  /// The texts of the dimensions.
  std::vector<std::string> dimensions() const {
    std::vector<std::string> texts;
    for (const Layer& layer : drawing_.layers) {
      for (const Text& text : layer.texts) {
        if (layer.name == "dimensions") texts.push_back(text.text);
      }
    }
    return texts;
  }

  Scene scene_;
  Illustration plan_;
  SheetOfViews sheet_;
  Drawing drawing_;
  RunContext context_;
};

}  // namespace burin::test
