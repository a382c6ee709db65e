#include "draw.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/read.h>

#include "inputs.h"
#include "outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin::cli {
namespace {

/// What is asked of reading alone.
Request reading_of(const Request& request) {
  Request reading;
  for (const RequestRow<ReadOptions>& row : read_option_rows()) {
    const std::vector<std::string>& given = given_texts(request, row.name());
    if (!given.empty()) reading[row.name()] = given;
  }
  return reading;
}

ReadResult read_models(const DrawTask& task, const Request& options, RunContext& context,
                       KeptScene* kept) {
  if (!kept || (task.inputs().illustration && !kept->illustrations)) return task.read(context);
  Request reading = reading_of(options);
  if (kept->read && kept->reading == reading) {
    // Heard of before they are looked at: a change in between is not lost.
    for (const auto& [name, stamp] : kept->files) InputFiles::opens(name);
    if (!changed(kept->files)) return *kept->read;
  }
  const InputFiles files;
  ReadResult read = task.read(context);
  kept->files = files.stamps();
  kept->read = read;
  kept->reading = std::move(reading);
  return read;
}

void check_format(const Output& output, const Paper& paper, const WriteOptions& options) {
  check_sheet(paper.width, paper.height, output.format(), options);
}

/// Parts lists that could not be written later, or would take the place of other files.
void check_lists(const DrawPlan& plan, const std::vector<Output>& outputs,
                 std::vector<std::string> sources) {
  for (const Output& output : outputs) {
    if (!output.is_stdout()) sources.push_back(output.name());
  }
  for (const std::string& name : plan.parts_list_files) {
    if (std::ranges::any_of(sources, [&](const auto& other) { return same_file(name, other); })) {
      throw UsageError(fmt::format(
          "{}: the parts list would take the place of another file; name it otherwise", name));
    }
    sources.push_back(name);
    Output(name, *format_named("json")).probe();
  }
}

/// Keys that were set for a format that is not written.
void note_unwritten(const std::vector<Output>& outputs, DrawPlan& plan) {
  const auto written = [&](const Format& format) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const Output& o) { return &o.format() == &format; });
  };
  const auto note = [&](const std::string& what, const Format& format) {
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   fmt::format("{} has no effect: no output is .{}", what, format.name));
  };
  for (const std::string& key : plan.style_keys) {
    const Format* format = only_format_of(key);
    if (format && !written(*format)) note("style key " + key, *format);
  }
  const Format& svg = *format_named("svg");
  if (!plan.id_prefix.empty() && !written(svg)) note("option --id-prefix", svg);
}

}  // namespace

Drawn draw_files(const DrawArguments& arguments, RunContext& context, KeptScene* kept) {
  if (arguments.inputs.empty()) {
    throw UsageError(
        fmt::format("no input; name model files: burin {} INPUT... -o OUT", arguments.command));
  }
  if (arguments.outputs.empty()) {
    throw UsageError(
        fmt::format("no output; name one: burin {} INPUT... -o OUT.svg", arguments.command));
  }
  const InputFiles read;
  DrawTask task(find_inputs(arguments.inputs), arguments.request, Spelling::Options);
  DrawPlan& plan = task.plan;
  WriteOptions options = write_options(plan.style);
  options.svg.id_prefix = plan.id_prefix;
  options.html.live = kept != nullptr && kept->live;
  const std::vector<std::string> sources = sources_of(task.inputs(), read);
  std::vector<Output> outputs = make_outputs(arguments.outputs, arguments.format, sources);
  check_lists(plan, outputs, sources);
  for (const Output& output : outputs) {
    if (!plan.sheet.fits) check_format(output, plan.view.paper, options);
    output.probe();
  }

  const ThreadLimit limit(plan.threads);
  Scene scene = task.follow(read_models(task, arguments.request.options, context, kept));
  note_unwritten(outputs, plan);
  for (const Output& output : outputs) plan.items |= output.format().lists_items;
  arrange_parts(scene, plan, context);
  const SheetOfViews sheet = plan_sheet(scene, plan);
  for (const Output& output : outputs) check_format(output, sheet.camera().paper(), options);
  const Drawing drawing = draw(scene, sheet, plan, context, kept ? &kept->session : nullptr);

  write_parts_lists(drawing, plan);
  Diagnostics diagnostics = drawing.diagnostics;
  diagnostics.append(write_outputs(outputs, drawing, options, context));
  return {std::move(diagnostics), drawing.stats.verify};
}

void run_draw(const DrawArguments& arguments, RunContext& context, Console& console,
              KeptScene* kept) {
  const Drawn drawn = draw_files(arguments, context, kept);
  console.diagnostics(drawn.diagnostics);
  if (drawn.verification) console.verification(*drawn.verification);
}

}  // namespace burin::cli
