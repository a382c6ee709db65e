#pragma once
// Which readers look at an option about reading; internal to the room.

#include <burin/converters/read.h>

#include <string_view>

namespace burin::detail {

/// Families of formats, as bits.
enum Family : unsigned {
  kMeshes = 1,
  kCadFiles = 2,
  kSplines = 4,
  kFunctions = 8,
  kOpenscadFiles = 16,
  kFreecadFiles = 32,
  kVolumes = 64,
};

/// A row with who looks at it: `families` are those that do, `purpose` says so in a sentence.
struct ReadRow {
  RequestRow<ReadOptions> row;
  unsigned families = 0;
  std::string_view purpose;
};

/// Null where there is none of that name.
const ReadRow* find_read_row(std::string_view name);

}  // namespace burin::detail
