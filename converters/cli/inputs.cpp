#include "inputs.h"

#include <filesystem>

namespace burin::cli {
namespace {

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

}  // namespace

std::vector<std::string> sources_of(const DrawInputs& inputs, const InputFiles& read) {
  std::vector<std::string> sources = inputs.files;
  if (inputs.illustration) {
    for (const IllustrationInput& input : inputs.illustration->inputs) {
      if (!input.file.empty()) sources.push_back(input.file);
    }
  }
  for (const auto& [name, stamp] : read.stamps()) {
    if (is_file(name)) sources.push_back(name);
  }
  return sources;
}

}  // namespace burin::cli
