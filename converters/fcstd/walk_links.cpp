// Links: to what they point, and how often.
#include <burin/base/error.h>

#include "labels.h"
#include "text.h"
#include "walk.h"

#include <fmt/format.h>

namespace burin::detail {
namespace {

Placement scaled(Placement placement, const Vec3& scale) {
  for (int i = 0; i < 3; ++i) placement.linear[i] *= scale[i];
  return placement;
}

}  // namespace

void FcWalk::link(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  if (place.own) inside.placement = after(place.placement, object.placement);
  inside.placement = scaled(inside.placement, object.scale);
  inside.shown = true;
  if (inside.alias.empty()) inside.alias = object.label;
  if (!inside.look && object.overrides_look) inside.look = object.look;
  if (!place.alone) inside.given.clear();
  if (std::string given = given_name(document, object); !given.empty()) inside.given = given;
  inside.alone = true;
  if (!object.elements.empty()) return elements(document, object, inside);
  Target target;
  if (!find_target(document, object, target)) return;
  inside.own = object.link_transform;
  if (object.element_count > 0) return array(document, object, target, inside);
  inside.placement = after(inside.placement, target.before);
  inside.own = inside.own || target.below;
  visit(*target.document, target.object, inside);
}

void FcWalk::elements(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  inside.own = true;
  for (std::size_t i = 0; i < object.elements.size(); ++i) {
    const std::int32_t child = document.find(object.elements[i]);
    if (child < 0) {
      lost_member(object, object.elements[i]);
      continue;
    }
    // Elements themselves are hidden from the tree as soon as they are made in a window.
    const bool hidden = i < object.elements_visible.size() && !object.elements_visible[i];
    if (!hidden) visit(document, child, inside);
  }
}

void FcWalk::array(const FcDocument& document, const FcObject& object, const Target& target,
                   const Place& place) {
  if (object.element_count > static_cast<std::int64_t>(kMostVisits)) {
    throw InputError(object.label + ": the array has absurdly many elements",
                     document.path().string());
  }
  const std::vector<Placement> placements = document.placements(object);
  const std::vector<Vec3> scales = document.scales(object);
  for (std::size_t i = 0; i < static_cast<std::size_t>(object.element_count); ++i) {
    if (i < object.elements_visible.size() && !object.elements_visible[i]) continue;
    Place one = place;
    if (i < placements.size()) one.placement = after(one.placement, placements[i]);
    if (i < scales.size()) one.placement = scaled(one.placement, scales[i]);
    one.placement = after(one.placement, target.before);
    one.own = one.own || target.below;
    visit(*target.document, target.object, one);
  }
}

bool FcWalk::find_target(const FcDocument& document, const FcObject& object, Target& target) {
  const auto broken = [&](const char* code, const std::string& why) {
    broken_links_.add(Severity::Warning, code, why + "; links left out", object.label);
    return false;
  };
  if (!object.link) return broken("fcstd.broken_link", "nothing is linked to");
  const FcLink& link = *object.link;
  target.document = &document;
  if (!link.file.empty()) {
    const std::filesystem::path file = document.path().parent_path() / link.file;
    const std::string name = in_quotes(link.file);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      return broken("fcstd.missing_file",
                    fmt::format("the linked file {} is missing (it is looked for from the folder "
                                "of the document)",
                                name));
    }
    try {
      target.document = &documents_.open(file);
    } catch (const InputError& e) {
      return broken("fcstd.broken_file", fmt::format("the linked file {} {}", name, e.what()));
    }
  }
  target.object = target.document->find(link.object);
  if (target.object >= 0 && descend(link.sub, object.link_transform, target)) {
    if (!link.sub.empty() && link.sub.back() != '.') {
      broken_links_.add(Severity::Warning, "fcstd.whole_object",
                        "links to a face or an edge are drawn as the whole object", object.label);
    }
    return true;
  }
  return broken("fcstd.broken_link",
                fmt::format("the linked object {} does not exist",
                            in_quotes(link.object + (link.sub.empty() ? "" : "." + link.sub))));
}

/// Down "Part.Box.": the placement of the first object counts where the link says so, of those
/// below always. What follows the last point is a face or an edge, of which the whole object is
/// drawn.
bool FcWalk::descend(const std::string& sub, bool transform, Target& target) {
  bool first = true;
  for (std::size_t from = 0; from < sub.size();) {
    const std::size_t dot = sub.find('.', from);
    if (dot == std::string::npos) return true;
    const std::int32_t next = target.document->find(sub.substr(from, dot - from));
    if (next < 0) return false;
    const FcObject& here = target.document->objects()[static_cast<std::size_t>(target.object)];
    if ((!first || transform) && here.is_part())
      target.before = after(target.before, here.placement);
    target.object = next;
    target.below = true;
    first = false;
    from = dot + 1;
  }
  return true;
}

}  // namespace burin::detail
