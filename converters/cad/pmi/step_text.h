#pragma once
/// The entities of a STEP file as they stand in its text (ISO 10303-21): for what OCCT has no class
/// for, or leaves out.

#include <burin/base/run_context.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// One parameter of an entity.
struct StepValue {
  enum class Kind { None, Number, Text, Word, Reference, List, Typed };
  /// None: `$`, `*`, and what is broken.
  Kind kind = Kind::None;
  double number = 0;
  /// Of a reference, #12.
  std::int64_t entity = 0;
  /// UTF-8 of a text; "TRUE" of the word .TRUE.; the type of LENGTH_MEASURE(1.).
  std::string text = {};
  /// Of a list, and what a type has in its parentheses.
  std::vector<StepValue> items = {};

  /// The number, that in a type too; 0 where there is none.
  double as_number() const;
  /// The entities that it refers to, in order, in lists too.
  std::vector<std::int64_t> references() const;
};

/// What an entity says as being of one type.
struct StepRecord {
  std::string_view type;
  std::vector<StepValue> values = {};

  /// The value at a place; None where there are fewer.
  const StepValue& at(std::size_t i) const;
};

/// An entity is of one type, or of several at once.
struct StepEntity {
  std::vector<StepRecord> records = {};

  /// What it says as being of that type; absent: it is not.
  const StepRecord* as(std::string_view type) const;
  /// The record of an entity of one type; of several the first that is of one of `types`.
  const StepRecord* as_one_of(std::initializer_list<std::string_view> types) const;
};

/// Where the entities of a text begin. The text must outlive it. Broken entities are left out:
/// OCCT tells of them. Linear in the text; entities are read when they are asked for.
class StepText {
 public:
  StepText(std::string_view text, const RunContext& context);

  /// Without records where there is none of that number.
  StepEntity entity(std::int64_t number) const;
  /// The numbers of all entities of a type, those that are of several too, in the order of the
  /// file.
  const std::vector<std::int64_t>& of_type(std::string_view type) const;
  /// All types that the file has.
  std::vector<std::string_view> types() const;

 private:
  void add(std::int64_t number, std::size_t begin, std::size_t end);

  std::string_view text_;
  /// Sorted by number: the text of each.
  std::vector<std::pair<std::int64_t, std::string_view>> entities_;
  std::map<std::string_view, std::vector<std::int64_t>> types_;
};

}  // namespace burin
