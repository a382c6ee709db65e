#pragma once
/// Parts of an assembly by name.

#include <burin/assembly/items.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The names from the top of the assembly down to the part, with slashes: "pump/cover/bolt".
std::string path_of(const Part& part);

/// For each part a selector that names it alone: its path from the top, "/pump/cover/bolt", or,
/// where another part or an assembly has that path, its number, "@index=3". Parts that are one
/// thing (`Part::joined`) share one, that of all of them. A letter that names and
/// selectors have for different things stands as ?.
std::vector<std::string> selectors_of(const Scene& scene);

/// The parts that a selector names, ascending.
///
/// A selector is a name or names with slashes between them, at any depth of the assembly, from its
/// top where it begins with a slash; they lead to a part, or to an assembly, whose parts are all
/// meant. In a name * is any text and ? any letter; ** stands for any number of names. Not from the
/// top, "bolt" means "bolt #2" too: readers number what the input calls the same. A name
/// means what is within the one assembly that holds all, before that assembly: "gear*" are the
/// gears of a gear pump, "rod" is the rod of an assembly "rod".
/// @color=#88c0ff selects by colour, @index=3 by number, from 0, as `burin info` and
/// drawing files count, @file=lid.stl those of a file.
///
/// Where no part or assembly has the name, that of an item is meant, as lists and legends have it
/// (`find_items`, first those that `name_items` gave): "M6 screw", "arm (2)".
///
/// Throws UsageError that names the nearest names where it selects nothing.
std::vector<std::size_t> select(const Scene& scene, std::string_view selector);

/// Gives parts the names that are kept for their items (`Part::item_name`) where one of the
/// selectors means such a name and selects nothing without it. Throws UsageError as `find_items`.
void name_items(Scene& scene, const ItemNumbers& kept, std::span<const std::string> selectors);

/// How closely a selector names each of some parts that it selects: 0 for the part itself, by its
/// name, item or attribute, 1 for the assembly that it is in, 2 for the one above. Where several
/// names of its path match, the highest that is meant counts: "*" means all there is.
std::vector<std::size_t> levels_above(const Scene& scene, std::span<const std::size_t> parts,
                                      std::string_view selector);

}  // namespace burin
