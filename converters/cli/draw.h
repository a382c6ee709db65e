#pragma once
/// `burin draw`.

#include <burin/base/input_files.h>
#include <burin/base/run_context.h>
#include <burin/illustrate/session.h>
#include <burin/surface/scene.h>

#include "arguments.h"
#include "console.h"

#include <optional>

namespace burin::cli {

/// What was read of models, the files that it came from as they were then, and what the last
/// drawing of it was made of.
struct KeptScene {
  InputFiles::Stamps files;
  std::optional<Scene> scene;
  Session session{};
};

/// Reads, draws and writes; prints the drawing's diagnostics. Throws the kernel's errors. `kept`:
/// of a run with the same arguments before this one, used where its files are as they were, else
/// made anew; illustrations are always read.
void run_draw(const DrawArguments& arguments, RunContext& context, Console& console,
              KeptScene* kept = nullptr);

}  // namespace burin::cli
