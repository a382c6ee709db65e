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
  /// As the input has it, of no other item; or as the number that is kept calls it.
  std::string name;
  /// "#rrggbb" where all of them have it, else empty; the file, where all come from one.
  std::string color, source;
  /// Parts of the scene, ascending; those of one thing (`Part::joined`) all. A part that was split
  /// into its bodies (`Part::whole`) is one, and has all of them here.
  std::vector<std::size_t> parts;
};

/// What is kept of an item beside its number.
struct KeptItem {
  /// Empty: as the input calls it.
  std::string name;
  /// Names a part of it, whatever the input calls that (`select`); empty: the name tells.
  std::string select = {};
  /// Where no item has the name, the one that has this number by its place in the scene is called
  /// so.
  bool renames = false;
  bool operator==(const KeptItem&) const = default;
};

/// Numbers and what has them. A number whose item is gone stays a hole.
using ItemNumbers = std::map<int, KeptItem>;

inline constexpr int kLargestItem = 99'999;

/// A name without the " #2" that readers add to what has the name of another part.
std::string_view name_as_read(std::string_view name);

/// A name without what readers and programs add to tell instances apart: " #2", "_2", ".002", ":3",
/// " (4)", "-5", "Bolt001"; the name itself where nothing else would be left.
std::string instance_stem(std::string_view name);

/// `instance_stem` of what a part is an instance of, or else of its own name: what copies of a part
/// have in common, whatever they are called.
std::string stem_of(const Part& part);

/// The items of a scene, by number.
///
/// Two parts are of one item where they have one name and one shape. Names are those of what they
/// are instances of (`Part::definition`), or their own, and are one where they differ by no more
/// than a number at the end. Shapes are one where both are instances of one form, or where a rigid
/// move lays one on the other: their measures are the same within 1e-6 (`Form::measure`, asked of
/// forms of one name alone), and where these do not tell a shape from its mirror image, their
/// surfaces are tried. So a shape that is its own mirror image is one item with its mirrored
/// copies; left and right are two. Parts that are one thing are compared as one.
///
/// Items that would have the same name get " (2)", " (3)" in the order of the scene. `kept`:
/// numbers that items have already, each the item that its selector names, else that of its name,
/// else, where it renames, that of its place ("items.renamed"). New items get the next numbers
/// after the largest, or, where one is renamed so, those of their place. Parts that cannot be
/// measured are told ("items.not_measured") and are items of their own. `unlisted`: parts that are
/// of no item, one flag a part; fewer: the others are of one. Where two
/// numbers select copies of one thing each is an item, of those that it selects. Throws UsageError
/// where a selector of `kept` names parts of several items, or the same as another; Cancelled.
std::vector<Item> find_items(const Scene& scene, const ItemNumbers& kept, Diagnostics& diagnostics,
                             RunContext& context, const std::vector<bool>& unlisted = {});

/// Kept numbers with those of items added.
ItemNumbers numbers_of(const std::vector<Item>& items, const ItemNumbers& kept);

}  // namespace burin
