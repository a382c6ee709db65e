#include "draw.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/camera/camera.h>
#include <burin/converters/read.h>
#include <burin/converters/write.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>

#include "output.h"
#include "signals.h"
#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace burin::cli {
namespace {

constexpr double kLarge = 1e12;  // past any sheet, scale or tolerance that means something

/// Everything but the inputs themselves.
struct Plan {
  Style style;
  ViewOptions view;
  IllustrateOptions illustrate;
  ReadOptions read;
  int threads = 0;
};

bool is_file(const std::string& name) {
  std::error_code error;
  return std::filesystem::is_regular_file(name, error);
}

Style load_style(const std::string& name) {
  if (!is_file(name)) {
    const bool path = name.find('/') != std::string::npos || name.ends_with(".json");
    if (path) throw InputError("there is no such style file; check the path", name);
    return builtin_style(name);
  }
  std::ifstream in(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw InputError("the style file cannot be read", name);
  return parse_style(text, name);
}

Style make_style(const DrawArguments& a) {
  const auto builtin = builtin_styles();
  const bool known = std::any_of(builtin.begin(), builtin.end(),
                                 [&](const StyleInfo& s) { return s.name == a.style; });
  Style style = known ? builtin_style(a.style) : load_style(a.style);
  if (!a.light.empty()) style.tone.light = direction_option("--light", a.light);
  for (const std::string& assignment : a.set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
      throw UsageError(fmt::format("option --set takes KEY=VALUE, not '{}'", assignment));
    }
    set_style_key(style, assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  check_style(style);
  return style;
}

ViewOptions make_view(const DrawArguments& a) {
  ViewOptions view;
  const NamedView named = named_view(a.view);
  view.direction = named.direction;
  view.up = a.up.empty() ? named.up : direction_option("--up", a.up);
  view.paper = Paper::named(a.paper);
  view.perspective = number_option("--perspective", a.perspective, 1, 170, "1 to 170 degrees");
  view.scale = number_option("--scale", a.scale, 1 / kLarge, kLarge, "a number over 0");
  const double most = 0.5 * std::min(view.paper.width, view.paper.height) - 1;
  const std::string range = fmt::format("0 to {} mm on this paper", most);
  view.margin = number_option("--margin", a.margin, 0, most, range.c_str()).value_or(view.margin);
  return view;
}

Plan make_plan(const DrawArguments& a) {
  Plan plan;
  plan.style = make_style(a);
  plan.view = make_view(a);
  plan.illustrate.tolerance =
      number_option("--tolerance", a.tolerance, 1 / kLarge, kLarge, "a number of mm over 0");
  plan.read.bounds = box_option("--bounds", a.bounds);
  plan.illustrate.seed = whole_option(
      "--seed", a.seed, 0, std::numeric_limits<std::uint64_t>::max(), "a whole number from 0");
  if (a.hidden != "none" && a.hidden != "dashed") {
    throw UsageError(fmt::format("option --hidden takes none or dashed, not '{}'", a.hidden));
  }
  plan.illustrate.hidden = a.hidden == "dashed" ? HiddenLines::Dashed : HiddenLines::None;
  if (!a.threads.empty()) {
    plan.threads = static_cast<int>(whole_option("--threads", a.threads, 1, 4096, "1 to 4096"));
  }
  return plan;
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
  const Plan plan = make_plan(arguments);
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
