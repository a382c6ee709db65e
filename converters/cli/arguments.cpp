#include "arguments.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>
#include <burin/base/version.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace burin::cli {
namespace {

constexpr const char* kSheet = "The sheet and the view";
constexpr const char* kLook = "The look";
constexpr const char* kRun = "The run";
constexpr const char* kReading = "Functions and volumes";
constexpr const char* kFiles = "Files";
constexpr const char* kFormatHelp =
    "svg, pdf, eps, png, dxf or json: format of outputs whose\n"
    "name does not tell it";
constexpr const char* kPrefixHelp =
    "what all ids of an SVG begin with, so that several stand in\n"
    "one page";
constexpr const char* kThreadsHelp =
    "worker threads (default: all); the drawing is the same for any number";

CLI::Option* text(CLI::App& app, const char* name, std::string& value, const char* type,
                  const char* group, const char* help) {
  return app.add_option(name, value, help)
      ->each([option = std::string(name)](const std::string& word) {
        // Most likely a shell's variable that is not set: no reason to draw by the default.
        if (word.empty()) throw UsageError("option " + option + " has an empty value");
      })
      ->type_name(type)
      ->group(group)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// An option that may be given several times, one value each time.
void list(CLI::App& app, const char* name, std::vector<std::string>& values, const char* type,
          const char* group, const char* help) {
  app.add_option(name, values, help)->type_name(type)->group(group)->allow_extra_args(false);
}

/// What files do not say of themselves.
void add_reading(CLI::App& app, ReadRequest& read, const char* group) {
  text(app, "--bounds", read.bounds, "X0,..,Z1", group,
       "domain x0,y0,z0,x1,y1,z1 of functions and volumes, in\n"
       "model mm (default: their own bounds)");
  text(app, "--mesher", read.mesher, "auto|nets|delaunay", group,
       "triangles of functions: even and fast, or graded by\n"
       "curvature (default auto); lines are exact with either");
  text(app, "--iso", read.iso, "LEVEL", group,
       "the surface of a volume is where its data takes this\n"
       "value; burin info tells the range (no default; trivariate\n"
       "splines: 0)");
  text(app, "--inside", read.inside, "above|below", group,
       "values that are inside (default above; trivariate splines:\n"
       "below)");
  text(app, "--smooth", read.smooth, "SAMPLES", group,
       "standard deviation of a Gaussian that a volume is\n"
       "smoothed with (default 0)");
  text(app, "--specks", read.specks, "SHARE", group,
       "components of a volume smaller than this share of the\n"
       "largest one are left out (default 0.02)");
  text(app, "--volume-degree", read.volume_degree, "2|3", group,
       "degree of the spline of a volume (default 3)");
  app.add_flag_callback(
         "--interpolate", [&read] { read.interpolate = "true"; },
         "take the values of the samples exactly; without it they\n"
         "are the spline's coefficients, a little smoother")
      ->group(group);
  text(app, "--raw", read.raw, "NXxNYxNZ[..]", group,
       "what a raw file holds: NXxNYxNZ[:TYPE[:DX,DY,DZ]], TYPE\n"
       "u8 i8 u16 .. f64, u16be .. for big-endian (default u8:1,1,1)");
  text(app, "--raw-skip", read.raw_skip, "BYTES", group,
       "bytes before the first sample of a raw file (default 0)");
}

void add_chatter(CLI::App& app, Chatter& chatter) {
  app.add_flag("--quiet,-q", chatter.quiet, "print nothing but errors")->group(kRun);
  app.add_flag("--verbose,-v", chatter.verbose, "print the time of each stage")->group(kRun);
  app.add_flag("--progress", chatter.progress,
               "show progress (default on a terminal); elsewhere than on a\n"
               "terminal one line a step: burin: progress STAGE SHARE")
      ->group(kRun);
  app.add_flag("--no-progress", chatter.no_progress, "show none")->group(kRun);
}

void add_openscad(CLI::App& app, ReadRequest& a) {
  list(app, "-D,--define", a.define, "NAME=VALUE", kFiles,
       "define a variable of OpenSCAD files; repeatable; a text\n"
       "keeps its quotes: -D 'label=\"A\"'");
  text(app, "--openscad-timeout", a.openscad_timeout, "SECONDS", kFiles,
       "end OpenSCAD after so long (default 300)");
}

void add_freecad(CLI::App& app, ReadRequest& a) {
  list(app, "--object", a.object, "NAME|LABEL", kFiles,
       "draw this object of FreeCAD documents, hidden or not;\n"
       "repeatable (default: all that are visible)");
  app.add_flag_callback(
         "--recompute", [&a] { a.recompute = "true"; },
         "let FreeCAD recompute the document first (the file stays\n"
         "as it is)")
      ->group(kFiles);
  text(app, "--freecad-timeout", a.freecad_timeout, "SECONDS", kFiles,
       "end FreeCAD after so long (default 300)");
}

CLI::App* add_draw(CLI::App& app, DrawArguments& a, Chatter& chatter) {
  CLI::App* draw = app.add_subcommand("draw", "draw models as one sheet of line art");
  draw->add_option("INPUT", a.inputs,
                   "model files, each one or more parts of the scene:\nSTEP, IGES, BREP, STL, OBJ, "
                   "OFF, PLY, 3MF,\n"
                   "IRIT (.itd, .irt), Geomview patches (.bez, .bbp),\n"
                   "functions (.implicit), volumes (.nrrd .nhdr .mha .mhd\n"
                   ".inr .nii .nii.gz .vti, .raw with --raw),\n"
                   "OpenSCAD (.scad, .csg), FreeCAD (.FCStd)")
      ->type_name("")
      ->group(kFiles);
  list(*draw, "-o,--output", a.outputs, "FILE", kFiles,
       "drawing to write, .svg .pdf .eps .png .dxf or .json by its\n"
       "suffix; repeatable; - is standard output and needs --format");
  text(*draw, "--format", a.format, "FORMAT", kFiles, kFormatHelp);
  text(*draw, "--id-prefix", a.id_prefix, "TEXT", kFiles, kPrefixHelp);
  add_openscad(*draw, a.read);
  add_freecad(*draw, a.read);
  draw->add_flag_callback(
          "--heal", [&a] { a.read.heal = "true"; },
          "draw facets of meshes as the round surfaces that they\n"
          "stand for (default for OpenSCAD files)")
      ->group(kLook);
  draw->add_flag_callback(
          "--no-heal", [&a] { a.read.heal = "false"; }, "draw facets as they are")
      ->group(kLook);
  text(*draw, "--view", a.view, "NAME|X,Y,Z", kSheet,
       "front back left right top bottom iso dimetric trimetric,\n"
       "or the direction from the model to the viewer (default iso)");
  text(*draw, "--up", a.up, "X,Y,Z", kSheet,
       "up on the sheet (default 0,0,1; for top and bottom 0,1,0)");
  text(*draw, "--perspective", a.perspective, "DEG", kSheet,
       "vertical field of view in degrees (default: orthographic)");
  text(*draw, "--paper", a.paper, "NAME|WxH", kSheet,
       "A0..A6, B0..B6, letter, legal, tabloid (A4p is portrait),\n"
       "mm, say 200x150, or fit: the drawing and its margin, at\n"
       "--scale or 1 (default A4)");
  text(*draw, "--scale", a.scale, "S|A:B", kSheet,
       "paper mm for a model mm, also as 1:2 (default: fit to the\nsheet)");
  text(*draw, "--center", a.center, "X,Y,Z", kSheet,
       "the model point in the middle of the sheet\n(default: the middle of the drawing)");
  text(*draw, "--margin", a.margin, "MM|T,R,B,L", kSheet,
       "empty border of a fitted sheet; one number, or top, right,\n"
       "bottom, left (default 10)");
  text(*draw, "--style", a.style, "NAME|FILE", kLook,
       "outline, technical, engraving, haloed, wireframe, or a style\n"
       "file (default technical)");
  list(*draw, "--set", a.set, "KEY=VALUE", kLook,
       "change one key of the style; repeatable; see burin styles --keys");
  text(*draw, "--light", a.light, "X,Y,Z", kLook,
       "direction to the light: right, up, towards the viewer\n"
       "(default: upper left front)");
  text(*draw, "--hidden", a.hidden, "none|dashed", kLook,
       "leave hidden lines out or draw them dashed (default none)");
  text(*draw, "--tolerance", a.tolerance, "MM", kLook,
       "chord tolerance of any tessellation, in model mm\n"
       "(default: less than 0.05 mm on the sheet)");
  add_reading(*draw, a.read, kReading);
  text(*draw, "--seed", a.seed, "N", kRun, "random seed (default 1)");
  text(*draw, "--threads", a.threads, "N", kRun, kThreadsHelp);
  draw->add_flag_callback(
          "--verify", [&a] { a.verify = "true"; },
          "test every visible and hidden line of the drawing by rays\n"
          "against a finer tessellation of its own; say what they\n"
          "contradict, where, and how much in all")
      ->group(kRun);
  add_chatter(*draw, chatter);
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

CLI::App* add_convert(CLI::App& app, ConvertArguments& a, Chatter& chatter) {
  CLI::App* convert = app.add_subcommand("convert", "write a drawing file in other formats");
  text(*convert, "DRAWING", a.input, "", kFiles,
       "drawing file (.json) of burin draw or of another program");
  list(*convert, "-o,--output", a.outputs, "FILE", kFiles,
       "file to write, .svg .pdf .eps .png .dxf or .json by its\n"
       "suffix; repeatable; - is standard output and needs --format");
  text(*convert, "--format", a.format, "FORMAT", kFiles, kFormatHelp);
  text(*convert, "--id-prefix", a.id_prefix, "TEXT", kFiles, kPrefixHelp);
  list(*convert, "--set", a.set, "KEY=VALUE", kLook,
       "change a key of a format (svg. png. dxf. json. line.dash\n"
       "line.gap); repeatable; see burin styles --keys");
  text(*convert, "--threads", a.threads, "N", kRun, kThreadsHelp);
  add_chatter(*convert, chatter);
  convert->footer(
      "\nExamples:\n"
      "  burin convert pump.json -o pump.pdf -o pump.dxf\n"
      "  burin convert pump.json -o pump.png --set png.dpi=600 --set png.background=transparent\n\n"
      "Exit status: that of burin draw.");
  return convert;
}

CLI::App* add_info(CLI::App& app, InfoArguments& a) {
  CLI::App* info =
      app.add_subcommand("info", "tell what model files hold, and what is wrong with them");
  info->add_option("INPUT", a.inputs, "model files")->type_name("")->group(kFiles);
  add_reading(*info, a.read, kReading);
  add_openscad(*info, a.read);
  add_freecad(*info, a.read);
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

std::vector<std::string> known_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// Throws for the first word that no option or argument took.
void refuse_extras(const CLI::App& app, const std::string& command) {
  for (const std::string& word : app.remaining()) {
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with('-')) {
      throw UsageError(fmt::format("unknown option {}; the nearest is {} (see {} --help)", name,
                                   nearest(name, known_options(app)), command));
    }
    throw UsageError(fmt::format("unexpected argument '{}' (see {} --help)", word, command));
  }
}

/// A command is missing or unknown.
void refuse_command(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) {
    throw UsageError(
        "no command; say what to do, e.g. burin draw part.stl -o part.svg (see burin --help)");
  }
  if (words.front().starts_with('-')) refuse_extras(app, "burin");
  throw UsageError(fmt::format("unknown command '{}'; the nearest is '{}' (see burin --help)",
                               words.front(), nearest(words.front(), names)));
}

std::string one_line(std::string message) {
  for (char& c : message) {
    if (c == '\n') c = ' ';
  }
  return message;
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
      "\nburin COMMAND --help tells the options of a command.\n"
      "Example: burin draw bracket.stl -o bracket.svg --style engraving");
  app.set_version_flag("--version,-V", std::string("burin ") + version(), "print the version");
  CLI::App* draw = add_draw(app, a.draw, a.chatter);
  CLI::App* convert = add_convert(app, a.convert, a.chatter);
  CLI::App* info = add_info(app, a.info);
  CLI::App* styles = add_styles(app, a.styles);
  CLI::App* plugins = app.add_subcommand(
      "plugins", "list the plug-ins that are loaded: none, this version cannot load any");
  app.allow_extras();
  for (CLI::App* sub : {draw, convert, info, styles, plugins}) sub->allow_extras();

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    a.help = app.help();
    return a;
  } catch (const CLI::CallForVersion& e) {
    a.help = std::string(e.what()) + "\n";
    return a;
  } catch (const CLI::ParseError& e) {
    throw UsageError(one_line(e.what()) + " (see burin --help)");
  }

  if (app.get_subcommands().empty()) refuse_command(app);
  if (app.get_subcommands().size() > 1)
    throw UsageError("one command at a time (see burin --help)");
  const CLI::App* chosen = app.get_subcommands().front();
  refuse_extras(*chosen, "burin " + chosen->get_name());
  refuse_extras(app, "burin");
  a.verb = chosen == draw      ? Verb::Draw
           : chosen == convert ? Verb::Convert
           : chosen == info    ? Verb::Info
           : chosen == styles  ? Verb::Styles
                               : Verb::Plugins;
  return a;
}

}  // namespace burin::cli
