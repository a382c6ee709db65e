#pragma once
/// From entities that state a dimension, a tolerance, a datum, a datum target or a note to items;
/// internal to the reading of PMI.

#include <burin/surface/pmi.h>

#include "step_aspects.h"
#include "step_measure.h"
#include "step_pmi.h"
#include "step_text.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The decimals that the numbers of a size are written with, as the file says; absent: as many as
/// they need. Those of limits and of deviations are the same.
struct SizeDecimals {
  std::optional<int> value, upper, lower;
};

class StepSemantics {
 public:
  explicit StepSemantics(const StepText& text);

  /// The entities of all dimensions, tolerances, datum features and targets, in this order, each
  /// kind ascending.
  std::vector<std::int64_t> all() const;
  /// Absent where the entity is of no kind that is understood.
  std::optional<StepPmiItem> item(std::int64_t number) const;
  const StepAspects& aspects() const { return aspects_; }

 private:
  StepPmiItem dimension(std::int64_t number, const StepRecord& record) const;
  StepPmiItem tolerance(std::int64_t number, const StepEntity& entity,
                        const StepRecord& kind) const;
  void read_zone(std::int64_t number, const StepEntity& entity, PmiItem& item) const;
  StepPmiItem datum_feature(std::int64_t number, const StepRecord& aspect) const;
  StepPmiItem target(std::int64_t number, const StepRecord& record) const;
  StepPmiItem note(std::int64_t number, const StepRecord& record) const;
  void read_size(std::int64_t representation, int depth, PmiItem& item,
                 SizeDecimals& decimals) const;
  void read_deviations(std::int64_t dimension, PmiItem& item, SizeDecimals& decimals) const;
  std::string letter_of(std::int64_t feature) const;
  /// The datums of a system: "A", "B (M)", "A-B".
  std::vector<std::string> datums_of(const StepValue& systems) const;
  std::string datum_reference(std::int64_t number) const;

  const StepText& text_;
  StepAspects aspects_;
  /// From dimensions to what represents them, to ranges of deviations; from tolerances to zones;
  /// from properties to what represents them.
  StepLinks sizes_, ranges_, zones_, properties_;
};

/// A word of the standard, .MAXIMUM_MATERIAL_REQUIREMENT., in small letters without lines below;
/// and the sign that drawings have for it in brackets, "(M)".
std::string words_of(std::string_view word);
std::string sign_of(const std::string& words);

/// A note with the signs that drawings have for "#{diameter}" and others.
std::string with_signs(std::string text);

/// The record that makes an entity a tolerance of form, orientation, location or run-out.
const StepRecord* tolerance_record(const StepEntity& entity);

}  // namespace burin
