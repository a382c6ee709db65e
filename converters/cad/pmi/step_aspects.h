#pragma once
/// What entities of a STEP file say about each other, found once: entities name only what they are
/// made of, not what is said of them.

#include "step_text.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string_view>
#include <vector>

namespace burin {

/// Brings numbers into ascending order, each once.
template <class T>
void make_set(std::vector<T>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// From an entity to those that name it.
using StepLinks = std::map<std::int64_t, std::vector<std::int64_t>>;

/// Of all entities of some types: from what one parameter names to what another one names, in the
/// order of the file. Of several types at once the parameters of `types` count.
StepLinks links_of(const StepText& text, std::initializer_list<std::string_view> types,
                   std::size_t from, std::size_t to);
/// The faces that aspects of a shape are made of.
class StepAspects {
 public:
  explicit StepAspects(const StepText& text);

  /// The entities of the faces that an aspect of a shape, or what else `items` name it for, is made
  /// of; ascending, each once.
  std::vector<std::int64_t> faces_of(std::int64_t aspect) const;
  /// The aspects that one is related to, in both directions: what a group holds, the datum of a
  /// feature.
  const std::vector<std::int64_t>& related_to(std::int64_t aspect) const;
  /// The definition of the product that an aspect is of; 0: none.
  std::int64_t product_of(std::int64_t aspect) const;

 private:
  void collect(std::int64_t aspect, int depth, std::vector<std::int64_t>& seen,
               std::vector<std::int64_t>& faces) const;

  const StepText& text_;
  StepLinks items_, parts_, relations_;
};

/// The record that has the name, the description, and the shape of an aspect, whatever its type.
const StepRecord* aspect_record(const StepEntity& entity);

}  // namespace burin
