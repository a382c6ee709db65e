#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/placed_form.h>

#include "burin_test/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace burin {
namespace {

std::shared_ptr<const Form> box_at(double x) {
  TriMesh mesh = test::box({-4, -4, -4}, {4, 4, 4});
  for (Vec3& p : mesh.positions) p.x += x;
  return std::make_shared<MeshForm>(std::move(mesh));
}

// What realises a form at the moment, and which threads did.
struct SeenBeside {
  std::atomic<int> now{0}, most{0}, count{0};
  std::mutex mutex;
  std::set<std::thread::id> threads;
};

// A box that takes its time.
class SlowForm final : public Form {
 public:
  SlowForm(double x, std::shared_ptr<SeenBeside> seen, bool beside_others)
      : form_(box_at(x)), seen_(std::move(seen)), beside_others_(beside_others) {}

  Box3 bounds(const Mat3& axes) const override { return form_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    ++seen_->count;
    const int now = ++seen_->now;
    for (int most = seen_->most; most < now && !seen_->most.compare_exchange_weak(most, now);) {
    }
    {
      const std::lock_guard lock(seen_->mutex);
      seen_->threads.insert(std::this_thread::get_id());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    auto surface = form_->realise(options, context);
    --seen_->now;
    return surface;
  }
  bool realised_beside_others() const override { return beside_others_; }

 private:
  std::shared_ptr<const Form> form_;
  std::shared_ptr<SeenBeside> seen_;
  bool beside_others_;
};

// Tells of itself, or fails.
class TellingForm final : public Form {
 public:
  TellingForm(double x, std::string text, bool fails)
      : form_(box_at(x)), text_(std::move(text)), fails_(fails) {}

  Box3 bounds(const Mat3& axes) const override { return form_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    if (fails_) throw GeometryError(text_);
    options.diagnostics->add(Severity::Info, "test." + text_, 1, text_);
    return form_->realise(options, context);
  }
  bool realised_beside_others() const override { return true; }

 private:
  std::shared_ptr<const Form> form_;
  std::string text_;
  bool fails_;
};

// Goes on until it is told to stop.
class EndlessForm final : public Form {
 public:
  explicit EndlessForm(double x) : form_(box_at(x)) {}

  Box3 bounds(const Mat3& axes) const override { return form_->bounds(axes); }
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      context.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return form_->realise(options, context);
  }
  bool realised_beside_others() const override { return true; }

 private:
  std::shared_ptr<const Form> form_;
};

Scene scene_beside(const std::vector<std::shared_ptr<const Form>>& forms) {
  Scene scene;
  for (const auto& form : forms) {
    const std::string name = "part " + std::to_string(scene.parts.size());
    scene.parts.push_back({name, name, form});
  }
  return scene;
}

Drawing drawn(const Scene& scene, RunContext& context) {
  const Camera camera = Camera::fit([&](const Mat3& a) { return scene.bounds(a); },
                                    {.direction = {1, -2, 1}, .paper = {200, 140}});
  return illustrate(scene, camera, builtin_style("outline"), {}, context);
}

TEST(RealisedBeside, FormsThatDoNotAllowItAreRealisedByTheCallerOneByOne) {
  const auto seen = std::make_shared<SeenBeside>();
  std::vector<std::shared_ptr<const Form>> forms;
  for (int i = 0; i < 6; ++i) forms.push_back(std::make_shared<SlowForm>(12 * i, seen, false));
  RunContext context;
  drawn(scene_beside(forms), context);
  EXPECT_EQ(seen->most, 1);
  EXPECT_EQ(seen->threads, std::set{std::this_thread::get_id()});
}

TEST(RealisedBeside, CopiesOfOneFormAreRealisedOnce) {
  const auto seen = std::make_shared<SeenBeside>();
  const Placer placer(std::make_shared<SlowForm>(0, seen, true));
  std::vector<std::shared_ptr<const Form>> forms{box_at(-20)};
  for (int i = 1; i < 6; ++i) {
    Placement by;
    by.offset = {12.0 * i, 0, 0};
    forms.push_back(placer.at(by));
  }
  RunContext context;
  drawn(scene_beside(forms), context);
  EXPECT_EQ(seen->count, 1);
}

TEST(RealisedBeside, WhatIsSaidStandsInTheOrderOfTheParts) {
  std::vector<std::shared_ptr<const Form>> forms;
  for (int i = 0; i < 8; ++i) {
    forms.push_back(
        std::make_shared<TellingForm>(12 * i, "form" + std::to_string(i), i == 2 || i == 5));
  }
  for (int run = 0; run < 20; ++run) {
    RunContext context;
    const Drawing drawing = drawn(scene_beside(forms), context);
    std::vector<std::string> texts;
    for (const Diagnostic& d : drawing.diagnostics.entries()) {
      if (d.code.starts_with("test.") || d.code == "part.not_drawn") texts.push_back(d.message);
    }
    EXPECT_EQ(texts, (std::vector<std::string>{
                         "form0", "form1", "part 2: the part was left out: form2", "form3", "form4",
                         "part 5: the part was left out: form5", "form6", "form7"}));
  }
}

TEST(RealisedBeside, AllAreCancelledWithTheRun) {
  std::vector<std::shared_ptr<const Form>> forms;
  for (int i = 0; i < 6; ++i) forms.push_back(std::make_shared<EndlessForm>(12 * i));
  RunContext context;
  std::jthread cancel([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    context.cancel();
  });
  EXPECT_THROW(drawn(scene_beside(forms), context), Cancelled);
}

TEST(RealisedBeside, APieceOfARunHasStagesOfItsOwn) {
  RunContext run;
  run.begin_stage(RunStage::Build);
  {
    RunContext piece = RunContext::piece_of(run);
    piece.begin_stage(RunStage::Curvature);
    piece.end_stage();
    run.cancel();
    EXPECT_THROW(piece.check(), Cancelled);
  }
  run.end_stage();
  ASSERT_EQ(run.stages().size(), 1U);
  EXPECT_EQ(run.stages()[0].stage, RunStage::Build);
}

}  // namespace
}  // namespace burin
