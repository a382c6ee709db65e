#pragma once
/// `burin draw`.

#include <burin/base/input_files.h>
#include <burin/base/run_context.h>
#include <burin/converters/read_result.h>
#include <burin/illustrate/session.h>

#include "arguments.h"
#include "console.h"

#include <optional>

namespace burin::cli {

/// What was read of models, the files that it came from as they were then, and what the last
/// drawing of it was made of.
struct KeptScene {
  InputFiles::Stamps files;
  std::optional<ReadResult> read;
  /// What was asked of its reading.
  Request reading{};
  Session session{};
  /// Pages that are written load themselves anew.
  bool live = false;
  /// What an illustration shows is kept, too: its own file, and what it extends, stay as they are.
  bool illustrations = false;
};

/// The messages about a drawing that was written.
struct Drawn {
  Diagnostics diagnostics;
  std::optional<Verification> verification = {};
};

/// Reads, draws and writes. Throws the kernel's errors. `kept`: of a run with the same inputs
/// before this one, used where its files are as they were and are read in the same way, else made
/// anew.
Drawn draw_files(const DrawArguments& arguments, RunContext& context, KeptScene* kept = nullptr);

/// The same, and prints the messages.
void run_draw(const DrawArguments& arguments, RunContext& context, Console& console,
              KeptScene* kept = nullptr);

}  // namespace burin::cli
