#include <burin/base/error.h>
#include <burin/drawing/writers.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/session.h>
#include <burin/section/section.h>
#include <burin/surface/placed_form.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace burin {
namespace {

// A form that counts how often it is realised.
class Counting final : public Form {
 public:
  explicit Counting(std::shared_ptr<const Form> form) : form_(std::move(form)) {}

  Box3 bounds(const Mat3& axes) const override { return form_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    ++count;
    return form_->realise(options, context);
  }
  bool looks_at_view() const override { return form_->looks_at_view(); }

  mutable int count = 0;

 private:
  std::shared_ptr<const Form> form_;
};

// A surface that counts how often its normal is asked for.
class CountingSurface final : public Surface {
 public:
  CountingSurface(std::shared_ptr<const Surface> surface, std::atomic<int>& count)
      : surface_(std::move(surface)), count_(count) {}

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    return surface_->march(from, tangent, length);
  }
  Frame frame(const SurfacePoint& point) const override {
    ++count_;
    return surface_->frame(point);
  }
  const ProxyMesh& proxy() const override { return surface_->proxy(); }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    return surface_->to_proxy(point);
  }
  SurfacePoint lift(const ProxyPoint& point) const override { return surface_->lift(point); }
  bool exact() const override { return true; }

 private:
  std::shared_ptr<const Surface> surface_;
  std::atomic<int>& count_;
};

class CountedNormals final : public Form {
 public:
  explicit CountedNormals(TriMesh mesh) : form_(std::move(mesh)) {}

  Box3 bounds(const Mat3& axes) const override { return form_.bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    return std::make_shared<CountingSurface>(form_.realise(options, context), count);
  }
  bool looks_at_view() const override { return false; }

  mutable std::atomic<int> count = 0;

 private:
  MeshForm form_;
};

std::string session_json(const Drawing& drawing) {
  RunContext context;
  std::ostringstream out;
  write_json(drawing, {}, out, context);
  return out.str();
}

// A ball of facets behind a wall, and a torus that is a function.
class SessionTest : public ::testing::Test {
 protected:
  SessionTest() {
    TriMesh wall = test::box({-20, -2, -20}, {20, 2, 20});
    for (Vec3& p : wall.positions) p.y -= 25;
    RunContext context;
    ball_ = std::make_shared<Counting>(
        std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 96, 48)));
    ring_ = std::make_shared<Counting>(std::make_shared<ImplicitForm>(
        make_function(implicit::torus(12, 4)), std::nullopt, context));
    scene_.parts.push_back({"wall", "wall", std::make_shared<MeshForm>(std::move(wall))});
    scene_.parts.push_back({"ball", "ball", ball_});
    scene_.parts.push_back(
        {"ring", "ring", placed(ring_, {.linear = rotation({30, 0, 0}), .offset = {35, 0, 0}})});
  }

  Camera camera() const {
    return Camera::fit([&](const Mat3& a) { return scene_.bounds(a); },
                       {.direction = direction_, .scale = paper_scale_, .paper = {100, 70}});
  }

  // The session's drawing, which has to be that of a fresh run.
  std::string draw() {
    RunContext context;
    std::string kept = session_json(session_.draw(scene_, camera(), style_, options_, context));
    EXPECT_EQ(kept, session_json(illustrate(scene_, camera(), style_, options_, context)));
    return kept;
  }
  // How often the session realised it in a drawing.
  int realised(const std::shared_ptr<Counting>& form) {
    RunContext context;
    const int before = form->count;
    session_.draw(scene_, camera(), style_, options_, context);
    return form->count - before;
  }

  Scene scene_;
  std::shared_ptr<Counting> ball_, ring_;
  Vec3 direction_{1, -2, 1};
  double paper_scale_ = 1;
  Style style_ = builtin_style("engraving");
  IllustrateOptions options_;
  Session session_;
};

TEST_F(SessionTest, DrawsTheSameBytesWhateverChanges) {
  const std::string first = draw();
  style_.tone.light = {0.8, 0.3, 0.5};
  const std::string lit = draw();
  EXPECT_NE(first, lit);
  style_.line.outer = 0.9;
  style_.hatch.width_max *= 0.8;
  draw();
  style_.hatch.spacing_min *= 1.3;
  draw();
  options_.part_styles.resize(3);
  options_.part_styles[1].style = builtin_style("technical");
  draw();
  options_.part_styles[0].transparent = true;
  draw();
  options_.part_styles[2].drawn = false;
  draw();
  options_.part_styles[2].drawn = true;
  options_.part_styles[0].transparent = false;
  draw();
  direction_ = {1, -1, 0.4};
  draw();
  options_.seed = 5;
  options_.hidden = HiddenLines::Dashed;
  style_.halo.gap = 0.5;
  draw();
  options_ = {};
  direction_ = {1, -2, 1};
  style_ = builtin_style("engraving");
  EXPECT_EQ(draw(), first);
}

TEST_F(SessionTest, PaintsTheSameBytesWhateverChanges) {
  style_ = builtin_style("shaded");
  const std::string first = draw();
  style_.fill.color = "#aa3300";
  EXPECT_NE(draw(), first);
  style_.fill.opacity = 0.5;
  draw();
  style_.fill.steps = 4;
  draw();
  style_.fill.darkest = 0.2;
  draw();
  style_.tone.light = {0.8, 0.3, 0.5};
  draw();
  style_.shadow.color = "#000080";
  draw();
  options_.face_areas = true;
  draw();
  options_.part_styles.resize(3);
  options_.part_styles[0].transparent = true;
  draw();
  options_.part_styles[0].style = style_;
  options_.part_styles[0].style->fill.color = "#00ff00";
  draw();
  options_.part_styles[1].style = style_;
  options_.part_styles[1].style->fill.shadow = false;
  draw();
  options_.part_styles[0].transparent = false;
  direction_ = {1, -1, 0.4};
  draw();
  options_ = {};
  direction_ = {1, -2, 1};
  style_ = builtin_style("shaded");
  EXPECT_EQ(draw(), first);
}

