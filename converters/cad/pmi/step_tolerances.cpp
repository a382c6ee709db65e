// Geometric tolerances: their kind, zone, modifiers and datums.

#include "step_semantics.h"

#include <string_view>

namespace burin {
namespace {

/// What a list of modifiers says: words of the standard, or a word with a number.
void append_modifiers(const StepText& text, const StepValue& value,
                      std::vector<std::string>& modifiers) {
  if (value.kind == StepValue::Kind::Word) modifiers.push_back(words_of(value.text));
  if (value.kind == StepValue::Kind::Reference) {
    const StepEntity entity = text.entity(value.entity);
    if (const StepRecord* record = entity.as("DATUM_REFERENCE_MODIFIER_WITH_VALUE")) {
      std::string words = words_of(record->at(0).text);
      if (const auto measure = measure_of(text, record->at(1).entity)) {
        words += " " + number_text(measure->value, measure->decimals);
      }
      modifiers.push_back(words);
    }
  }
  for (const StepValue& item : value.items) append_modifiers(text, item, modifiers);
}

std::string written(const StepMeasure& measure) {
  const std::string number = number_text(measure.value, measure.decimals);
  return measure.unit == "mm" || measure.unit.empty() ? number : number + " " + measure.unit;
}

}  // namespace

std::string StepSemantics::datum_reference(std::int64_t number) const {
  const StepEntity entity = text_.entity(number);
  if (const StepRecord* letter = entity.as("DATUM")) {
    return letter->at(letter->values.size() - 1).text;
  }
  if (const StepRecord* old = entity.as("DATUM_REFERENCE")) {
    return datum_reference(old->at(1).entity);
  }
  const StepRecord* reference =
      entity.as_one_of({"DATUM_REFERENCE_COMPARTMENT", "DATUM_REFERENCE_ELEMENT"});
  if (reference == nullptr) return {};
  std::string letters;
  const StepValue& base = reference->at(4);
  for (const std::int64_t one : base.references()) {
    if (one == number) continue;
    letters += (letters.empty() ? "" : "-") + datum_reference(one);
  }
  std::vector<std::string> modifiers;
  append_modifiers(text_, reference->at(5), modifiers);
  for (const std::string& modifier : modifiers) letters += " " + sign_of(modifier);
  return letters;
}

std::vector<std::string> StepSemantics::datums_of(const StepValue& systems) const {
  std::vector<std::string> datums;
  for (const std::int64_t number : systems.references()) {
    const StepEntity entity = text_.entity(number);
    const StepRecord* system = entity.as("DATUM_SYSTEM");
    if (system == nullptr) {
      if (std::string label = datum_reference(number); !label.empty()) datums.push_back(label);
      continue;
    }
    for (const std::int64_t one : system->at(4).references()) {
      if (std::string label = datum_reference(one); !label.empty()) datums.push_back(label);
    }
  }
  return datums;
}

/// The form of the zone, how large it is, where, and what it is measured over.
void StepSemantics::read_zone(std::int64_t number, const StepEntity& entity, PmiItem& item) const {
  const StepRecord* whole = entity.as("GEOMETRIC_TOLERANCE");
  const StepRecord& record = whole != nullptr ? *whole : *tolerance_record(entity);
  if (const auto zone = zones_.find(number); zone != zones_.end() && !zone->second.empty()) {
    const StepEntity form = text_.entity(zone->second.front());
    const StepRecord* of = form.as("TOLERANCE_ZONE_FORM");
    const std::string words = of != nullptr ? of->at(0).text : std::string();
    if (words.find("cylindrical") != std::string::npos) item.text += " ⌀";
    if (words.find("spherical") != std::string::npos) item.text += " S⌀";
  }
  if (const auto magnitude = measure_of(text_, record.at(2).entity)) {
    item.value = magnitude->value;
    item.unit = magnitude->unit;
    item.text += " " + written(*magnitude);
  }
  const auto add = [&](const char* type, const char* before, const char* words) {
    const StepRecord* more = entity.as(type);
    if (more == nullptr) return;
    const auto measure = measure_of(text_, more->at(0).entity);
    if (!measure) return;
    item.text += before + written(*measure);
    item.modifiers.push_back(words + (" " + written(*measure)));
  };
  add("UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE", " (U) ", "unequally disposed");
  add("GEOMETRIC_TOLERANCE_WITH_DEFINED_UNIT", " / ", "per");
  add("GEOMETRIC_TOLERANCE_WITH_MAXIMUM_TOLERANCE", " max ", "maximum");
}

StepPmiItem StepSemantics::tolerance(std::int64_t number, const StepEntity& entity,
                                     const StepRecord& kind) const {
  StepPmiItem out{.entity = number};
  PmiItem& item = out.item;
  item.kind = PmiKind::Tolerance;
  item.what = words_of(kind.type.substr(0, kind.type.rfind("_TOLERANCE")));
  const StepRecord* whole = entity.as("GEOMETRIC_TOLERANCE");
  const StepRecord& record = whole != nullptr ? *whole : kind;
  item.name = record.at(0).text;
  item.text = item.what;
  read_zone(number, entity, item);
  std::vector<std::string> modifiers;
  for (const char* type : {"GEOMETRIC_TOLERANCE_WITH_MODIFIERS", "MODIFIED_GEOMETRIC_TOLERANCE"}) {
    const StepRecord* modified = entity.as(type);
    if (modified != nullptr) {
      append_modifiers(text_, modified->at(modified->values.size() - 1), modifiers);
    }
  }
  for (const std::string& modifier : modifiers) {
    item.text += " " + sign_of(modifier);
    item.modifiers.push_back(modifier);
  }
  const StepRecord* with_datums = entity.as("GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE");
  // By itself a tolerance that cannot be without has them behind what it is of.
  if (with_datums != nullptr || record.values.size() > 4) {
    item.datums = datums_of(with_datums != nullptr ? with_datums->at(with_datums->values.size() - 1)
                                                   : record.at(4));
  }
  for (const std::string& label : item.datums) item.text += " | " + label;
  const std::int64_t aspect = record.at(3).entity;
  out.faces = aspects_.faces_of(aspect);
  out.product = aspects_.product_of(aspect);
  return out;
}

}  // namespace burin
