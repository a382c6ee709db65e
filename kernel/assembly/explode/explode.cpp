#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/base/short_list.h>
#include <burin/explode/explode.h>
#include <burin/surface/placed_form.h>
#include <burin/surface/thread.h>
#include <burin/visibility/occluder.h>

#include "contacts.h"
#include "order.h"
#include "trails.h"
#include "travel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace burin {
namespace {

using detail::Node;

constexpr std::size_t kMostAxes = 12;
constexpr std::size_t kMostWithRays = 2000;

/// Takes levels apart, and what is in them.
class Opening {
 public:
  Opening(const detail::Situation& situation, Explosion& out)
      : s_(situation), out_(out), ways_(situation.shapes.boxes.size(), {Vec3(0)}) {}

  std::vector<ExplodeStep> open(std::vector<Node> nodes) {
    if (nodes.size() < 2) return {};
    detail::Level level = detail::take_apart(std::move(nodes), s_);
    for (auto& set : level.interlocked) out_.interlocked.push_back(std::move(set));
    std::vector<ExplodeStep> within;
    const auto enter = [&](const Node& node) {
      for (ExplodeStep& step : open(detail::inside(node, s_.shapes))) {
        within.push_back(std::move(step));
      }
    };
    for (const detail::Removal& removal : level.removals) {
      for (const Node& node : removal.nodes) enter(node);
    }
    enter(level.base);
    const std::vector<detail::Travel> ways = detail::travels(level, s_, ways_, crowded_);
    std::vector<ExplodeStep> steps;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const detail::Removal& removal = level.removals[i];
      ExplodeStep step{.along = s_.along(removal.direction), .by = ways[i].by};
      for (const Node& node : removal.nodes) {
        step.parts.insert(step.parts.end(), node.parts.begin(), node.parts.end());
      }
      std::ranges::sort(step.parts);
      steps.push_back(std::move(step));
    }
    follow(level, ways, steps);
    std::ranges::move(within, std::back_inserter(steps));
    return steps;
  }

  std::int64_t crowded() const { return crowded_; }

 private:
  /// What is off goes on with what it came off; equal ways are one step, without a trail.
  static void follow(const detail::Level& level, const std::vector<detail::Travel>& ways,
                     std::vector<ExplodeStep>& steps) {
    const std::size_t first = steps.size();
    for (std::size_t i = 0; i < ways.size(); ++i) {
      for (std::size_t n = 0; n < ways[i].follow.size(); ++n) {
        const double by = glm::length(ways[i].follow[n]);
        if (by == 0) continue;
        const Vec3 along = ways[i].follow[n] / by;
        constexpr double kSame = 1e-9;
        auto step = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end(),
                                 [&](const ExplodeStep& s) {
                                   return glm::distance(s.along, along) < kSame &&
                                          std::abs(s.by - by) < kSame * by;
                                 });
        if (step == steps.end())
          step = steps.insert(step, {.along = along, .by = by, .trail = false});
        const std::vector<std::size_t>& parts = level.removals[i].nodes[n].parts;
        step->parts.insert(step->parts.end(), parts.begin(), parts.end());
        std::ranges::sort(step->parts);
      }
    }
  }

  const detail::Situation& s_;
  Explosion& out_;
  detail::Ways ways_;
  std::int64_t crowded_ = 0;
};

}  // namespace

struct ExplodeModel::Impl {
  detail::Shapes shapes;
  std::unique_ptr<Occluder> occluder;
  std::vector<detail::Contact> contacts;
  std::vector<std::vector<detail::Neighbour>> neighbours;

  std::vector<Vec3> axes(const ExplodeOptions& options, Diagnostics& diagnostics) const {
    if (options.along) return {glm::normalize(*options.along)};
    std::vector<Vec3> axes = {shapes.frame[0], shapes.frame[1], shapes.frame[2]};
    if (shapes.parts.size() > kMostWithRays) return axes;
    std::vector<detail::WeightedAxis> touching;
    for (const detail::Contact& contact : contacts) {
      if (contact.axis != Vec3(0)) touching.push_back({contact.axis, contact.area});
    }
    std::int64_t left_out = 0;
    for (const detail::WeightedAxis& axis : detail::merged_axes(std::move(touching))) {
      const bool known = std::ranges::any_of(
          axes, [&](const Vec3& one) { return detail::same_axis(one, axis.axis); });
      if (known) continue;
      if (axes.size() < kMostAxes) {
        axes.push_back(axis.axis);
      } else {
        ++left_out;
      }
    }
    if (left_out > 0) {
      diagnostics.add(Severity::Info, "explode.directions", left_out,
                      fmt::format("{} axes of contacts, those of the smallest faces, were not "
                                  "tried as ways out of the assembly",
                                  left_out));
    }
    return axes;
  }

  std::string names(const std::vector<std::size_t>& parts) const {
    constexpr std::size_t kMost = 12;
    return short_list(parts, kMost,
                      [&](std::size_t part) { return "'" + shapes.paths[part] + "'"; });
  }

  void report(const Explosion& explosion, std::int64_t crowded, Diagnostics& diagnostics) const {
    for (const auto& set : explosion.interlocked) {
      diagnostics.add(Severity::Warning, "explode.interlocked",
                      static_cast<std::int64_t>(set.size()),
                      fmt::format("{} hold each other in every direction and stay together; where "
                                  "they are a press fit or a thread, an illustration file can give "
                                  "its depth in mm: \"explode\": {{\"fit\": 0.5}}",
                                  names(set)));
    }
    if (crowded > 0) {
      diagnostics.add(Severity::Warning, "explode.crowded", crowded,
                      fmt::format("{} steps found no free place after 1,000 tries; parts may lie "
                                  "in each other",
                                  crowded));
    }
    if (shapes.parts.size() > kMostWithRays) {
      diagnostics.add(Severity::Warning, "explode.boxes",
                      static_cast<std::int64_t>(shapes.parts.size()),
                      fmt::format("{} parts are more than 2,000: their boxes, not rays, decide "
                                  "which part blocks which",
                                  shapes.parts.size()));
    }
    std::set<std::size_t> things;
    for (const std::size_t part : shapes.parts) things.insert(shapes.things[part]);
    if (things.size() < 2) {
      diagnostics.add(Severity::Warning, "explode.alone", 1,
                      "there is one part; nothing comes apart");
    }
  }
};

