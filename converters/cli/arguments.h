#pragma once
/// What was asked on the command line.

#include <burin/converters/request.h>

#include <string>
#include <vector>

namespace burin::cli {

/// Options as they were typed; `make_plan` turns them into values, so that each error names its
/// option.
struct DrawArguments {
  DrawRequest request;
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::string format;
  /// How the command is called, for messages.
  std::string command = "draw";
};

struct StepsArguments {
  /// `outputs` are books; `format` is empty.
  DrawArguments draw;
  /// New items a step at the most, as it was typed.
  std::string items;
};

struct DiffArguments {
  /// `inputs` are the old revision and the new one.
  DrawArguments draw;
  /// Paper mm, as it was typed.
  std::string line_tolerance;
};

struct ConvertArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string format;
  std::vector<std::string> set;
  /// The others: "threads", "id_prefix".
  Request options;
};

struct StylesArguments {
  bool keys = false;
  std::string show;
};

struct OptionsArguments {
  bool json = false;
  bool style_schema = false;
  bool illustration_schema = false;
  /// A command, and a shell; empty: not asked.
  std::string manual, completion;
};

struct PluginsArguments {
  bool json = false;
};

struct InfoArguments {
  std::vector<std::string> inputs;
  Request read;
  bool json = false;
};

/// What a run says of itself on standard error.
struct Chatter {
  bool quiet = false;
  bool verbose = false;
  /// Neither: a bar where standard error is a terminal.
  bool progress = false;
  bool no_progress = false;
};

enum class Verb {
  Help,
  Draw,
  Watch,
  Illustrate,
  Steps,
  Diff,
  Batch,
  Book,
  Convert,
  Info,
  Styles,
  Options,
  Plugins
};

struct Arguments {
  Verb verb = Verb::Help;
  /// Help: the whole text to print.
  std::string help;
  /// `draw`: of `burin watch` too.
  DrawArguments draw, illustrate;
  StepsArguments steps;
  DiffArguments diff;
  ConvertArguments convert;
  StylesArguments styles;
  InfoArguments info;
  OptionsArguments options;
  PluginsArguments plugins;
  /// What follows the name of a command that is written in Python and has a parser of its own.
  std::vector<std::string> words;
  Chatter chatter;
};

/// Reads the command line. Throws UsageError, naming the nearest option or command where one is
/// unknown.
Arguments parse_arguments(int argc, const char* const* argv);

}  // namespace burin::cli
