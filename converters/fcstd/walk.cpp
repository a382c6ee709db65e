#include "walk.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>

#include "labels.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

constexpr std::size_t kDeepestLink = 100;
constexpr std::size_t kMostDocuments = 200;

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
    for (const std::string& name : objects[i].members()) {
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

void FcWalk::lost_member(const FcObject& object, const std::string& name) {
  broken_links_.add(Severity::Warning, "fcstd.broken_link",
                    "the document does not hold these members of its groups; left out",
                    object.label + "/" + name);
}

void FcWalk::visible() {
  for (const std::int32_t root : roots_) visit(root_, root, {});
  broken_links_.report(diagnostics);
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
  broken_links_.report(diagnostics);
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
  if (std::find(path_.begin(), path_.end(), &object) != path_.end() ||
      path_.size() > kDeepestLink) {
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
  const bool plain_group =
      object.has_group && !object.is_part() && !object.is_body() && !object.is_link_group();
  if (!place.shown && !object.visible && !plain_group) return;
  if (object.is_illustration() || (!place.named && is_bookkeeping(object))) return;
  if (object.is_link()) return link(document, object, place);
  if (object.is_link_group()) return link_group(document, object, place);
  if (object.is_group()) return members(document, object, place);
  leaf(document, object, place);
}

void FcWalk::members(const FcDocument& document, const FcObject& object, const Place& place) {
  Place inside = place;
  inside.own = true;
  inside.shown = inside.named = false;
  inside.alone = place.alone && shows_one(document, object);
  inside.alias.clear();
  if (object.is_part() && place.own) inside.placement = after(place.placement, object.placement);
  inside.assembly.push_back(place.alias.empty() ? object.label : place.alias);
  for (const std::string& name : object.group) {
    const std::int32_t child = document.find(name);
    if (child < 0) {
      lost_member(object, name);
      continue;
    }
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
  inside.alone = place.alone && shows_one(document, object);
  inside.alias.clear();
  if (place.own) inside.placement = after(place.placement, object.placement);
  inside.own = inside.shown = true;
  inside.assembly.push_back(place.alias.empty() ? object.label : place.alias);
  const std::vector<std::string>& held = object.members();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::int32_t child = document.find(held[i]);
    const bool hidden = i < object.elements_visible.size() && !object.elements_visible[i];
    if (child < 0) {
      lost_member(object, held[i]);
    } else if (!hidden) {
      visit(document, child, inside);
    }
  }
}

void FcWalk::leaf(const FcDocument& document, const FcObject& object, const Place& place) {
  const FcObject* tip = nullptr;
  if (const std::int32_t i = object.is_body() ? document.find(object.tip) : -1; i >= 0) {
    tip = &document.objects()[static_cast<std::size_t>(i)];
  }
  const FcObject* shape = tip != nullptr && object.shape.empty() ? tip : &object;
  FcUse use{.document = &document,
            .object = &object,
            .shape = shape,
            .placement = place.placement,
            .own = place.own,
            .assembly = place.assembly};
  use.name = place.alias.empty() ? object.label : place.alias;
  if (!place.named && is_aid(object)) return leave_out_aid(object, use.name, left_out);
  if (shape->shape.empty() && shape->mesh.empty()) {
    return leave_out_shapeless(object, use.name, left_out);
  }
  define(use, place);
  if (place.alone) use.link = place.given;
  if (shape != &object && place.own) use.placement = after(use.placement, object.placement);
  if (shape != &object) use.own = true;
  use.look = object.look;
  if (tip != nullptr) use.look.opacity = tip->look.opacity;
  if (tip != nullptr && (!tip->look.color.empty() || tip->look.faces)) use.look = tip->look;
  if (place.look) use.look = *place.look;
  uses.push_back(std::move(use));
}

void FcWalk::define(FcUse& use, const Place& place) const {
  use.definition = given_name(*use.document, *use.object);
  if (use.definition.empty() && place.alone) {
    const bool here = use.document == &root_;
    use.definition = here ? place.given : use.document->path().stem().string();
    use.named_by_link = here && !use.definition.empty();
  }
  if (use.definition.empty()) use.definition = use.object->label;
}

}  // namespace burin::detail