ExplodeModel::ExplodeModel(const Scene& scene, const std::vector<bool>& drawn, RunContext& context)
    : impl_(std::make_unique<Impl>()) {
  impl_->shapes = detail::make_shapes(scene, drawn, context);
  context.begin_stage(RunStage::Build);
  impl_->occluder = std::make_unique<Occluder>(impl_->shapes.proxies, context);
  impl_->contacts = detail::find_contacts(impl_->shapes, *impl_->occluder, context);
  impl_->neighbours = detail::neighbours_of(impl_->contacts, scene.parts.size());
  context.end_stage();
}

ExplodeModel::~ExplodeModel() = default;
ExplodeModel::ExplodeModel(ExplodeModel&&) noexcept = default;

Explosion ExplodeModel::find(const ExplodeOptions& options, Diagnostics& diagnostics,
                             const RunContext& context) const {
  const detail::Shapes& shapes = impl_->shapes;
  std::vector<detail::AxisView> views;
  for (const Vec3& axis : impl_->axes(options, diagnostics)) {
    views.push_back(shapes.parts.size() > kMostWithRays
                        ? detail::boxes_along(axis, shapes, options.fit, context)
                        : detail::look_along(axis, shapes, *impl_->occluder, options.fit, context));
  }
  Explosion explosion;
  const detail::Situation situation{shapes, views, impl_->neighbours, options, context};
  Opening opening(situation, explosion);
  explosion.steps = opening.open(detail::inside({shapes.parts, 0}, shapes));
  impl_->report(explosion, opening.crowded(), diagnostics);
  return explosion;
}

std::vector<Curve3> ExplodeModel::trails(const std::vector<ExplodeStep>& steps, double factor,
                                         const std::vector<bool>& there) const {
  if (there.empty()) return detail::make_trails(steps, factor, impl_->shapes, impl_->contacts);
  std::vector<detail::Contact> contacts;
  for (const detail::Contact& contact : impl_->contacts) {
    if (there[contact.part] && there[contact.other]) contacts.push_back(contact);
  }
  return detail::make_trails(steps, factor, impl_->shapes, contacts);
}

double ExplodeModel::way_out(const std::vector<std::size_t>& moving,
                             const std::vector<std::size_t>& remaining, Vec3 along) const {
  const detail::Shapes& shapes = impl_->shapes;
  const Mat3 rows = detail::rows_along(along, shapes.frame);
  std::vector<Box3> boxes;
  for (const std::size_t part : remaining) boxes.push_back(shapes.box_along(part, rows));
  double by = 0;
  for (const std::size_t part : moving) {
    const Box3 box = shapes.box_along(part, rows);
    for (const Box3& other : boxes) {
      if (!box.empty() && !other.empty() && detail::overlap_across(box, other, 0)) {
        by = std::max(by, other.max.z - box.min.z);
      }
    }
  }
  return by;
}

std::span<const ProxyMesh* const> ExplodeModel::proxies() const { return impl_->shapes.proxies; }

std::vector<Vec3> moves_of(const std::vector<ExplodeStep>& steps, std::size_t count,
                           double factor) {
  std::vector<Vec3> moves(count, Vec3(0));
  for (const ExplodeStep& step : steps) {
    for (const std::size_t part : step.parts) moves[part] += factor * step.by * step.along;
  }
  return moves;
}

void move_parts(Scene& scene, const std::vector<Vec3>& moves) {
  std::map<const Form*, Placer> placers;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (moves[i] == Vec3(0)) continue;
    std::shared_ptr<const Form>& form = scene.parts[i].form;
    form = placers.try_emplace(form.get(), form).first->second.at({Mat3(1), moves[i]});
    for (Thread& thread : scene.parts[i].threads) thread = placed(thread, {Mat3(1), moves[i]});
    scene.parts[i].pmi.move({Mat3(1), moves[i]});
  }
}

std::vector<std::string> selectors_of(const Scene& scene, const std::vector<std::size_t>& parts) {
  const auto meant = [&](std::size_t part) { return std::ranges::binary_search(parts, part); };
  // Whether a selector names some parts that are meant and none that are not.
  const auto names = [&](const std::string& selector) -> std::vector<std::size_t> {
    try {
      std::vector<std::size_t> found = select(scene, selector);
      if (std::ranges::all_of(found, meant)) return found;
    } catch (const UsageError&) {
    }
    return {};
  };
  std::vector<std::string> selectors;
  std::vector<bool> named(scene.parts.size(), false);
  for (const std::size_t part : parts) {
    if (named[part]) continue;
    const Part& one = scene.parts[part];
    std::string path;
    std::vector<std::string> tried;
    for (const std::string& name : one.assembly) tried.push_back(path += "/" + name);
    tried.push_back(path + "/" + one.name);
    tried.push_back(fmt::format("@index={}", part));
    for (const std::string& selector : tried) {
      const std::vector<std::size_t> found = names(selector);
      if (!std::ranges::binary_search(found, part)) continue;
      selectors.push_back(selector);
      for (const std::size_t p : found) named[p] = true;
      break;
    }
  }
  return selectors;
}

}  // namespace burin
