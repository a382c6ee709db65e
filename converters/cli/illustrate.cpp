#include "illustrate.h"

#include <burin/base/error.h>
#include <burin/converters/illustration.h>
#include <burin/converters/output.h>
#include <burin/converters/read.h>

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <string>

namespace burin::cli {
namespace {

ItemNumbers numbers_of_models(const std::vector<std::string>& inputs, const DrawPlan& plan,
                              RunContext& context) {
  Scene scene = read_scene(inputs, plan.read, context);
  return numbers_of(find_items(scene, {}, scene.diagnostics, context), {});
}

}  // namespace

void run_illustrate(const DrawArguments& arguments, RunContext& context) {
  if (arguments.inputs.empty()) {
    throw UsageError("no input; name model files: burin illustrate INPUT... -o NAME.burin.json");
  }
  if (arguments.outputs.size() != 1) {
    throw UsageError("name one output: burin illustrate INPUT... -o NAME.burin.json");
  }
  const std::string& name = arguments.outputs.front();
  const DrawPlan plan = make_plan(arguments.request, Spelling::Options);  // refuses as a drawing
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
  DrawRequest request = arguments.request;
  if (plan.callouts || plan.parts_list || !plan.parts_list_files.empty()) {
    request.items = numbers_of_models(arguments.inputs, plan, context);
  }
  const std::string text = first_illustration(arguments.inputs, request, folder);
  output.write([&](std::ostream& out) { out << text; });
  output.commit();
}

}  // namespace burin::cli
