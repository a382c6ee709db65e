#pragma once
// The installed OpenSCAD; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/converters/openscad_reader.h>

#include "programs.h"
#include "subprocess.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace burin::detail {

/// What OpenSCAD is to make of a file.
enum class Makes : std::uint8_t { Mesh, Tree };

/// Why a result that is flat cannot be drawn.
inline constexpr const char* kTwoDimensional =
    "OpenSCAD makes a 2-D object of it, which has no surface to draw; extrude it, e.g. with "
    "linear_extrude(1)";
/// Why there is nothing to draw.
inline constexpr const char* kEmpty = "OpenSCAD makes nothing of it: the top level object is empty";

/// The bytes of a file in memory.
std::string contents(const MemoryFile& file);

/// What it said.
struct ProgramOutput {
  Diagnostics diagnostics;
  /// Its first error, else its first warning, and the place of that; empty where it has neither.
  std::string error = {}, warning = {}, file = {};
  std::int64_t line = 0;
  /// What to do beside that where the program does not know a word; begins with "; ", or is empty.
  std::string hint = {};

  /// Throws InputError: the error; else `what`, and the warning, which may tell why, and what to
  /// do; else of `path`.
  [[noreturn]] void fail(const std::string& what, const std::string& path) const;
};

/// Runs OpenSCAD on a file; what it makes (a binary STL, or the text of the evaluated tree) is left
/// in `out`. `programs`: the one that is tried first is that which ran last; what it does not know
/// is tried with the next. `instead`: a text that stands for that of the file, line by line;
/// absent: its own. Throws as `read_openscad`.
ProgramOutput run_openscad(const std::filesystem::path& path, const OpenscadOptions& options,
                           OpenscadPrograms& programs, Makes makes, const MemoryFile& out,
                           RunContext& context, const std::string* instead = nullptr);

}  // namespace burin::detail
