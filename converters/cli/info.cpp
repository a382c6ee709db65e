#include "info.h"

#include <fmt/core.h>

int run_info(const InfoOptions& options, burin::RunContext& context) {
  std::vector<burin::FileInfo> files;
  context.begin_stage("read");
  for (const std::filesystem::path& path : options.inputs) {
    files.push_back(burin::inspect_file(path, options.read, context));
    if (options.json) continue;
    fmt::print("{}{}", files.size() > 1 ? "\n" : "", burin::to_text(files.back()));
  }
  context.end_stage();
  if (options.json) fmt::print("{}", burin::to_json(files));
  return 0;
}
