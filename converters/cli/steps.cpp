#include "steps.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/values.h>
#include <burin/converters/write_book.h>

#include "inputs.h"
#include "signals.h"

#include <string>
#include <vector>

namespace burin::cli {
namespace {

BuildOptions build_options(const StepsArguments& arguments) {
  BuildOptions build;
  if (arguments.items.empty()) return build;
  constexpr std::uint64_t kMost = 1000;
  build.items = static_cast<std::size_t>(
      whole_option("--items", arguments.items, 1, kMost, "a whole number from 1 to 1000"));
  return build;
}

}  // namespace

void run_steps(const StepsArguments& arguments, RunContext& context, Console& console) {
  const DrawArguments& draw = arguments.draw;
  if (draw.inputs.empty()) {
    throw UsageError("no input; name model files: burin steps INPUT... -o OUT.pdf");
  }
  if (draw.outputs.empty()) {
    throw UsageError("no output; name one: burin steps INPUT... -o OUT.pdf (or .html, .md)");
  }
  const BuildOptions build = build_options(arguments);
  const InputFiles read;
  DrawTask task(find_inputs(draw.inputs), draw.request, Spelling::Options);
  DrawPlan& plan = task.plan;
  check_book_outputs(draw.outputs, sources_of(task.inputs(), read));
  WriteOptions options = write_options(plan.style);
  options.svg.id_prefix = plan.id_prefix;

  const ThreadLimit limit(plan.threads);
  Scene scene = task.follow(task.read(context));
  const Book book = draw_book(scene, plan, build, context);
  context.begin_stage(RunStage::Write);
  std::vector<Output> files = write_book(book, draw.outputs, options, context);
  signals::finish();
  for (Output& file : files) file.commit();
  context.end_stage();
  console.diagnostics(book.diagnostics);
}

}  // namespace burin::cli
