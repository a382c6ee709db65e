#pragma once
/// What an assembly is made of: items, each with a number, and how many there are of each.

#include <burin/base/run_context.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Parts of one shape and one name.
struct Item {
  /// From 1; kept from run to run where the numbers of the last one are given.
  int number = 0;
  /// Of no other item.
  std::string name;
  /// "#rrggbb" where all of them have it, else empty; the file, where all come from one.
  std::string color, source;
  /// Parts of the scene, ascending; as many as there are.
  std::vector<std::size_t> parts;
};

/// Numbers and the names of what has them. A number whose name is gone stays a hole.
using ItemNumbers = std::map<int, std::string>;

inline constexpr int kLargestItem = 99'999;

/// A name without what readers and programs add to tell instances apart: " #2", "_2", ".002", ":3",
/// " (4)", "-5", "Bolt001"; the name itself where nothing else would be left.
std::string instance_stem(std::string_view name);

/// The items of a scene, by number. Two parts are of one item where they have one name (that of
/// what they are instances of, or their own without what tells instances apart) and one shape: they
/// are instances of one form, or their measures are the same within 1e-6 (`Form::measure`, which is
/// asked of forms of one name alone). Items that would have the same name get " (2)", " (3)" in the
/// order of the scene. `kept`: numbers that names have already; new ones get the next after the
/// largest. Parts that cannot be measured are told in `diagnostics` ("items.not_measured") and are
/// items of their own. Throws Cancelled.
std::vector<Item> find_items(const Scene& scene, const ItemNumbers& kept, Diagnostics& diagnostics,
                             RunContext& context);

/// Kept numbers with those of items added.
ItemNumbers numbers_of(const std::vector<Item>& items, const ItemNumbers& kept);

}  // namespace burin
