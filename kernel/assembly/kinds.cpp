#include "kinds.h"

#include <burin/assembly/items.h>
#include <burin/assembly/things.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace burin::detail {
namespace {

/// Share of a part's size within which a surface lies on its mirror image.
constexpr double kPlace = 1e-5;

/// What names that differ by a number at their end share: "chip" of "chip2" and "chip #3"; the name
/// where it is nothing but a number.
std::string family(std::string_view name) {
  std::string stem = instance_stem(name);
  const std::size_t last = stem.find_last_not_of("0123456789");
  if (last == stem.npos) return stem;
  const std::size_t end = std::string_view(stem).substr(0, last + 1).find_last_not_of("_.:-# ");
  return end == stem.npos ? stem : stem.substr(0, end + 1);
}

}  // namespace

std::vector<Kind> Kinds::find(const std::vector<bool>& unlisted) {
  const auto is_listed = [&](std::size_t i) { return i >= unlisted.size() || !unlisted[i]; };
  for (std::size_t i = 0; i < scene_.parts.size();) {
    context_.check();
    const std::size_t end = end_of_thing(scene_, i);
    bool listed = false;
    for (std::size_t k = i; k < end; ++k) listed = listed || is_listed(k);
    if (listed) add(i);
    i = end;
  }
  return std::move(kinds_);
}

void Kinds::add(std::size_t index) {
  const Part* whole = scene_.parts[index].whole.get();
  const auto known = of_whole_.find(whole);
  const std::size_t kind = whole && known != of_whole_.end() ? known->second : kind_of(index);
  if (whole) of_whole_.emplace(whole, kind);
  for (std::size_t i = index; i < end_of_thing(scene_, index); ++i) kinds_[kind].parts.push_back(i);
}

std::size_t Kinds::kind_of(std::size_t index) {
  const Part& part = listed(scene_.parts[index]);
  const std::string key = family(part.definition.empty() ? part.name : part.definition);
  std::vector<std::size_t>& of_name = by_name_[key];
  KnownShape shape;
  if (end_of_thing(scene_, index) == index + 1) shape.definition = part.form->definition();
  for (const std::size_t k : of_name) {
    const auto same = [&](const KnownShape& s) {
      return s.definition && shape.definition && s.definition->same(*shape.definition);
    };
    if (std::ranges::any_of(kinds_[k].shapes, same)) return k;
  }
  // Measured only where a name has two shapes.
  for (const std::size_t k : of_name) {
    if (!same_shape(kinds_[k], shape, index)) continue;
    kinds_[k].shapes.push_back(shape);
    return k;
  }
  of_name.push_back(kinds_.size());
  kinds_.push_back(Kind{key, {shape}, {}, nullptr, {}});
  return kinds_.size() - 1;
}

bool Kinds::same_shape(Kind& kind, KnownShape& shape, std::size_t index) {
  KnownShape& first = kind.shapes.front();
  if (!first.measure) first.measure = measured(kind.parts.front());
  if (!shape.measure) shape.measure = measured(index);
  if (!first.measure || !shape.measure || !first.measure->same(*shape.measure)) return false;
  return (first.measure->handed() && shape.measure->handed()) || same_hand(kind, shape, index);
}

bool Kinds::same_hand(Kind& kind, const KnownShape& shape, std::size_t index) {
  if (!kind.body) kind.body = body_of(kind.parts.front());
  if (!kind.body) return false;
  const double place = kPlace * kind.body->pose().box.diagonal();
  if (!kind.own_image) {
    kind.own_image = rigid_move(*kind.body, kind.body->mirrored(), place, context_).has_value();
  }
  if (*kind.own_image) return true;
  const auto& first = kind.shapes.front().definition;
  if (shape.definition && first) {
    Definition image = *shape.definition;
    image.linear = -image.linear;
    if (image.same(*first)) return false;
  }
  const auto body = body_of(index);
  return body && rigid_move(*kind.body, *body, place, context_).has_value();
}

std::optional<ShapeMeasure> Kinds::measured(std::size_t index) {
  try {
    if (end_of_thing(scene_, index) > index + 1) return shape_measure(together(index));
    return listed(scene_.parts[index]).form->measure(context_);
  } catch (const GeometryError& e) {
    report(index, e.what());
    return std::nullopt;
  }
}

std::shared_ptr<const Body> Kinds::body_of(std::size_t index) {
  try {
    if (end_of_thing(scene_, index) > index + 1) {
      ProxyMesh all = together(index);
      return std::make_shared<const Body>(std::make_shared<const TriMesh>(std::move(all.mesh)),
                                          all.tolerance);
    }
    return std::make_shared<const Body>(
        realised_to_compare(*listed(scene_.parts[index]).form, context_));
  } catch (const GeometryError& e) {
    report(index, e.what());
    return nullptr;
  }
}

ProxyMesh Kinds::together(std::size_t index) const {
  ProxyMesh all;
  for (std::size_t i = index; i < end_of_thing(scene_, index); ++i) {
    const auto surface = realised_to_compare(*scene_.parts[i].form, context_);
    const ProxyMesh& one = surface->proxy();
    const auto before = static_cast<std::uint32_t>(all.mesh.positions.size());
    all.mesh.positions.insert(all.mesh.positions.end(), one.mesh.positions.begin(),
                              one.mesh.positions.end());
    for (const Triangle& t : one.mesh.triangles) {
      all.mesh.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
    }
    std::ranges::copy(one.topology.component_closed,
                      std::back_inserter(all.topology.component_closed));
    all.region_count += one.region_count;
    all.tolerance = std::max(all.tolerance, one.tolerance);
  }
  return all;
}

void Kinds::report(std::size_t index, const char* why) {
  if (!reported_.insert(index).second) return;
  diagnostics_.add(Severity::Warning, "items.not_measured", 1,
                   fmt::format("{}: counts as an item of its own, as it cannot be compared with "
                               "others of its name: {}",
                               listed(scene_.parts[index]).name, why));
}

}  // namespace burin::detail
