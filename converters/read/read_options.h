#pragma once
// Which readers look at an option about reading; internal to the module.

#include <burin/converters/read.h>

#include <string_view>

namespace burin::detail {

/// Families of formats, as bits.
enum Family : unsigned {
  Meshes = 1,
  CadFiles = 2,
  Splines = 4,
  Functions = 8,
  OpenscadFiles = 16,
  FreecadFiles = 32,
  Volumes = 64,
  Brought = 128,  // by plug-ins, each with a name of its own
};

/// A row with who looks at it: `families` are those that do, `purpose` says so in a sentence.
struct ReadRow {
  RequestRow<ReadOptions> row;
  unsigned families = 0;
  std::string purpose;
  /// Of `Brought`: the reader or form that the option belongs to.
  std::string brought = {};
};

/// Null where there is none of that name.
const ReadRow* find_read_row(std::string_view name);

}  // namespace burin::detail
