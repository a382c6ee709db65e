#pragma once
/// `burin batch job`: what the batch starts for each of its parts.

#include <burin/base/run_context.h>

namespace burin::cli {

/// Draws the drawings of one part, which is read once. From standard input one JSON object:
///
///     {"inputs": ["part.step"], "threads": 1, "check": false,
///      "drawings": [{"options": {"view": ["front"]}, "outputs": ["a.svg"], "lists": ["a.csv"]}]}
///
/// Options are those of `burin draw` with underscores, each a list of texts; "lists" are files of
/// parts lists. To standard output one JSON object a line, as soon as it is known: {"version"}; of
/// each drawing {"drawing": number} when it begins and {"drawing", "seconds", "files",
/// "diagnostics"}, with "error": {"kind", "message"} where it failed, when it ends; {"done": true}.
/// "files" are those that were opened, [name, stamp] with the stamp [device, node, size, changed,
/// renewed] as it was then, or null where there was none. With "check" options and names of outputs
/// are looked at, nothing is drawn. It ends with the process that started it. Throws UsageError for
/// what is no such object.
void run_batch_job(RunContext& context);

}  // namespace burin::cli