TEST_F(SessionTest, AreasStayWhereAColourChanges) {
  const auto counted = std::make_shared<CountedNormals>(test::ellipsoid({10, 10, 10}, 96, 48));
  scene_.parts[1].form = counted;
  style_ = builtin_style("cel");
  const auto normals = [&] {
    RunContext context;
    const int before = counted->count;
    session_.draw(scene_, camera(), style_, options_, context);
    return counted->count - before;
  };
  EXPECT_GT(normals(), 0);
  EXPECT_EQ(normals(), 0);
  style_.fill.color = "#aa3300";
  style_.fill.opacity = 0.5;
  style_.fill.darkest = 0.3;
  style_.line.outer = 0.9;
  EXPECT_EQ(normals(), 0);
  style_.fill.opacity = 1;
  EXPECT_EQ(normals(), 0);
  style_.fill.steps = 4;
  EXPECT_GT(normals(), 0);
  style_.tone.light = {0.8, 0.3, 0.5};
  EXPECT_GT(normals(), 0);
  direction_ = {1, -1, 0.4};
  EXPECT_GT(normals(), 0);
}

TEST_F(SessionTest, MakesAnewWhatAChangeAsksFor) {
  EXPECT_EQ(realised(ball_), 1);
  EXPECT_EQ(realised(ball_), 0);
  style_.tone.light = {0.8, 0.3, 0.5};
  EXPECT_EQ(realised(ball_), 0);
  EXPECT_EQ(realised(ring_), 0);
  direction_ = {1, -1, 0.4};
  EXPECT_EQ(realised(ball_), 0) << "facets look at no view";
  direction_ = {1, -1, 0.3};
  EXPECT_EQ(realised(ring_), 1) << "an exact form is cut along the contours of each view";
  style_.feature.crease_angle = 50;
  EXPECT_EQ(realised(ball_), 1);
}

TEST_F(SessionTest, FacetsThatAreFineEnoughStayInASmallerDrawing) {
  const auto fine =
      std::make_shared<Counting>(std::make_shared<MeshForm>(test::ellipsoid({10, 10, 10}, 96, 48)));
  scene_.parts[1].form = fine;
  EXPECT_EQ(realised(fine), 1);
  paper_scale_ = 0.75;
  EXPECT_EQ(realised(fine), 0);
  draw();
  paper_scale_ = 20;  // here they are rounded
  EXPECT_EQ(realised(fine), 1);
  paper_scale_ = 0.75;
  EXPECT_EQ(realised(fine), 1);
  draw();
}

TEST_F(SessionTest, TakesAFormThatIsPlacedOrCutTheSameWayAgain) {
  const Placement place{.linear = rotation({0, 0, 40}), .offset = {35, 0, 0}};
  const Placer placer(ring_);
  const CutPlane plane{.normal = {0, 1, 0}, .offset = 1};
  const auto put = [&](const Placement& where, const CutPlane& cut) {
    scene_.parts[2].form = cut_form(placer.at(where), cut, 0, "ring");
  };
  put(place, plane);
  EXPECT_EQ(realised(ring_), 1);
  put(place, plane);
  EXPECT_EQ(realised(ring_), 0);
  draw();
  put(place, {.normal = {0, 1, 0}, .offset = 2});
  draw();
  Placement other = place;
  other.offset.x = 40;
  put(other, plane);
  draw();
}

TEST_F(SessionTest, LosesNothingWhereADrawingIsCancelled) {
  const std::string first = draw();
  style_.tone.light = {0.8, 0.3, 0.5};
  for (const char* stage : {"field", "trace", "compose"}) {
    RunContext* running = nullptr;
    RunContext context([&](const std::string& name, double) {
      if (name == stage) running->cancel();
    });
    running = &context;
    try {
      session_.draw(scene_, camera(), style_, options_, context);
    } catch (const Cancelled&) {
    }
    EXPECT_EQ(realised(ball_), 0) << stage;
    draw();
    style_.tone.light.x += 0.1;
  }
}

TEST_F(SessionTest, TellsTheSameOfWhatItKept) {
  // A surface with a hole, strokes without a direction: words that belong to stages that are kept.
  TriMesh open = test::box({-5, -5, -5}, {5, 5, 5});
  open.triangles.pop_back();
  scene_.parts.push_back(
      {"open", "open",
       cut_form(std::make_shared<MeshForm>(open), {.normal = {0, 0, 1}, .offset = 0}, 0, "open")});
  style_.hatch.field.name = "principal";
  RunContext context;
  const auto words = [&] {
    std::vector<std::string> out;
    const Drawing drawing = session_.draw(scene_, camera(), style_, options_, context);
    for (const Diagnostic& d : drawing.diagnostics.entries()) out.push_back(d.code + d.message);
    return out;
  };
  const auto first = words();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(words(), first);
  style_.line.outer = 0.9;
  EXPECT_EQ(words(), first);
}

TEST_F(SessionTest, AToneOfTheCallersOwnIsAskedEachTime) {
  double dark = 0.3;
  options_.tone = [&](const HatchScene&) { return [dark](Vec3, Vec3) { return 1 - dark; }; };
  const std::string light = draw();
  dark = 0.6;
  EXPECT_NE(draw(), light);
}

}  // namespace
}  // namespace burin
