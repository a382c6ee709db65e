#include "info.h"

#include <burin/converters/file_info.h>

#include "readers.h"

#include <fmt/core.h>

int run_info(const InfoOptions& options, burin::RunContext& context) {
  std::vector<burin::FileInfo> files;
  context.begin_stage("read");
  for (const std::filesystem::path& path : options.inputs) {
    files.push_back(burin::cli::reader_of(path).inspect(path, {options.bounds}, context));
    if (options.json) continue;
    fmt::print("{}{}", files.size() > 1 ? "\n" : "", burin::to_text(files.back()));
  }
  context.end_stage();
  if (options.json) fmt::print("{}", burin::to_json(files));
  return 0;
}
