#pragma once
/// The files of a run, all of them or none.

#include <burin/base/run_context.h>
#include <burin/converters/output.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace burin::cli {

/// As plan_outputs, standard output last: what is printed cannot be taken back.
std::vector<Output> make_outputs(std::vector<std::string> names, const std::string& format,
                                 const std::vector<std::string>& sources);

/// Calls `write` with each of them and a stream, then gives each its name; from then on signals do
/// nothing. Gives what the formats cannot show. Throws OutputError, Cancelled.
Diagnostics write_outputs(
    std::vector<Output>& outputs, WriteOptions options, RunContext& context,
    const std::function<void(const Output&, const WriteOptions&, std::ostream&)>& write);

/// Writes the drawing to all of them, then gives each its name; from then on signals do nothing.
/// Gives what the formats cannot show of it. Throws OutputError, Cancelled.
Diagnostics write_outputs(std::vector<Output>& outputs, const Drawing& drawing,
                          WriteOptions options, RunContext& context);

}  // namespace burin::cli
