#include "diff.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/diff.h>
#include <burin/converters/read_drawing.h>

#include "inputs.h"
#include "outputs.h"
#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <utility>

namespace burin::cli {
namespace {

/// One revision as it is asked for: a command line of its own.
struct Side {
  DrawTask task;

  Side(const DrawArguments& all, const std::string& input)
      : task(find_inputs({input}), all.request, Spelling::Options) {}

  Revision read(RunContext& context) {
    const std::filesystem::path path = task.inputs().files.front();
    return read_revision(task, path.filename().string(), context);
  }
};

double line_tolerance(const DiffArguments& arguments) {
  constexpr const char* kOption = "--line-tolerance";
  if (arguments.line_tolerance.empty()) return kLineTolerance;
  constexpr double kLeast = 0.001, kMost = 100;
  std::array<double, 1> mm{};
  const bool read = parse_list(arguments.line_tolerance, mm);
  if (!read || mm[0] < kLeast || mm[0] > kMost) {
    refuse_value(kOption, "0.001 to 100 mm", arguments.line_tolerance);
  }
  return mm[0];
}

/// Whether there is more to write than the report for programs.
bool draws(const std::vector<Output>& outputs) {
  return std::ranges::any_of(outputs, [](const Output& output) {
    return !is_difference_report(output.name(), output.format());
  });
}

int finish(const DiffOutcome& outcome, std::vector<Output>& outputs, const WriteOptions& options,
           bool quiet, RunContext& context, Console& console) {
  const Diagnostics reported =
      write_outputs(outputs, options, context,
                    [&](const Output& output, const WriteOptions& how, std::ostream& out) {
                      write_difference(outcome, output.name(), output.format(), how, out, context);
                    });
  console.diagnostics(outcome.diagnostics);
  console.diagnostics(reported);
  if (outcome.drawing) {
    Diagnostics others;
    for (const Diagnostic& d : outcome.drawing->diagnostics.entries()) {
      const auto said = [&](const Diagnostic& e) {
        return e.code == d.code && e.message == d.message;
      };
      if (std::ranges::none_of(outcome.diagnostics.entries(), said)) others.add(d);
    }
    console.diagnostics(others);
  }
  console.clear();
  // What is printed for programs stays alone.
  const bool printed = std::ranges::any_of(outputs, &Output::is_stdout);
  if (!quiet && !printed) {
    const std::string text = difference_text(outcome);
    std::fwrite(text.data(), 1, text.size(), stdout);
  }
  return outcome.same ? kDone : kDifferent;
}

int diff_two_drawings(const DiffArguments& arguments, bool quiet, RunContext& context,
                      Console& console) {
  const DrawArguments& a = arguments.draw;
  for (const auto& [name, texts] : a.request.options) {
    if (name == "set" || name == "id_prefix" || name == "threads") continue;
    throw UsageError(called(name, Spelling::Options) +
                     " has shaped a drawing already; of two drawings the lines are compared");
  }
  const DrawPlan plan = make_plan(a.request, Spelling::Options);
  for (const std::string& key : plan.style_keys) {
    if (is_about_files(key)) continue;
    throw UsageError(fmt::format("style key '{}' shapes a drawing, not its file", key));
  }
  const double tolerance = line_tolerance(arguments);
  WriteOptions options = write_options(plan.style);
  options.svg.id_prefix = plan.id_prefix;
  std::vector<Output> outputs = make_outputs(a.outputs, a.format, a.inputs);
  for (const Output& output : outputs) output.probe();
  const ThreadLimit limit(plan.threads);
  context.begin_stage(RunStage::Read);
  const Drawing before = read_drawing(a.inputs[0], context);
  const Drawing after = read_drawing(a.inputs[1], context);
  context.begin_stage(RunStage::Compose);
  const auto name = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const DiffOutcome outcome = diff_drawings(before, after, name(a.inputs[0]), name(a.inputs[1]),
                                            tolerance, draws(outputs), context);
  context.end_stage();
  return finish(outcome, outputs, options, quiet, context, console);
}

int diff_two_models(const DiffArguments& arguments, bool quiet, RunContext& context,
                    Console& console) {
  const DrawArguments& a = arguments.draw;
  if (!arguments.line_tolerance.empty()) {
    throw UsageError("option --line-tolerance is about two drawing files; these are models");
  }
  const InputFiles read;
  std::array<Side, 2> sides{Side(a, a.inputs[0]), Side(a, a.inputs[1])};
  std::vector<std::string> sources;
  for (const Side& side : sides) {
    const auto more = sources_of(side.task.inputs(), read);
    sources.insert(sources.end(), more.begin(), more.end());
  }
  std::vector<Output> outputs = make_outputs(a.outputs, a.format, sources);
  for (const Output& output : outputs) output.probe();
  const ThreadLimit limit(sides[1].task.plan.threads);
  Revision before = sides[0].read(context), after = sides[1].read(context);
  WriteOptions options = write_options(after.plan.style);
  options.svg.id_prefix = after.plan.id_prefix;
  const DiffOutcome outcome =
      diff_models(std::move(before), std::move(after), draws(outputs), context);
  return finish(outcome, outputs, options, quiet, context, console);
}

}  // namespace

int run_diff(const DiffArguments& arguments, RunContext& context, Console& console) {
  const DrawArguments& a = arguments.draw;
  if (a.inputs.size() != 2) {
    throw UsageError(fmt::format(
        "diff takes two revisions, not {}: burin diff OLD NEW [-o OUT.svg]", a.inputs.size()));
  }
  const bool first = is_drawing_file(a.inputs[0]), second = is_drawing_file(a.inputs[1]);
  if (first != second) {
    throw UsageError(fmt::format(
        "'{}' is a drawing and '{}' is none: compare a drawing with a drawing, a model with a "
        "model",
        a.inputs[first ? 0 : 1], a.inputs[first ? 1 : 0]));
  }
  const bool quiet = console.quiet();
  return first ? diff_two_drawings(arguments, quiet, context, console)
               : diff_two_models(arguments, quiet, context, console);
}

}  // namespace burin::cli
