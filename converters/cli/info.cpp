#include "info.h"

#include <burin/converters/messages.h>

#include <fmt/core.h>

int run_info(const InfoOptions& options, burin::RunContext& context) {
  std::vector<burin::FileInfo> files;
  context.begin_stage(burin::RunStage::Read);
  for (const std::filesystem::path& path : options.inputs) {
    files.push_back(burin::inspect_file(path, options.read, context));
    burin::FileInfo& info = files.back();
    info.diagnostics = burin::with_spelling(info.diagnostics, burin::Spelling::Options);
    if (options.json) continue;
    fmt::print("{}{}", files.size() > 1 ? "\n" : "", burin::to_text(info));
  }
  context.end_stage();
  if (options.json) fmt::print("{}", burin::to_json(files));
  return 0;
}
