#include "draw.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/camera/camera.h>
#include <burin/converters/output.h>
#include <burin/converters/read.h>
#include <burin/converters/write.h>
#include <burin/illustrate/illustrate.h>

#include "signals.h"

#include <algorithm>
#include <filesystem>

namespace burin::cli {
namespace {

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

std::vector<Output> make_outputs(const DrawArguments& a) {
  std::vector<std::string> sources = a.inputs;
  if (is_file(a.style)) sources.push_back(a.style);
  // What is printed cannot be taken back: after all that is written aside.
  std::vector<std::string> names = a.outputs;
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != "-"; });
  return plan_outputs(names, a.format, sources);
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
  std::vector<Output> outputs = make_outputs(arguments);
  check_inputs(arguments.inputs);
  for (const Output& output : outputs) output.probe();

  const ThreadLimit limit(plan.threads);
  const Scene scene = read_scene(arguments.inputs, plan.read, context);
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, plan.view);
  const Drawing drawing = illustrate(scene, camera, plan.style, plan.illustrate, context);

  context.begin_stage("write");
  const WriteOptions options = write_options(plan.style);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    outputs[i].write([&](std::ostream& out) {
      write_drawing(drawing, outputs[i].format(), options, out, context);
    });
    context.progress(static_cast<double>(i + 1) / static_cast<double>(outputs.size()));
  }
  context.check();
  signals::finish();
  for (Output& output : outputs) output.commit();
  context.end_stage();
  console.diagnostics(drawing.diagnostics);
}

}  // namespace burin::cli
