#pragma once
/// `burin info`: what stands in a file, and what is wrong with it.

#include <burin/base/run_context.h>
#include <burin/converters/read.h>

#include <filesystem>
#include <vector>

struct InfoOptions {
  std::vector<std::filesystem::path> inputs;
  burin::ReadOptions read = {};
  /// For programs: one JSON object for all inputs, printed when all are read.
  bool json = false;
};

/// Prints to standard output and returns 0. Throws InputError where an input cannot be read.
int run_info(const InfoOptions& options, burin::RunContext& context);
