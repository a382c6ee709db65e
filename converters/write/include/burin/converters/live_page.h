#pragma once
/// Pages that load themselves anew while `burin watch` draws them.

#include <cstdint>
#include <string>

namespace burin {

/// The file beside a page that tells it which drawing is the last one.
std::string live_file(const std::string& page);
/// Writes that file: pages that were opened at another number load themselves anew. Throws
/// OutputError.
void note_drawn(const std::string& page, std::int64_t number);
/// Takes it away; pages stop asking.
void forget_drawn(const std::string& page);

}  // namespace burin
