#include "threads.h"

#include <burin/threads/metric.h>

#include "document.h"
#include "thread_sizes.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

/// Of the minor diameter: what drills of a thread are narrower and wider by, at the most. Another
/// version of FreeCAD may have other lists of sizes: a drill tells whether this one is meant.
constexpr double kNarrowest = 0.93, kWidest = 0.8;
/// Model mm: through all.
constexpr double kThroughAll = 1e6;

std::int64_t whole(const pugi::xml_node& value) {
  return static_cast<std::int64_t>(std::clamp(number(value, "value", 0), -1.0, 1e9));
}

bool drilled_for(const ThreadSize& size, double drill) {
  const double minor = minor_diameter(size.diameter, size.pitch);
  return drill > kNarrowest * minor && drill < minor + kWidest * (size.diameter - minor);
}

std::optional<ThreadSize> size_of(const FcHole& hole) {
  auto listed = thread_size(hole.type, hole.size);
  if (listed && drilled_for(*listed, hole.diameter)) return listed;
  constexpr std::int64_t kIsoCoarse = 1;
  const auto coarse = coarse_of_minor(hole.diameter);
  if (hole.type != kIsoCoarse || !coarse) return std::nullopt;
  return ThreadSize{fmt::format("M{:g}", *coarse), *coarse, coarse_pitch(*coarse).value_or(0)};
}

const FcObject* object_named(const FcDocument& document, const std::string& name) {
  const std::int32_t number = document.find(name);
  return number < 0 ? nullptr : &document.objects()[static_cast<std::size_t>(number)];
}

/// One at each circle of the sketch.
void add_threads(const FcHole& hole, const ThreadSize& size, const FcObject& sketch,
                 std::vector<Thread>& out) {
  const double drilled = hole.depth_type == 0 ? hole.depth : kThroughAll;
  const Vec3 up = sketch.placement.vector({0, 0, 1});
  for (const Vec3& center : sketch.circles) {
    out.push_back({.axis = {sketch.placement.point(center), hole.reversed ? up : -up},
                   .begin = 0,
                   .end = std::min(hole.thread_depth.value_or(drilled), kThroughAll),
                   .major = 0.5 * size.diameter,
                   .minor = 0.5 * minor_diameter(size.diameter, size.pitch),
                   .internal = true,
                   .designation = size.designation});
  }
}

}  // namespace

void FcHole::take(std::string_view name, const pugi::xml_node& value) {
  if (name == "Threaded") threaded = truth(value);
  if (name == "ModelThread" || name == "ModelActualThread") modelled = modelled || truth(value);
  if (name == "Reversed") reversed = truth(value);
  if (name == "ThreadType") type = whole(value);
  if (name == "ThreadSize") size = whole(value);
  if (name == "Diameter") diameter = number(value, "value", 0);
  if (name == "DepthType") depth_type = whole(value);
  if (name == "Depth") depth = number(value, "value", 0);
  if (name == "ThreadDepth") thread_depth = number(value, "value", 0);
  if (name == "Profile") profile = text_of(value);
}

std::vector<Vec3> circle_centers(const pugi::xml_node& geometry) {
  constexpr std::size_t kModes = 2;  // the last bit but one: construction
  std::vector<Vec3> out;
  for (const pugi::xml_node& one : geometry.children("Geometry")) {
    const pugi::xml_node circle = one.child("Circle");
    if (!circle || std::string_view(one.attribute("type").value()) != "Part::GeomCircle") continue;
    bool construction = truth(one.child("Construction"));
    for (const pugi::xml_node& said : one.child("GeoExtensions").children("GeoExtension")) {
      const std::string_view modes = said.attribute("geometryModeFlags").value();
      construction |= modes.size() >= kModes && modes[modes.size() - kModes] == '1';
    }
    if (construction) continue;
    out.emplace_back(number(circle, "CenterX", 0), number(circle, "CenterY", 0),
                     number(circle, "CenterZ", 0));
  }
  return out;
}

namespace {

/// The threads of a body by the feature that made each.
class BodyThreads {
 public:
  BodyThreads(const FcDocument& document, LostThreads& lost) : document_(document), lost_(lost) {}

  void add(const std::string& name, const FcObject& object) {
    if (object.hole && object.hole->threaded && !object.hole->modelled) add_hole(name, object);
    if (object.pattern) add_pattern(name, object);
  }

  std::vector<Thread> all() && {
    std::vector<Thread> out;
    for (Made& one : made_) out.push_back(std::move(one.thread));
    return out;
  }

 private:
  struct Made {
    std::string feature;
    Thread thread;
  };

  void add_hole(const std::string& name, const FcObject& object) {
    const auto size = size_of(*object.hole);
    const FcObject* profile = object_named(document_, object.hole->profile);
    if (!size) lost_.sizes.push_back(object.label);
    if (!size || !profile) return;
    std::vector<Thread> threads;
    add_threads(*object.hole, *size, *profile, threads);
    for (Thread& thread : threads) made_.push_back({name, std::move(thread)});
  }

  void add_pattern(const std::string& name, const FcObject& object) {
    const std::vector<std::string>& originals = object.pattern->originals;
    std::vector<Thread> repeated;
    for (const Made& one : made_) {
      const bool is_original = std::ranges::find(originals, one.feature) != originals.end();
      if (is_original || object.pattern->whole) repeated.push_back(one.thread);
    }
    if (repeated.empty()) return;
    const auto copies = copies_of(document_, *object.pattern);
    if (!copies) {
      lost_.patterns.push_back(object.label);
      return;
    }
    for (std::size_t k = 1; k < copies->size(); ++k) {
      for (const Thread& thread : repeated) made_.push_back({name, placed(thread, (*copies)[k])});
    }
  }

  const FcDocument& document_;
  LostThreads& lost_;
  std::vector<Made> made_;
};

}  // namespace

std::vector<Thread> threads_of(const FcDocument& document, const FcObject& body,
                               LostThreads& lost) {
  BodyThreads threads(document, lost);
  for (const std::string& name : body.group) {
    if (const FcObject* object = object_named(document, name)) threads.add(name, *object);
    if (name == body.tip) break;
  }
  return std::move(threads).all();
}

}  // namespace burin::detail
