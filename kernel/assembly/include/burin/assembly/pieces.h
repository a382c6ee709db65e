#pragma once
/// The bodies of parts, chosen one by one.

#include <burin/surface/scene.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// What a body is called that has a number in its part, "solid 2", and maybe a name that somebody
/// gave it: "solid 2 (housing)". Selectors know it by all of these.
std::string piece_name(const std::string& number, const std::string& given);

/// Splits the parts of which a selector (burin/assembly/select.h) names a single body by its path,
/// "chip/solid 2", or "chip/housing" where somebody gave that name to it: such a part becomes as
/// many parts as it has bodies, which stand in an assembly of its name. The first takes the place
/// of the part, the others follow all parts, so that the numbers of the others stay; of each of
/// these the number of the part that it was a body of is returned. All of them know it
/// (`Part::whole`). With `glazed`, parts of which some bodies can be looked through and others not
/// are split as well. A selector that leads to a part, or to an assembly, names no body of it.
/// Attributes
/// (@color=...) are those of parts. To be called before parts are selected.
std::vector<std::size_t> split_pieces(Scene& scene, std::span<const std::string> selectors,
                                      bool glazed = false);

}  // namespace burin
