#include "walk.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>

#include "text.h"
#include "xml.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

// Links inside links multiply: a few lines can ask for 2^60 shapes.
constexpr std::size_t kMostVisits = 200'000;
constexpr std::size_t kDeepest = 100;
constexpr std::size_t kMostDocuments = 200;

/// Whether objects of this type are aids, not parts of the model.
bool is_aid(const std::string& type) {
  for (const char* t :
       {"PartDesign::Plane", "PartDesign::Line", "PartDesign::Point",
        "PartDesign::CoordinateSystem", "PartDesign::ShapeBinder", "PartDesign::SubShapeBinder",
        "PartDesign::SubShapeBinderPython", "App::Origin", "App::Plane", "App::Line", "App::Point",
        "App::LocalCoordinateSystem", "Part::LocalCoordinateSystem"}) {
    if (type == t) return true;
  }
  // Those of FreeCAD 1.1 are Part::DatumPlane and so on.
  return type.starts_with("Sketcher::") || type.starts_with("Part::Datum");
}

/// Those that `object` holds in the tree.
const std::vector<std::string>& held(const FcObject& object) {
  return object.has_group ? object.group : object.elements;
}

Placement scaled(Placement placement, const Vec3& scale) {
  for (int i = 0; i < 3; ++i) placement.linear[i] *= scale[i];
  return placement;
}

}  // namespace

const FcDocument& FcDocuments::open(const std::filesystem::path& path,
                                    const std::filesystem::path& copy) {
  std::error_code error;
  std::filesystem::path key = std::filesystem::weakly_canonical(path, error);
  if (error) key = path;
  const auto it = open_.find(key);
  if (it != open_.end()) return *it->second;
  if (open_.size() >= kMostDocuments) {
    throw InputError("is linked to by more documents than are read for one drawing", path.string());
  }
  return *(open_[key] = std::make_unique<FcDocument>(path, copy, context_));
}

FcWalk::FcWalk(FcDocuments& documents, const FcDocument& root, const RunContext& context)
    : documents_(documents), root_(root), context_(context) {
  find_parents();
}

void FcWalk::find_parents() {
  const auto& objects = root_.objects();
  parent_.assign(objects.size(), -1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (const std::string& name : held(objects[i])) {
      const std::int32_t child = root_.find(name);
      const auto self = static_cast<std::int32_t>(i);
      if (child < 0 || child == self) continue;
      std::int32_t& parent = parent_[static_cast<std::size_t>(child)];
      if (parent < 0) parent = self;
    }
  }
  // Groups that hold each other have no root: the chain upwards is cut where it comes round.
  std::vector<std::uint32_t> seen(objects.size(), 0);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto mark = static_cast<std::uint32_t>(i + 1);
    for (auto k = static_cast<std::int32_t>(i); k >= 0;) {
      std::uint32_t& at = seen[static_cast<std::size_t>(k)];
      if (at != 0 && at != mark) break;
      if (at == mark) {
        parent_[static_cast<std::size_t>(k)] = -1;
        note("fcstd.cycle", objects[static_cast<std::size_t>(k)].label +
                                ": the group holds itself; it was taken as the outermost");
        break;
      }
      at = mark;
      k = parent_[static_cast<std::size_t>(k)];
    }
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (parent_[i] < 0) roots_.push_back(static_cast<std::int32_t>(i));
  }
}

void FcWalk::note(const char* code, const std::string& message) {
  if (noted_.insert(message).second) diagnostics.add(Severity::Warning, code, 1, message);
}

void FcWalk::visible() {
  for (const std::int32_t root : roots_) visit(root_, root, {});
}

void FcWalk::chosen(const std::vector<std::string>& names) {
  std::set<std::int32_t> taken;
  for (const std::string& name : names) {
    std::vector<std::int32_t> found;
    std::vector<std::string> known;
    if (const std::int32_t i = root_.find(name); i >= 0) found.push_back(i);
    for (std::size_t i = 0; found.empty() && i < root_.objects().size(); ++i) {
      const FcObject& o = root_.objects()[i];
      if (o.label == name) found.push_back(static_cast<std::int32_t>(i));
      if (o.type.starts_with("App::") && !o.is_part() && !o.is_link() && !o.has_group) continue;
      known.push_back(o.name);
      known.push_back(o.label);
    }
    for (std::size_t i = 0; !found.empty() && i < root_.objects().size(); ++i) {
      const auto number = static_cast<std::int32_t>(i);
      if (root_.objects()[i].label == name && number != found.front() &&
          root_.objects()[static_cast<std::size_t>(found.front())].name != name) {
        found.push_back(number);
      }
    }
    if (found.empty()) {
      const std::string near = nearest(name, known);
      throw InputError(fmt::format("has no object with the name or label {}{}", in_quotes(name),
                                   near.empty() ? "" : "; the nearest is " + in_quotes(near)),
                       root_.path().string());
    }
    for (const std::int32_t i : found) {
      if (taken.insert(i).second) visit(root_, i, place_of(i));
    }
  }
}

FcWalk::Place FcWalk::place_of(std::int32_t number) const {
  Place place;
  place.shown = place.named = true;
  for (std::int32_t k = parent_[static_cast<std::size_t>(number)]; k >= 0;
       k = parent_[static_cast<std::size_t>(k)]) {
    const FcObject& o = root_.objects()[static_cast<std::size_t>(k)];
    if (o.is_part() || o.is_body() || o.is_link() || o.is_link_group()) {
      place.placement = after(o.placement, place.placement);
    }
    place.assembly.insert(place.assembly.begin(), o.label);
  }
  return place;
}

