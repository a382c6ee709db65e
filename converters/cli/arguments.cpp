#include "arguments.h"

#include <burin/base/error.h>
#include <burin/converters/read_formats.h>
#include <burin/converters/write.h>
#include <burin/plugin/plugins.h>

#include "about.h"
#include "add_options.h"
#include "command_tree.h"
#include "unknown_words.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <type_traits>

namespace burin::cli {
namespace {

constexpr const char* kLook = "The look";
constexpr const char* kFiles = "Files";
constexpr const char* kParts = "Parts";

/// What can be drawn; those that Burin was built with.
std::string models() {
  return wrapped(
      fmt::format("model files, each one or more parts of the scene: {}; also packed by "
                  "gzip (.stl.gz, .stpz); - is standard input",
                  fmt::join(read_formats(), ", ")));
}

constexpr const char* kOrIllustration = "\nor one illustration file (.burin.json)";

/// `draw` and `watch`: all but the end of their help.
CLI::App* add_drawing(CLI::App& app, const char* name, const char* does, DrawArguments& a,
                      Chatter& chatter) {
  CLI::App* draw = app.add_subcommand(name, does);
  draw->add_option("INPUT", a.inputs, models() + kOrIllustration)->type_name("")->group(kFiles);
  list(*draw, "-o,--output", a.outputs, "FILE", kFiles, output_help("drawing"));
  text(*draw, "--format", a.format, "FORMAT", kFiles, format_help());
  for (const RequestOption& option : all_options()) add_request(*draw, option, a.request.options);
  add_chatter(*draw, chatter);
  return draw;
}

CLI::App* add_draw(CLI::App& app, DrawArguments& a, Chatter& chatter) {
  CLI::App* draw = add_drawing(app, "draw", "draw models as one sheet of line art", a, chatter);
  draw->footer(
      "\nExamples:\n"
      "  burin draw bracket.stl -o bracket.svg\n"
      "  burin draw pump.3mf -o pump.svg -o pump.json --style engraving --view 2,-3,1\n"
      "  burin draw head.nii.gz -o head.svg --iso 60 --smooth 1\n"
      "  burin draw a.obj b.obj -o - --format svg --hidden dashed --set line.outer=1 > both.svg\n\n"
      "Exit status: 0 drawn; 2 usage; 3 bad input; 4 output cannot be written; 5 cancelled; 1 "
      "else.");
  return draw;
}

CLI::App* add_watch(CLI::App& app, DrawArguments& a, Chatter& chatter) {
  CLI::App* watch = add_drawing(
      app, "watch", "draw, and draw again whenever a file that was read changes", a, chatter);
  watch->footer(
      "\nWatched are the models, the style file, the illustration file, and what these name.\n"
      "Ctrl-C ends it.\n\n"
      "Examples:\n"
      "  burin watch pump.burin.json -o pump.svg\n"
      "  burin watch bracket.scad -o bracket.svg --style mine.json\n\n"
      "Exit status: 5 ended by Ctrl-C; else that of burin draw.");
  return watch;
}

CLI::App* add_illustrate(CLI::App& app, DrawArguments& a) {
  CLI::App* illustrate =
      app.add_subcommand("illustrate", "write a first illustration file, to edit and then draw");
  illustrate->add_option("INPUT", a.inputs, models())->type_name("")->group(kFiles);
  list(*illustrate, "-o,--output", a.outputs, "FILE", kFiles,
       "illustration file to write, NAME.burin.json; - is standard\noutput. One that exists stays");
  const std::vector<std::string> runs = {"threads", "verify", "id_prefix", "part"};
  for (const RequestOption& option : all_options()) {
    if (std::ranges::find(runs, option.option.name) == runs.end()) {
      add_request(*illustrate, option, a.request.options);
    }
  }
  illustrate->footer(
      "\nExamples:\n"
      "  burin illustrate pump.step base.stl -o pump.burin.json --style engraving --ghost cover\n"
      "  burin illustrate pump.burin.json --explode auto -o apart.burin.json\n"
      "  burin draw pump.burin.json -o pump.svg");
  return illustrate;
}

CLI::App* add_steps(CLI::App& app, StepsArguments& a, Chatter& chatter) {
  CLI::App* steps =
      app.add_subcommand("steps", "draw how an assembly is put together, a page a step");
  DrawArguments& draw = a.draw;
  draw.command = "steps";
  steps->add_option("INPUT", draw.inputs, models() + kOrIllustration)->type_name("")->group(kFiles);
  list(*steps, "-o,--output", draw.outputs, "FILE", kFiles,
       "step book to write: NAME.pdf, a page a step; NAME.html,\n"
       "one page; NAME.md, and NAME-step-01.svg ... beside it;\nNAME.json, "
       "data; repeatable");
  text(*steps, "--items", a.items, "N", kParts,
       "the most items that a step adds; equal parts are one item\n(default 6)");
  // What is about one drawing.
  const std::vector<std::string> others = {"views",          "projection", "detail",
                                           "break_view",     "parts_list", "legend",
                                           "explode_factor", "center",     "verify"};
  for (const RequestOption& option : all_options()) {
    if (std::ranges::find(others, option.option.name) == others.end()) {
      add_request(*steps, option, draw.request.options);
    }
  }
  add_chatter(*steps, chatter);
  steps->footer(
      "\nExamples:\n"
      "  burin steps pump.step -o pump.pdf -o pump.html --style engraving\n"
      "  burin steps pump.burin.json -o pump.md --callouts\n\n"
      "Exit status: that of burin draw.");
  return steps;
}

CLI::App* add_diff(CLI::App& app, DiffArguments& a, Chatter& chatter) {
  CLI::App* diff = app.add_subcommand(
      "diff", "list and draw what has changed from one revision of a model to the next");
  DrawArguments& draw = a.draw;
  draw.command = "diff";
  diff->add_option("OLD_NEW", draw.inputs,
                   "two revisions: model files as draw takes them, or\nillustration files; or two "
                   "drawing files (.json)")
      ->type_name("")
      ->group(kFiles);
  list(*diff, "-o,--output", draw.outputs, "FILE", kFiles,
       wrapped(fmt::format("what to write: .json is the report for programs, .html a page of "
                           "drawing and table, NAME.drawing.json, {} the drawing of both; "
                           "repeatable; without it the report is printed alone",
                           format_list())));
  text(*diff, "--format", draw.format, "FORMAT", kFiles, format_help());
  text(*diff, "--line-tolerance", a.line_tolerance, "MM", kFiles,
       "for two drawings: lines up to this many paper mm apart are\nthe same (default 0.1)");
  // What is about one model.
  const std::vector<std::string> others = {"explode",    "explode_factor", "callouts",
                                           "parts_list", "legend",         "verify"};
  for (const RequestOption& option : all_options()) {
    if (std::ranges::find(others, option.option.name) == others.end()) {
      add_request(*diff, option, draw.request.options);
    }
  }
  add_chatter(*diff, chatter);
  diff->footer(
      "\nExamples:\n"
      "  burin diff old/pump.step pump.step\n"
      "  burin diff old/pump.step pump.step -o pump-diff.svg -o pump-diff.html --style outline\n"
      "  burin diff was.json is.json -o lines.svg --line-tolerance 0.3\n\n"
      "Exit status: 0 nothing has changed; 6 something has; else that of burin draw.");
  return diff;
}

/// Its words are for another parser.
CLI::App* add_python(CLI::App& app, const char* name, const char* does) {
  CLI::App* command = app.add_subcommand(name, does);
  command->set_help_flag();
  command->prefix_command();
  return command;
}

CLI::App* add_convert(CLI::App& app, ConvertArguments& a, Chatter& chatter) {
  CLI::App* convert = app.add_subcommand(
      "convert", "write a drawing file, or what an OpenSCAD file makes, in other formats");
  text(*convert, "INPUT", a.input, "", kFiles,
       "drawing file (.json) of burin draw or of another program;\nor an OpenSCAD file (.scad, "
       ".csg), whose solid is written\nas .stl, .off or .3mf");
  list(*convert, "-o,--output", a.outputs, "FILE", kFiles, output_help("file"));
  text(*convert, "--format", a.format, "FORMAT", kFiles, format_help());
  for (const char* name : {"define", "csg", "openscad_timeout", "id_prefix"}) {
    const auto& all = all_options();
    const auto same = [&](const RequestOption& o) { return o.option.name == name; };
    const auto found = std::ranges::find_if(all, same);
    // Else Burin was built without what it is about.
    if (found != all.end()) add_request(*convert, *found, a.options);
  }
  list(*convert, "--set", a.set, "KEY=VALUE", kLook,
       "change a key of a format (svg. png. dxf. hpgl. gcode. json.\n"
       "line.dash line.gap); repeatable; see burin styles --keys");
  add_request(*convert, find_option(all_options(), "threads"), a.options);
  add_chatter(*convert, chatter);
  convert->footer(
      "\nExamples:\n"
      "  burin convert pump.json -o pump.pdf -o pump.dxf\n"
      "  burin convert pump.json -o pump.png --set png.dpi=600 --set png.background=transparent\n"
      "  burin convert bracket.scad -o bracket.3mf -D '$fn=96'\n\n"
      "Exit status: that of burin draw.");
  return convert;
}

CLI::App* add_info(CLI::App& app, InfoArguments& a) {
  CLI::App* info =
      app.add_subcommand("info", "list what model files contain and what is wrong with them");
  info->add_option("INPUT", a.inputs, "model files")->type_name("")->group(kFiles);
  for (const RequestOption& option : described(read_option_rows())) {
    // How facets are drawn is nothing that a file holds.
    if (option.group != kLook) add_request(*info, option, a.read);
  }
  info->add_flag("--json", a.json, "print JSON, for programs");
  return info;
}

CLI::App* add_styles(CLI::App& app, StylesArguments& a) {
  CLI::App* styles = app.add_subcommand("styles", "list the built-in styles");
  styles->add_flag("--keys", a.keys, "list all style keys: meaning, range, value");
  text(*styles, "--show", a.show, "NAME", "OPTIONS",
       "print a style as JSON, to be changed and given to --style");
  return styles;
}

CLI::App* add_options(CLI::App& app, OptionsArguments& a) {
  CLI::App* options = app.add_subcommand("options", "list all options and style keys");
  options->add_flag("--json", a.json, "print JSON, for programs");
  options->add_flag("--style-schema", a.style_schema,
                    "print the JSON Schema of style files, for editors");
  options->add_flag("--illustration-schema", a.illustration_schema,
                    "print that of illustration files");
  text(*options, "--manual", a.manual, "COMMAND", "OPTIONS",
       "print the page of a command for man(1); of all of it: burin");
  text(*options, "--completion", a.completion, "SHELL", "OPTIONS",
       "print what completes words in bash, zsh or fish");
  return options;
}

/// What is wrong with the value of a switch: CLI11 converts no others.
std::string of_switch(const CLI::ConversionError& e) {
  const std::string_view what = e.what(), start = "Could not convert: ", between = " = ";
  const std::size_t at = what.find(between);
  if (!what.starts_with(start) || at == what.npos)
    return fmt::format("{} (see burin --help)", what);
  const std::string option = fmt::format("option {}", what.substr(start.size(), at - start.size()));
  const std::vector<RequestOption>& all = all_options();
  const auto known = std::ranges::find_if(all, [&](const RequestOption& one) {
    return called(one.option.name, Spelling::Options) == option;
  });
  const std::string word(what.substr(at + between.size()));
  const std::string key =
      known == all.end() ? "" : key_instead(spelled(known->option.name, Spelling::Options), word);
  if (!key.empty()) return fmt::format("{} takes no value, not '{}': {}", option, word, key);
  return fmt::format("{} takes no value, not '{}' ({})", option, word,
                     known == all.end() ? "see burin --help" : "it is to " + known->option.meaning);
}

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv) {
  Arguments a;
  CLI::App app(
      "Burin turns models into engraved line art: hidden lines removed, tone carried by strokes.",
      "burin");
  app.get_formatter()->column_width(28);
  app.set_help_flag("-h,--help", "print this help");
  app.footer(
      "\nburin help COMMAND lists the options of a command.\n"
      "Example: burin draw bracket.stl -o bracket.svg --style engraving");
  app.set_version_flag("--version,-V", version_text(), "print the version");
  CLI::App* draw = add_draw(app, a.draw, a.chatter);
  CLI::App* watch = add_watch(app, a.draw, a.chatter);
  CLI::App* illustrate = add_illustrate(app, a.illustrate);
  CLI::App* steps = add_steps(app, a.steps, a.chatter);
  CLI::App* diff = add_diff(app, a.diff, a.chatter);
  CLI::App* batch = add_python(
      app, "batch", "draw a catalogue of parts: plan, run, report, prune (see burin batch --help)");
  CLI::App* book = add_python(
      app, "book", "make the figures of a manual, or compare them (see burin book --help)");
  CLI::App* convert = add_convert(app, a.convert, a.chatter);
  CLI::App* info = add_info(app, a.info);
  CLI::App* styles = add_styles(app, a.styles);
  CLI::App* options = add_options(app, a.options);
  CLI::App* plugins = app.add_subcommand(
      "plugins", "try all plug-ins again and list what they offer, or why they were refused");
  if (!plugin::are_loaded()) plugins->group("");  // no line of help
  plugins->add_flag("--json", a.plugins.json, "print JSON, for programs");
  app.allow_extras();
  for (CLI::App* sub :
       {draw, watch, illustrate, steps, diff, convert, info, styles, options, plugins})
    sub->allow_extras();

  const std::vector<const char*> words = without_help(app, argc, argv);
  argc = static_cast<int>(words.size());
  argv = words.data();
  const bool python = argc > 1 && (argv[1] == batch->get_name() || argv[1] == book->get_name());
  if (!python) refuse_empty_values(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    a.help = app.help();
    return a;
  } catch (const CLI::CallForVersion& e) {
    a.help = e.what();
    return a;
  } catch (const CLI::ConversionError& e) {
    throw UsageError(of_switch(e));
  } catch (const CLI::ParseError& e) {
    const std::vector<CLI::App*> begun = app.get_subcommands();
    throw UsageError(fmt::format("{} (see burin {}--help)", e.what(),
                                 begun.empty() ? "" : begun.front()->get_name() + " "));
  }

  if (app.get_subcommands().empty()) refuse_command(app);
  if (app.get_subcommands().size() > 1)
    throw UsageError("one command at a time (see burin --help)");
  const CLI::App* chosen = app.get_subcommands().front();
  if (chosen == batch || chosen == book) {
    a.verb = chosen == batch ? Verb::Batch : Verb::Book;
    a.words.assign(argv + 2, argv + argc);
    return a;
  }
  refuse_extras(*chosen, "burin " + chosen->get_name());
  refuse_loose_values(argc, argv);
  refuse_extras(app, "burin");
  if (chosen == watch) a.draw.command = "watch";
  if (!a.options.manual.empty() || !a.options.completion.empty()) {
    const std::vector<Command> tree = command_tree(app);
    a.help = a.options.manual.empty() ? completion(tree, a.options.completion)
                                      : manual_page(tree, a.options.manual);
    return a;
  }
  a.verb = chosen == draw         ? Verb::Draw
           : chosen == watch      ? Verb::Watch
           : chosen == illustrate ? Verb::Illustrate
           : chosen == steps      ? Verb::Steps
           : chosen == diff       ? Verb::Diff
           : chosen == convert    ? Verb::Convert
           : chosen == info       ? Verb::Info
           : chosen == styles     ? Verb::Styles
           : chosen == options    ? Verb::Options
                                  : Verb::Plugins;
  return a;
}

}  // namespace burin::cli
