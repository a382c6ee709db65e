#include "step_aspects.h"

#include <algorithm>

namespace burin {
namespace {

// Groups in each other: no file has that many, and broken ones go round.
constexpr int kDeepestGroup = 16;

const std::vector<std::int64_t> kNoEntities;

const std::vector<std::int64_t>& entities_at(const StepLinks& links, std::int64_t number) {
  const auto found = links.find(number);
  return found == links.end() ? kNoEntities : found->second;
}

}  // namespace

StepLinks links_of(const StepText& text, std::initializer_list<std::string_view> types,
                   std::size_t from, std::size_t to) {
  StepLinks links;
  for (const std::string_view type : types) {
    for (const std::int64_t number : text.of_type(type)) {
      const StepEntity entity = text.entity(number);
      const StepRecord* record = entity.as(type);
      if (record == nullptr) continue;
      for (const std::int64_t one : record->at(from).references()) {
        std::vector<std::int64_t>& others = links[one];
        for (const std::int64_t other : record->at(to).references()) others.push_back(other);
      }
    }
  }
  return links;
}

StepAspects::StepAspects(const StepText& text)
    : text_(text),
      items_(links_of(
          text, {"GEOMETRIC_ITEM_SPECIFIC_USAGE", "ITEM_IDENTIFIED_REPRESENTATION_USAGE"}, 2, 4)),
      parts_(links_of(text, {"SHAPE_ASPECT_RELATIONSHIP"}, 2, 3)) {
  for (const auto& [relating, related] :
       links_of(text,
                {"SHAPE_ASPECT_RELATIONSHIP", "SHAPE_ASPECT_DERIVING_RELATIONSHIP",
                 "FEATURE_FOR_DATUM_TARGET_RELATIONSHIP"},
                2, 3)) {
    for (const std::int64_t one : related) {
      relations_[relating].push_back(one);
      relations_[one].push_back(relating);
    }
  }
}

void StepAspects::collect(std::int64_t aspect, int depth, std::vector<std::int64_t>& seen,
                          std::vector<std::int64_t>& faces) const {
  if (depth > kDeepestGroup || std::ranges::find(seen, aspect) != seen.end()) return;
  seen.push_back(aspect);
  for (const std::int64_t item : entities_at(items_, aspect)) {
    const StepEntity entity = text_.entity(item);
    if (entity.as_one_of({"ADVANCED_FACE", "FACE_SURFACE"}) != nullptr) faces.push_back(item);
  }
  for (const std::int64_t part : entities_at(parts_, aspect)) collect(part, depth + 1, seen, faces);
}

std::vector<std::int64_t> StepAspects::faces_of(std::int64_t aspect) const {
  std::vector<std::int64_t> seen, faces;
  collect(aspect, 0, seen, faces);
  make_set(faces);
  return faces;
}

const std::vector<std::int64_t>& StepAspects::related_to(std::int64_t aspect) const {
  return entities_at(relations_, aspect);
}

const StepRecord* aspect_record(const StepEntity& entity) {
  if (entity.records.empty()) return nullptr;
  if (entity.records.size() == 1) return &entity.records.front();
  return entity.as("SHAPE_ASPECT");
}

std::int64_t StepAspects::product_of(std::int64_t aspect) const {
  const StepEntity entity = text_.entity(aspect);
  const StepRecord* record = aspect_record(entity);
  if (record == nullptr) return 0;
  const StepEntity shape = text_.entity(record->at(2).entity);
  const StepRecord* of = shape.as("PRODUCT_DEFINITION_SHAPE");
  return of == nullptr ? 0 : of->at(2).entity;
}

}  // namespace burin