void FcWalk::visit(const FcDocument& document, std::int32_t number, const Place& place) {
  context_.check();
  const FcObject& object = document.objects()[static_cast<std::size_t>(number)];
  if (std::find(path_.begin(), path_.end(), &object) != path_.end() || path_.size() > kDeepest) {
    note("fcstd.cycle", object.label + ": a group or link holds itself; it was left out there");
    return;
  }
  if (++visits_ > kMostVisits) {
    throw InputError(
        "its groups and links ask for absurdly many objects; choose some with `object`",
        root_.path().string());
  }
  path_.push_back(&object);
  visit_here(document, object, place);
  path_.pop_back();
}

void FcWalk::visit_here(const FcDocument& document, const FcObject& object, const Place& place) {
  const bool plain_group = object.has_group && !object.is_part() && !object.is_body();
  if (!place.shown && !object.visible && !plain_group) return;
  if (object.is_illustration) return;
  if (object.is_link()) return link(document, object, place);
  if (object.is_link_group()) return link_group(document, object, place);
  if (!object.is_body() && object.has_group && object.shape.empty()) {
    return members(document, object, place);
  }
  leaf(document, object, place);
}

void FcWalk::members(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  inside.own = true;
  inside.shown = inside.named = false;
  inside.alias.clear();
  if (object.is_part() && place.own) inside.placement = after(place.placement, object.placement);
  inside.assembly.push_back(place.alias.empty() ? object.label : place.alias);
  for (const std::string& name : object.group) {
    const std::int32_t child = document.find(name);
    if (child < 0) continue;
    // Listed by two groups: drawn in the first.
    const FcObject* parent = nullptr;
    if (&document == &root_ && parent_[static_cast<std::size_t>(child)] >= 0) {
      parent = &root_.objects()[static_cast<std::size_t>(parent_[static_cast<std::size_t>(child)])];
    }
    if (parent == nullptr || parent == &object) visit(document, child, inside);
  }
}

void FcWalk::link_group(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  inside.named = false;
  inside.alias.clear();
  if (place.own) inside.placement = after(place.placement, object.placement);
  inside.own = inside.shown = true;
  inside.assembly.push_back(place.alias.empty() ? object.label : place.alias);
  for (std::size_t i = 0; i < object.elements.size(); ++i) {
    const std::int32_t child = document.find(object.elements[i]);
    const bool hidden = i < object.elements_visible.size() && !object.elements_visible[i];
    if (child >= 0 && !hidden) visit(document, child, inside);
  }
}

void FcWalk::link(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  if (place.own) inside.placement = after(place.placement, object.placement);
  inside.placement = scaled(inside.placement, object.scale);
  inside.shown = true;
  if (inside.alias.empty()) inside.alias = object.label;
  if (inside.color.empty() && object.overrides_color) inside.color = object.color;
  if (!object.elements.empty()) {
    inside.own = true;
    for (std::size_t i = 0; i < object.elements.size(); ++i) {
      const std::int32_t child = document.find(object.elements[i]);
      if (child < 0) continue;
      const FcObject& element = document.objects()[static_cast<std::size_t>(child)];
      bool hidden = !element.visible;
      if (!element.is("App::LinkElement") && i < object.elements_visible.size()) {
        hidden = !object.elements_visible[i];
      }
      if (!hidden) visit(document, child, inside);
    }
    return;
  }
  Target target;
  if (!find_target(document, object, target)) return;
  inside.own = object.link_transform;
  if (object.element_count > 0) return array(document, object, target, inside);
  inside.placement = after(inside.placement, target.before);
  inside.own = inside.own || target.below;
  visit(*target.document, target.object, inside);
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
  if (!object.link) {
    note("fcstd.broken_link", object.label + ": the link points at nothing; it was left out");
    return false;
  }
  const FcLink& link = *object.link;
  target.document = &document;
  if (!link.file.empty()) {
    const std::filesystem::path file = document.path().parent_path() / link.file;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      note("fcstd.missing_file",
           fmt::format("{}: the linked file {} is missing; the link was left out", object.label,
                       in_quotes(link.file)));
      return false;
    }
    try {
      target.document = &documents_.open(file);
    } catch (const InputError& e) {
      note("fcstd.broken_file", fmt::format("{}: the linked file {} {}; the link was left out",
                                            object.label, in_quotes(link.file), e.what()));
      return false;
    }
  }
  target.object = target.document->find(link.object);
  if (target.object >= 0 && descend(link.sub, object.link_transform, target)) return true;
  note("fcstd.broken_link",
       fmt::format("{}: the linked object {} does not exist; the link was left out", object.label,
                   in_quotes(link.object + (link.sub.empty() ? "" : "." + link.sub))));
  return false;
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

void FcWalk::leaf(const FcDocument& document, const FcObject& object, const Place& place) {
  const FcObject* shape = &object;
  if (object.is_body() && object.shape.empty()) {
    const std::int32_t tip = document.find(object.tip);
    if (tip >= 0) shape = &document.objects()[static_cast<std::size_t>(tip)];
  }
  if (shape->shape.empty() && shape->mesh.empty()) return;
  if (!place.named && is_aid(object.type)) return;
  FcUse use{&document, &object, shape, place.placement, place.own, {}, place.color, place.assembly};
  use.name = place.alias.empty() ? object.label : place.alias;
  if (shape != &object && place.own) use.placement = after(use.placement, object.placement);
  if (shape != &object) use.own = true;
  if (use.color.empty() && object.is_body()) {
    const std::int32_t tip = document.find(object.tip);
    if (tip >= 0) use.color = document.objects()[static_cast<std::size_t>(tip)].color;
  }
  if (use.color.empty()) use.color = object.color;
  uses.push_back(std::move(use));
}

}  // namespace burin::detail
