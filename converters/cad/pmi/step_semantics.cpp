#include "step_semantics.h"

#include <burin/base/ascii.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::string_view, 7> kDimensions{"DIMENSIONAL_SIZE",
                                                      "DIMENSIONAL_SIZE_WITH_PATH",
                                                      "ANGULAR_SIZE",
                                                      "DIMENSIONAL_LOCATION",
                                                      "DIRECTED_DIMENSIONAL_LOCATION",
                                                      "ANGULAR_LOCATION",
                                                      "DIMENSIONAL_LOCATION_WITH_PATH"};
constexpr std::array<std::string_view, 2> kTargets{"PLACED_DATUM_TARGET_FEATURE", "DATUM_TARGET"};
constexpr std::string_view kTolerance = "_TOLERANCE";

bool is_tolerance(std::string_view type) {
  constexpr std::array<std::string_view, 4> kNone{"GEOMETRIC_TOLERANCE", "PLUS_MINUS_TOLERANCE",
                                                  "MODIFIED_GEOMETRIC_TOLERANCE",
                                                  "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE"};
  return type.ends_with(kTolerance) && std::ranges::find(kNone, type) == kNone.end();
}

void append(const StepText& text, std::string_view type, std::vector<std::int64_t>& all) {
  const std::vector<std::int64_t>& more = text.of_type(type);
  all.insert(all.end(), more.begin(), more.end());
}

void append_sorted(std::vector<std::int64_t> more, std::vector<std::int64_t>& all) {
  make_set(more);
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

const StepRecord* tolerance_record(const StepEntity& entity) {
  const auto found = std::ranges::find_if(
      entity.records, [](const StepRecord& record) { return is_tolerance(record.type); });
  if (found != entity.records.end()) return &*found;
  return entity.as("GEOMETRIC_TOLERANCE");
}

std::string words_of(std::string_view word) {
  std::string words = lowered(word);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string sign_of(const std::string& words) {
  constexpr std::array<std::pair<std::string_view, const char*>, 10> kSigns{
      {{"maximum material requirement", "(M)"},
       {"maximum material condition", "(M)"},
       {"least material requirement", "(L)"},
       {"least material condition", "(L)"},
       {"reciprocity requirement", "(R)"},
       {"free state", "(F)"},
       {"free state condition", "(F)"},
       {"tangent plane", "(T)"},
       {"statistical tolerance", "(ST)"},
       {"common zone", "CZ"}}};
  for (const auto& [name, sign] : kSigns) {
    if (words == name) return sign;
  }
  return "(" + words + ")";
}

std::string with_signs(std::string text) {
  constexpr std::array<std::pair<std::string_view, const char*>, 7> kSigns{
      {{"#{diameter}", "⌀"},
       {"#{counterbore}", "⌴"},
       {"#{countersink}", "⌵"},
       {"#{depth}", "↧"},
       {"#{conical-taper}", "⌲"},
       {"#{slope}", "⌳"},
       {"#{degree}", "°"}}};
  for (const auto& [name, sign] : kSigns) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
      text.replace(at, name.size(), sign);
    }
  }
  return text;
}

StepSemantics::StepSemantics(const StepText& text)
    : text_(text),
      aspects_(text),
      sizes_(links_of(text, {"DIMENSIONAL_CHARACTERISTIC_REPRESENTATION"}, 0, 1)),
      ranges_(links_of(text, {"PLUS_MINUS_TOLERANCE"}, 1, 0)),
      zones_(links_of(text, {"TOLERANCE_ZONE"}, 4, 5)),
      properties_(links_of(text, {"PROPERTY_DEFINITION_REPRESENTATION"}, 0, 1)) {}

std::vector<std::int64_t> StepSemantics::all() const {
  std::vector<std::int64_t> all, kind;
  for (const std::string_view type : kDimensions) append(text_, type, kind);
  append_sorted(std::exchange(kind, {}), all);
  for (const std::string_view type : text_.types()) {
    if (is_tolerance(type) || type == "GEOMETRIC_TOLERANCE") append(text_, type, kind);
  }
  append_sorted(std::exchange(kind, {}), all);
  append(text_, "DATUM_FEATURE", kind);
  append_sorted(std::exchange(kind, {}), all);
  for (const std::string_view type : kTargets) append(text_, type, kind);
  append_sorted(std::exchange(kind, {}), all);
  return all;
}

