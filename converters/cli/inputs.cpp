#include "inputs.h"

#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace burin::cli {
namespace {

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

/// Each part of an illustration has options of its own.
void refuse_reading(const DrawPlan& plan) {
  if (plan.read.given.empty()) return;
  throw UsageError(plan.read.given.front().spelled +
                   " is about reading: in an illustration it belongs to a part, {\"file\": ...}");
}

}  // namespace

std::optional<IllustrationFile> illustration_of(const std::vector<std::string>& inputs) {
  const auto found =
      std::ranges::find_if(inputs, [](const std::string& input) { return is_illustration(input); });
  if (found == inputs.end()) return std::nullopt;
  if (inputs.size() > 1) {
    throw UsageError(fmt::format(
        "'{}' is an illustration file, which is drawn alone: name the others in its \"parts\"",
        *found));
  }
  return read_illustration(*found);
}

std::vector<std::string> sources_of(const DrawArguments& a,
                                    const std::optional<IllustrationFile>& illustration,
                                    const InputFiles& read) {
  std::vector<std::string> sources = a.inputs;
  if (illustration) {
    for (const IllustrationInput& input : illustration->inputs) {
      if (!input.file.empty()) sources.push_back(input.file);
    }
  }
  for (const auto& [name, stamp] : read.stamps()) {
    if (is_file(name)) sources.push_back(name);
  }
  return sources;
}

DrawPlan plan_of(const DrawArguments& arguments,
                 const std::optional<IllustrationFile>& illustration) {
  if (!illustration) return make_plan(arguments.request, Spelling::Options);
  DrawPlan plan = make_plan(merged(illustration->request, arguments.request), Spelling::Options);
  refuse_reading(plan);
  return plan;
}

void follow_files(const Scene& scene, const DrawArguments& arguments, DrawPlan& plan) {
  if (scene.settings.empty()) return;
  plan = make_plan(with_settings(scene, arguments.request), Spelling::Options);
}

}  // namespace burin::cli
