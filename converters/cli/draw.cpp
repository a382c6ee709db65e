#include "draw.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/camera/camera.h>
#include <burin/converters/read.h>
#include <burin/illustrate/illustrate.h>

#include "outputs.h"

#include <filesystem>

namespace burin::cli {
namespace {

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

std::vector<std::string> sources_of(const DrawArguments& a) {
  std::vector<std::string> sources = a.inputs;
  if (is_file(a.style)) sources.push_back(a.style);
  return sources;
}

}  // namespace

void run_draw(const DrawArguments& arguments, RunContext& context, Console& console) {
  if (arguments.inputs.empty()) {
    throw UsageError("no input; name model files: burin draw INPUT... -o OUT");
  }
  if (arguments.outputs.empty()) {
    throw UsageError("no output; name one: burin draw INPUT... -o OUT.svg");
  }
  const DrawPlan plan = make_plan(arguments, Spelling::Options);
  const WriteOptions options = write_options(plan.style);
  std::vector<Output> outputs =
      make_outputs(arguments.outputs, arguments.format, sources_of(arguments));
  check_inputs(arguments.inputs);
  for (const Output& output : outputs) {
    check_sheet(plan.view.paper.width, plan.view.paper.height, output.format(), options);
    output.probe();
  }

  const ThreadLimit limit(plan.threads);
  const Scene scene = read_scene(arguments.inputs, plan.read, context);
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, plan.view);
  const Drawing drawing = illustrate(scene, camera, plan.style, plan.illustrate, context);

  write_outputs(outputs, drawing, options, context);
  console.diagnostics(drawing.diagnostics);
}

}  // namespace burin::cli
