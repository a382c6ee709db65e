#pragma once
/// What is piped into the program: bytes that come once, and are asked for more than once.

#include <burin/base/run_context.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace burin {

/// Whether a file is standard input or a pipe that a shell made of <(command).
bool is_piped(const std::filesystem::path& path);

/// All of a pipe, read when it is first asked for and kept, `most` bytes at the most. Polls
/// `context` while nothing comes. Throws InputError; where standard input is a terminal too. Safe
/// from many threads.
std::shared_ptr<const std::string> piped_input(const std::filesystem::path& path, std::size_t most,
                                               const RunContext& context);

}  // namespace burin
