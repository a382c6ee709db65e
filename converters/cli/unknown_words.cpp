#include "unknown_words.h"

#include <burin/base/error.h>
#include <burin/converters/request.h>
#include <burin/converters/unknown.h>
#include <burin/drawing/color.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace burin::cli {
namespace {

std::vector<std::string> known_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

struct Names {
  std::string name;
  std::vector<std::string> also;
};

/// What options of the command alone are called elsewhere.
const std::vector<Names>& own_options() {
  static const std::vector<Names> rows = {
      {"--output",
       {"out", "outfile", "output file", "save", "save as", "export", "target", "dest",
        "destination", "svg", "pdf", "png", "eps", "dxf", "html", "hpgl", "gcode"}},
      {"--format", {"output format", "type", "filetype", "file type", "to", "suffix", "ext"}},
      {"--quiet", {"silent", "no warnings", "no output", "suppress warnings"}},
      {"--verbose", {"debug", "log", "trace", "timing", "timings", "log level", "loglevel"}},
      {"--progress", {"progress bar", "bar"}},
      {"--help", {"usage", "man", "manual", "examples", "help all", "h", "?"}},
      {"--version", {"build", "about", "info"}},
      {"--keys", {"list keys", "all", "list"}},
      {"--show", {"print", "dump"}},
  };
  return rows;
}

const std::vector<Names>& commands() {
  static const std::vector<Names> rows = {
      {"draw",
       {"render", "plot", "export", "make", "svg", "pdf", "png", "hlr", "run", "print", "picture",
        "image", "line", "lineart"}},
      {"watch", {"preview", "live", "view", "serve", "gui", "monitor"}},
      {"illustrate", {"init", "new", "create", "project"}},
      {"steps", {"assembly", "instructions", "build", "assemble", "explode"}},
      {"diff", {"compare", "changes", "delta"}},
      {"batch", {"all", "many", "catalogue", "catalog"}},
      {"convert", {"translate", "save", "transform", "to"}},
      {"info",
       {"inspect", "show", "list", "stat", "stats", "measure", "parts", "tree", "check",
        "describe"}},
      {"styles", {"themes", "theme", "presets", "keys"}},
      {"options", {"settings", "schema", "config", "params", "parameters"}},
      {"plugins", {"extensions", "addons", "modules"}},
  };
  return rows;
}

std::vector<std::string> other_names(const std::vector<Names>& rows, const std::string& name) {
  const auto row = std::ranges::find(rows, name, &Names::name);
  return row == rows.end() ? std::vector<std::string>() : row->also;
}

/// Options of a command by all their names.
std::vector<KnownWord> known_options_of(const CLI::App& app) {
  const std::vector<KnownWord> requests = known_options(all_options(), Spelling::Options);
  std::vector<KnownWord> known;
  for (const std::string& name : known_names(app)) {
    KnownWord word{name, other_names(own_options(), name), "the nearest is " + name};
    const auto request = std::ranges::find(requests, name, &KnownWord::name);
    if (request != requests.end()) word.also = request->also;
    known.push_back(std::move(word));
  }
  return known;
}

/// What is said of an option that a command has not.
std::string hint_for(const CLI::App& app, const std::string& name) {
  std::vector<KnownWord> known = known_options_of(app);
  const bool draws = std::ranges::find(known, "--view", &KnownWord::name) != known.end();
  for (KnownWord& of_draw : known_options(all_options(), Spelling::Options)) {
    if (std::ranges::find(known, of_draw.name, &KnownWord::name) != known.end()) continue;
    of_draw.say = fmt::format("{} is an option of burin draw", of_draw.name);
    known.push_back(std::move(of_draw));
  }
  return draws ? hint_for_option(name, std::move(known), Spelling::Options) : hint(name, known);
}

std::string names_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    if (!sub->get_group().empty()) names.push_back(sub->get_name());
  }
  return fmt::format("; the commands are {}", fmt::join(names, ", "));
}

bool is_command(const CLI::App& app, const std::string& word) {
  const auto named = [&](const CLI::App* sub) { return sub->get_name() == word; };
  return std::ranges::any_of(app.get_subcommands({}), named);
}

