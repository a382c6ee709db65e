#include "instances.h"

#include <burin/base/error.h>

#include "color.h"
#include "text.h"
#include "transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace burin::irit {
namespace {

/// Lists and instances in each other; the stack holds many more.
constexpr std::size_t kDeepestInstance = 400;
/// Instances of instances of instances multiply: a kilobyte could ask for terabytes.
constexpr std::size_t kMostInstancePoints = 5'000'000;

bool has_instance(const IritObject& object) {
  const auto is_instance = [](const IritItem& item) {
    return std::holds_alternative<IritInstance>(item);
  };
  return std::ranges::any_of(object.items, is_instance) ||
         std::ranges::any_of(object.objects, has_instance);
}

std::size_t points_of(const IritItem& item) {
  if (const auto* surface = std::get_if<IritSurface>(&item)) return surface->data.points.size();
  if (const auto* trimmed = std::get_if<IritTrimmed>(&item)) {
    std::size_t all = 0;
    for (const TrimmedSurface& face : trimmed->faces) {
      all += face.surface.points.size();
      for (const TrimLoop& loop : face.loops) {
        for (const TrimCurve& curve : loop.curves) all += curve.points.size();
      }
    }
    return all;
  }
  if (const auto* curve = std::get_if<IritCurve>(&item)) return curve->points.size();
  if (const auto* polygon = std::get_if<IritPolygon>(&item)) return polygon->points.size();
  return 0;
}

bool is_color(const IritAttribute& a) {
  return lowered(a.name) == "rgb" || lowered(a.name) == "color";
}
bool is_invisible(const IritAttribute& a) { return lowered(a.name) == "invisible"; }

void transform_all(IritObject& object, const Matrix& matrix) {
  for (IritItem& item : object.items) transform(item, matrix);
  for (IritObject& child : object.objects) transform_all(child, matrix);
}

class Resolver {
 public:
  Resolver(const IritObject& root, const Source& source) : source_(source) {
    for (const IritObject& object : root.objects) add_names(object);
  }
  /// A copy without instances.
  IritObject resolved(const IritObject& object);

 private:
  void add_names(const IritObject& object);
  void add(IritObject& object, const IritInstance& instance);
  void count(const IritObject& object, const IritInstance& instance);
  [[noreturn]] void fail(const IritInstance& instance, const std::string& what) const {
    fail_at(source_.file(), instance.place, what);
  }

  const Source& source_;
  std::unordered_map<std::string, const IritObject*> named_;
  /// What is being copied, each within the one before.
  std::vector<const IritObject*> within_;
  std::size_t points_ = 0;
};

void Resolver::add_names(const IritObject& object) {
  if (!object.name.empty()) named_.try_emplace(object.name, &object);
  for (const IritObject& child : object.objects) add_names(child);
}

/// Each object counts as a point: lists of nothing multiply, too.
void Resolver::count(const IritObject& object, const IritInstance& instance) {
  ++points_;
  for (const IritItem& item : object.items) points_ += 1 + points_of(item);
  if (points_ > kMostInstancePoints) {
    fail(instance, fmt::format("the instances up to this one make more than {} control points; "
                               "leave some out",
                               kMostInstancePoints));
  }
  for (const IritObject& child : object.objects) count(child, instance);
}

/// What the original of the instance holds becomes the object's own.
void Resolver::add(IritObject& object, const IritInstance& instance) {
  const auto found = named_.find(instance.of);
  if (found == named_.end()) {
    object.items.push_back(instance);
    return;
  }
  const auto it = std::ranges::find(within_, found->second);
  if (it != within_.end()) {
    fail(instance, fmt::format("{} is an instance of itself: this instance of it lies within it; "
                               "take it out",
                               in_quotes(instance.of)));
  }
  IritObject copy = resolved(*found->second);
  count(copy, instance);
  try {
    transform_all(copy, instance.matrix);
  } catch (const GeometryError& e) {
    fail(instance,
         fmt::format("the instance of {} cannot be drawn: {}", in_quotes(instance.of), e.what()));
  }
  if (object.name.empty()) object.name = copy.name;
  if (color_of(copy)) std::erase_if(object.attributes, is_color);
  std::erase_if(copy.attributes, is_invisible);
  std::ranges::move(copy.attributes, std::back_inserter(object.attributes));
  std::ranges::move(copy.items, std::back_inserter(object.items));
  std::ranges::move(copy.objects, std::back_inserter(object.objects));
}

IritObject Resolver::resolved(const IritObject& object) {
  source_.context().check();
  if (within_.size() > kDeepestInstance) {
    throw InputError(
        fmt::format("lists and instances lie more than {} deep in each other", kDeepestInstance),
        source_.file(), object.line);
  }
  within_.push_back(&object);
  IritObject copy{object.name, object.attributes, {}, {}, object.line};
  for (const IritObject& child : object.objects) copy.objects.push_back(resolved(child));
  for (const IritItem& item : object.items) {
    if (const auto* instance = std::get_if<IritInstance>(&item)) {
      add(copy, *instance);
    } else {
      copy.items.push_back(item);
    }
  }
  within_.pop_back();
  return copy;
}

}  // namespace

void resolve_instances(IritObject& root, const Source& source) {
  if (has_instance(root)) root = Resolver(root, source).resolved(root);
}

}  // namespace burin::irit
