#include "illustrate.h"

#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/output.h>
#include <burin/converters/plan.h>
#include <burin/converters/read.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace burin::cli {
namespace {

[[noreturn]] void refuse_illustration(const std::string& name) {
  throw UsageError(
      fmt::format("'{}' is an illustration file already; alone and with --explode auto, one that "
                  "extends it by the steps of an exploded view is written; alone, where it has "
                  "rows of \"dimensions\" or \"notes\", one by which these are found again in "
                  "changed models",
                  name));
}

/// Whether an illustration is to be extended by its exploded view or its dimensions and notes.
/// Throws UsageError where it is an input for anything else.
bool extends_another(const DrawArguments& arguments) {
  const auto found = std::ranges::find_if(
      arguments.inputs, [](const std::string& input) { return is_illustration(input); });
  if (found == arguments.inputs.end()) return false;
  if (arguments.inputs.size() > 1) refuse_illustration(*found);
  for (const auto& [name, texts] : arguments.request.options) {
    if (name == "explode" || name == "explode_factor") continue;
    throw UsageError(called(name, Spelling::Options) +
                     " is for a first file; in one that extends an illustration it is a key to be "
                     "written by hand");
  }
  return true;
}

/// The steps by which a scene comes apart; what is to be said of them is said.
std::vector<ExplodeStep> steps_of(Scene scene, DrawPlan& plan, RunContext& context,
                                  Console& console) {
  select_parts(scene, plan);
  std::vector<ExplodeStep> steps = explode_steps(scene, plan, context);
  console.diagnostics(with_spelling(scene.diagnostics, Spelling::Options));
  return steps;
}

std::string with_kept_features(const std::string& base_illustration, DrawTask& task,
                               const std::filesystem::path& folder, RunContext& context,
                               Console& console) {
  Scene scene = task.follow(task.read(context));
  select_parts(scene, task.plan);
  keep_features(scene, task.plan, context);
  console.diagnostics(with_spelling(scene.diagnostics, Spelling::Options));
  return kept_illustration(base_illustration, folder, task.plan);
}

std::string extended(const DrawArguments& arguments, const std::filesystem::path& folder,
                     RunContext& context, Console& console) {
  const std::string& base_illustration = arguments.inputs.front();
  DrawTask task(find_inputs(arguments.inputs), arguments.request, Spelling::Options);
  const bool measures = !task.plan.dimensions.empty() || !task.plan.note_rows.empty();
  if (!arguments.request.has("explode") && measures) {
    return with_kept_features(base_illustration, task, folder, context, console);
  }
  const bool explodes = arguments.request.has("explode") && task.plan.explode.wanted;
  if (!explodes) refuse_illustration(base_illustration);  // --explode none
  Scene scene = task.follow(task.read(context));
  return exploded_illustration(base_illustration, arguments.request, folder,
                               steps_of(std::move(scene), task.plan, context, console));
}

ItemNumbers numbers_of_models(Scene scene, const ItemNumbers& kept, RunContext& context) {
  return numbers_of(find_items(scene, kept, scene.diagnostics, context), kept);
}

std::string first(const DrawArguments& arguments, DrawPlan& plan,
                  const std::filesystem::path& folder, RunContext& context, Console& console) {
  DrawRequest request = arguments.request;
  const bool numbers = plan.callouts || plan.parts_list || !plan.parts_list_files.empty();
  const bool marked = std::ranges::any_of(
      arguments.inputs, [](const std::string& input) { return is_openscad_suffix(input); });
  Scene scene;
  if (numbers || plan.explode.wanted || marked) {
    DrawTask task({.files = arguments.inputs}, request, Spelling::Options);
    ReadResult read = task.read(context);
    request = with_marks(read.marks, request);
    scene = task.follow(std::move(read));
    plan = std::move(task.plan);
  }
  if (numbers || plan.callouts) {
    request.items = numbers_of_models(scene, request.items, context);
  }
  std::vector<ExplodeStep> steps;
  if (plan.explode.wanted) steps = steps_of(std::move(scene), plan, context, console);
  return first_illustration(arguments.inputs, request, folder, steps);
}

}  // namespace

void run_illustrate(const DrawArguments& arguments, RunContext& context, Console& console) {
  if (arguments.inputs.empty()) {
    throw UsageError("no input; name model files: burin illustrate INPUT... -o NAME.burin.json");
  }
  if (arguments.outputs.size() != 1) {
    throw UsageError("name one output: burin illustrate INPUT... -o NAME.burin.json");
  }
  const std::string& name = arguments.outputs.front();
  std::optional<DrawPlan> plan;  // refuses what a drawing would
  if (!extends_another(arguments)) {
    plan = make_plan(arguments.request, Spelling::Options);
    check_inputs(arguments.inputs);
  }
  Output output(name, *format_named("json"));
  if (!output.is_stdout()) {
    if (!is_illustration(name)) {
      throw UsageError(
          fmt::format("'{}': illustration files end in .json, best .burin.json", name));
    }
    std::error_code error;
    if (std::filesystem::exists(name, error)) {
      throw OutputError("is there already and may have been edited; remove it or name another",
                        name);
    }
  }
  const auto folder =
      output.is_stdout() ? std::filesystem::path() : std::filesystem::path(name).parent_path();
  const std::string text = plan ? first(arguments, *plan, folder, context, console)
                                : extended(arguments, folder, context, console);
  output.write([&](std::ostream& out) { out << text; });
  output.commit();
  if (arguments.request.has("highlight")) {
    Diagnostics notes;
    notes.add(Severity::Warning, "option.unused", 1,
              "`highlight` is no key of illustration files: give it to burin draw with this file, "
              "or write a look with \"fill.color\"");
    console.diagnostics(with_spelling(notes, Spelling::Options));
  }
}

}  // namespace burin::cli
