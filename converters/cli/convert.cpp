#include "convert.h"

#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/base/parallel.h>
#include <burin/converters/mesh_writer.h>
#include <burin/converters/messages.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/read.h>
#include <burin/converters/read_drawing.h>
#include <burin/converters/values.h>
#include <burin/illustrate/style.h>

#include "outputs.h"
#include "signals.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <utility>

namespace burin::cli {
namespace {

Style make_style(const std::vector<std::string>& assignments) {
  Style style = builtin_style("technical");
  for (const std::string& text : assignments) {
    const auto [key, value] = parted_assignment(text);
    set_style_key(style, key, value);
    if (is_about_files(key)) continue;
    throw UsageError(
        fmt::format("style key '{}' shapes a drawing, not its file; give it to burin draw (convert "
                    "takes svg. png. dxf. hpgl. gcode. json. line.dash line.gap)",
                    key));
  }
  check_style(style);
  return style;
}

/// That of an option that was given; else `absent`.
template <class T>
T asked(const ConvertArguments& a, const std::string& name, T absent) {
  const auto value =
      asked_value(find_option(all_options(), name), a.options, spelled(name, Spelling::Options));
  return value ? std::get<T>(*value) : absent;
}

/// Solids of OpenSCAD files as mesh files.
void convert_solid(const ConvertArguments& arguments, RunContext& context, Console& console) {
  std::vector<std::pair<Output, const MeshWriter*>> outputs;
  for (const std::string& name : arguments.outputs) {
    const std::string suffix = std::filesystem::path(name).extension().string();
    const std::string format = !arguments.format.empty() ? arguments.format
                               : suffix.empty()          ? suffix
                                                         : suffix.substr(1);
    const MeshWriter* writer = mesh_writer_named(format);
    if (!writer) {
      throw UsageError(
          fmt::format("'{}': solids of OpenSCAD files are written as .stl, .off or "
                      ".3mf; burin draw makes drawings of them",
                      name));
    }
    if (same_file(name, arguments.input)) {
      throw UsageError(fmt::format("{}: is also an input; give the output another name", name));
    }
    for (const auto& other : outputs) {
      if (!same_file(name, other.first.name())) continue;
      throw UsageError(fmt::format("{}: is given twice as output; name it once", name));
    }
    outputs.emplace_back(Output(name, *format_named("json")), writer);
    outputs.back().first.probe();
  }
  const ReadOptions read = make_read_options(arguments.options, Spelling::Options);
  check_inputs({arguments.input});
  context.begin_stage(RunStage::Read);
  const OpenscadMesh made =
      openscad_mesh(arguments.input, {read.defines, read.openscad_timeout, read.csg}, context);
  context.begin_stage(RunStage::Write);
  for (auto& one : outputs) {
    one.first.write([&](std::ostream& out) { one.second->write(made.mesh, out, context); });
  }
  signals::finish();
  for (auto& one : outputs) one.first.commit();
  context.end_stage();
  console.diagnostics(with_spelling(made.diagnostics, Spelling::Options));
}

/// A model is no drawing, whole or broken.
void refuse_model(const std::string& input) {
  const std::string suffix = model_suffix(input);
  if (suffix == ".json" || !is_read_suffix(suffix) || !std::filesystem::exists(input)) return;
  throw InputError(fmt::format("is a model ({}), not a drawing; burin convert takes drawings "
                               "(.json) and OpenSCAD files, burin draw draws models",
                               suffix.substr(1)),
                   input);
}

}  // namespace

void run_convert(const ConvertArguments& arguments, RunContext& context, Console& console) {
  if (arguments.input.empty()) {
    throw UsageError(
        "no input; name a drawing file, or an OpenSCAD file: burin convert DRAWING.json -o OUT");
  }
  if (arguments.outputs.empty()) {
    throw UsageError("no output; name one: burin convert DRAWING.json -o OUT.pdf");
  }
  if (is_openscad_suffix(arguments.input)) return convert_solid(arguments, context, console);
  refuse_model(arguments.input);
  const Style style = make_style(arguments.set);
  const ThreadLimit limit(static_cast<int>(asked(arguments, "threads", std::uint64_t{0})));
  std::vector<Output> outputs =
      make_outputs(arguments.outputs, arguments.format, {arguments.input});
  for (const Output& output : outputs) output.probe();
  context.begin_stage(RunStage::Read);
  const Drawing drawing = read_drawing(arguments.input, context);
  context.end_stage();
  WriteOptions options = write_options(style);
  options.svg.id_prefix =
      id_prefix_option("--id-prefix", asked(arguments, "id_prefix", std::string()));
  const Diagnostics reported = write_outputs(outputs, drawing, options, context);
  console.diagnostics(drawing.diagnostics);
  console.diagnostics(reported);
}

}  // namespace burin::cli