std::optional<StepPmiItem> StepSemantics::item(std::int64_t number) const {
  const StepEntity entity = text_.entity(number);
  for (const std::string_view type : kDimensions) {
    if (const StepRecord* record = entity.as(type)) return dimension(number, *record);
  }
  if (const StepRecord* record = tolerance_record(entity)) {
    return tolerance(number, entity, *record);
  }
  if (entity.as("DATUM_FEATURE") != nullptr) {
    if (const StepRecord* record = aspect_record(entity)) return datum_feature(number, *record);
  }
  for (const std::string_view type : kTargets) {
    if (const StepRecord* record = entity.as(type)) return target(number, *record);
  }
  if (const StepRecord* record = entity.as("PROPERTY_DEFINITION")) return note(number, *record);
  return std::nullopt;
}

StepPmiItem StepSemantics::datum_feature(std::int64_t number, const StepRecord& aspect) const {
  StepPmiItem out{.entity = number};
  out.item.kind = PmiKind::Datum;
  out.item.what = "datum";
  out.item.name = aspect.at(0).text;
  if (const std::string letter = letter_of(number); !letter.empty()) {
    out.item.datums.push_back(letter);
    out.item.text = letter;
  } else {
    out.item.text = "datum";
  }
  out.faces = aspects_.faces_of(number);
  out.product = aspects_.product_of(number);
  return out;
}

StepPmiItem StepSemantics::target(std::int64_t number, const StepRecord& record) const {
  StepPmiItem out{.entity = number};
  out.item.kind = PmiKind::DatumTarget;
  out.item.what = record.at(1).text.empty() ? "area" : record.at(1).text;
  out.item.name = record.at(0).text;
  const std::string target = letter_of(number) + record.at(4).text;
  out.item.datums.push_back(target);
  out.item.text = target + " (" + out.item.what + ")";
  out.faces = aspects_.faces_of(number);
  for (const std::int64_t related : aspects_.related_to(number)) {
    if (text_.entity(related).as("DATUM") != nullptr) continue;
    for (const std::int64_t face : aspects_.faces_of(related)) out.faces.push_back(face);
  }
  make_set(out.faces);
  out.product = aspects_.product_of(number);
  return out;
}

StepPmiItem StepSemantics::note(std::int64_t number, const StepRecord& record) const {
  StepPmiItem out{.entity = number};
  out.item.kind = PmiKind::Note;
  out.item.what = "note";
  out.item.name = record.at(0).text;
  const auto found = properties_.find(number);
  if (found != properties_.end()) {
    for (const std::int64_t representation : found->second) {
      const StepEntity entity = text_.entity(representation);
      const StepRecord* of = entity.as("REPRESENTATION");
      if (of == nullptr) continue;
      for (const std::int64_t one : of->at(1).references()) {
        const StepEntity words = text_.entity(one);
        const StepRecord* said = words.as("DESCRIPTIVE_REPRESENTATION_ITEM");
        if (said == nullptr) continue;
        const bool new_line = said->at(1).text == "/n";
        out.item.text += new_line ? " " : (out.item.text.empty() ? "" : " ") + said->at(1).text;
      }
    }
  }
  // Ends of lines and what stood before the next one.
  const auto both_blank = [](char a, char b) { return a == ' ' && b == ' '; };
  std::string& text = out.item.text;
  text.erase(std::unique(text.begin(), text.end(), both_blank), text.end());
  out.item.text = with_signs(std::move(out.item.text));
  out.faces = aspects_.faces_of(record.at(2).entity);
  out.product = aspects_.product_of(record.at(2).entity);
  return out;
}

std::string StepSemantics::letter_of(std::int64_t feature) const {
  for (const std::int64_t related : aspects_.related_to(feature)) {
    const StepEntity entity = text_.entity(related);
    if (const StepRecord* letter = entity.as("DATUM")) {
      return letter->at(letter->values.size() - 1).text;
    }
  }
  return {};
}

}  // namespace burin