[[noreturn]] void refuse_unknown(const CLI::App& app, const std::string& word) {
  std::vector<KnownWord> known{{"help", {"usage", "man", "manual", "examples"}}};
  for (const CLI::App* sub : app.get_subcommands({})) {
    known.push_back({sub->get_name(), other_names(commands(), sub->get_name())});
  }
  known.push_back({"parts list",
                   {"bom", "bill of materials", "partlist", "stueckliste"},
                   "to make a parts list: burin draw INPUT... -o OUT --parts-list FILE.csv"});
  const std::string near = hint(word, known);
  throw UsageError(fmt::format("unknown command '{}'{} (see burin --help)", word,
                               near.empty() ? names_below(app) : near));
}

bool is_file_name(const std::string& word) {
  std::error_code error;
  return std::filesystem::is_regular_file(word, error) ||
         std::filesystem::path(word).has_extension();
}

}  // namespace

void refuse_empty(const std::string& option, const std::string& word) {
  if (word.empty()) throw UsageError("option " + option + " has an empty value");
}

void refuse_empty_values(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    const std::vector<std::string> more = known_names(*sub);
    names.insert(names.end(), more.begin(), more.end());
  }
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") return;  // names of files follow
    if (!word.starts_with('-') || word.find('=') != word.size() - 1) continue;
    const std::string name = word.substr(0, word.size() - 1);
    if (std::ranges::find(names, name) != names.end()) refuse_empty(name, "");
  }
}

std::string key_instead(const std::string& option, const std::string& word) {
  const std::vector<RequestOption>& all = all_options();
  const auto request = std::ranges::find_if(all, [&](const RequestOption& one) {
    return spelled(one.option.name, Spelling::Options) == option &&
           std::holds_alternative<Switch>(one.option.takes);
  });
  if (request == all.end()) return {};
  for (const StyleKey& key : style_keys(builtin_style("technical"))) {
    const auto* list = std::get_if<WordList>(&key.takes);
    if (!list || !key.name.ends_with("." + request->option.name)) continue;
    if (std::ranges::find(list->words, word) == list->words.end()) continue;
    return fmt::format("write {} --set {}={}", option, key.name, word);
  }
  return {};
}

void refuse_loose_values(int argc, const char* const* argv) {
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i], before = argv[i - 1];
    if (word == "--") return;  // names of files follow
    std::error_code error;     // of names that are too long for a file
    if (word.starts_with('-') || std::filesystem::exists(word, error)) continue;
    if (const std::string key = key_instead(before, word); !key.empty()) {
      throw UsageError(fmt::format("option {} takes no value, not '{}': {}", before, word, key));
    }
    const std::string highlight = "--highlight";
    const bool in_two = argv[i - 2] == highlight, in_one = before.starts_with(highlight + "=");
    if ((!in_one && !in_two) || !rgb_of(without_name(word))) continue;
    throw UsageError(
        fmt::format("'{0}' is no model: a colour belongs to the value of {1}, as {1} '{2}={0}'",
                    word, highlight, in_two ? before : before.substr(highlight.size() + 1)));
  }
}

void refuse_extras(const CLI::App& app, const std::string& command) {
  for (const std::string& word : app.remaining()) {
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with('-')) {
      std::string near = hint_for(app, name);
      if (near.empty() && app.get_subcommands().empty() && !app.get_subcommands({}).empty()) {
        near = names_below(app);
      }
      throw UsageError(fmt::format("unknown option {}{} (see {} --help)", name, near, command));
    }
    throw UsageError(fmt::format("unexpected argument '{}' (see {} --help)", word, command));
  }
}

void refuse_command(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) {
    throw UsageError(
        "no command; name one, e.g. burin draw part.stl -o part.svg (see burin --help)");
  }
  const std::string& word = words.front();
  if (word.starts_with('-') && words.size() == 1) refuse_extras(app, "burin");
  if (word.starts_with('-') || is_file_name(word)) {
    throw UsageError(
        fmt::format("no command before '{}'; to draw: burin draw {} (see burin --help)", word,
                    fmt::join(words, " ")));
  }
  refuse_unknown(app, word);
}

std::vector<const char*> without_help(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc < 2 || std::string_view(argv[1]) != "help") return words;
  words.erase(words.begin() + 1);
  const std::string topic = argc > 2 ? argv[2] : "help";
  if (topic.starts_with('-')) return words;
  if (topic != "help" && !is_command(app, topic)) refuse_unknown(app, topic);
  words.insert(words.begin() + (topic == "help" ? 1 : 2), "--help");
  if (topic == "help") words.resize(2);
  return words;
}

}  // namespace burin::cli
