#include "draw.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/read.h>

#include "outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace burin::cli {
namespace {

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

std::vector<std::string> sources_of(const DrawArguments& a) {
  std::vector<std::string> sources = a.inputs;
  const std::vector<std::string>& style = given_texts(a.request.options, "style");
  if (!style.empty() && is_file(style.back())) sources.push_back(style.back());
  return sources;
}

void check_format(const Output& output, const Paper& paper, const WriteOptions& options) {
  check_sheet(paper.width, paper.height, output.format(), options);
}

/// Keys that were set for a format that is not written.
void note_unwritten(const DrawArguments& arguments, const std::vector<Output>& outputs,
                    DrawPlan& plan) {
  const auto written = [&](const Format& format) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const Output& o) { return &o.format() == &format; });
  };
  const auto note = [&](const std::string& what, const Format& format) {
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   fmt::format("{} has no effect: no output is .{}", what, format.name));
  };
  for (const std::string& assignment : given_texts(arguments.request.options, "set")) {
    const std::string key = parted_assignment(assignment).first;
    const Format* format = only_format_of(key);
    if (format && !written(*format)) note("style key " + key, *format);
  }
  const Format& svg = *format_named("svg");
  if (!plan.id_prefix.empty() && !written(svg)) note("option --id-prefix", svg);
}

}  // namespace

void run_draw(const DrawArguments& arguments, RunContext& context, Console& console) {
  if (arguments.inputs.empty()) {
    throw UsageError("no input; name model files: burin draw INPUT... -o OUT");
  }
  if (arguments.outputs.empty()) {
    throw UsageError("no output; name one: burin draw INPUT... -o OUT.svg");
  }
  DrawPlan plan = make_plan(arguments.request, Spelling::Options);
  WriteOptions options = write_options(plan.style);
  options.svg.id_prefix = plan.id_prefix;
  std::vector<Output> outputs =
      make_outputs(arguments.outputs, arguments.format, sources_of(arguments));
  note_unwritten(arguments, outputs, plan);
  check_inputs(arguments.inputs);
  for (const Output& output : outputs) {
    if (!plan.sheet.fits) check_format(output, plan.view.paper, options);
    output.probe();
  }

  const ThreadLimit limit(plan.threads);
  const Scene scene = read_scene(arguments.inputs, plan.read, context);
  const Camera camera = make_camera(scene, plan);
  for (const Output& output : outputs) check_format(output, camera.paper(), options);
  const Drawing drawing = draw(scene, camera, plan, context);

  write_outputs(outputs, drawing, options, context);
  console.diagnostics(drawing.diagnostics);
  if (drawing.stats.verify) console.verification(*drawing.stats.verify);
}

}  // namespace burin::cli
