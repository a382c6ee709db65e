#include "illustrate.h"

#include <burin/base/error.h>
#include <burin/converters/illustration.h>
#include <burin/converters/messages.h>
#include <burin/converters/output.h>
#include <burin/converters/read.h>

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <string>

namespace burin::cli {

void run_illustrate(const DrawArguments& arguments, RunContext& context, Console& console) {
  if (arguments.inputs.empty()) {
    throw UsageError("no input; name model files: burin illustrate INPUT... -o NAME.burin.json");
  }
  if (arguments.outputs.size() != 1) {
    throw UsageError("name one output: burin illustrate INPUT... -o NAME.burin.json");
  }
  const std::string& name = arguments.outputs.front();
  DrawPlan plan = make_plan(arguments.request, Spelling::Options);  // refuses what a drawing would
  check_inputs(arguments.inputs);
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
  std::vector<Explode::Step> steps;
  if (plan.explode.wanted) {
    Scene scene = read_scene(arguments.inputs, plan.read, context);
    select_parts(scene, plan);
    steps = explode_steps(scene, plan, context);
    console.diagnostics(at_door(scene.diagnostics, Spelling::Options));
  }
  const std::string text = first_illustration(arguments.inputs, arguments.request, folder, steps);
  output.write([&](std::ostream& out) { out << text; });
  output.commit();
}

}  // namespace burin::cli
