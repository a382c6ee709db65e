#pragma once
// Which readers look at an option about reading; internal to the module.

#include <burin/converters/read.h>

#include <functional>
#include <string>
#include <string_view>
#include <variant>

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
  Added = 128,  // by plug-ins, each with a name of its own
};

/// A row with who looks at it: `families` are those that do, `purpose` says so in a sentence.
struct ReadRow {
  RequestRow<ReadOptions> row;
  unsigned families = 0;
  std::string purpose;
  /// Of `Added`: the reader or form that the option belongs to.
  std::string added = {};
};

/// Groups of help.
inline constexpr const char* kFiles = "Files";
inline constexpr const char* kData = "Functions and volumes";

inline constexpr double kWeek = 604'800;  // seconds, the longest limit of a program

/// Sets the number that `member` gives of ReadOptions.
template <class M>
std::function<void(ReadOptions&, const Asked&)> number_to(M member) {
  return [member](ReadOptions& o, const Asked& a) { member(o) = std::get<double>(a.value); };
}

/// Null where there is none of that name.
const ReadRow* find_read_row(std::string_view name);

}  // namespace burin::detail
