#include "unknown_words.h"

#include <burin/base/error.h>
#include <burin/base/nearest.h>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace burin::cli {
namespace {

std::vector<std::string> known_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

}  // namespace

void refuse_empty(const std::string& option, const std::string& word) {
  if (word.empty()) throw UsageError("option " + option + " has an empty value");
}

void refuse_empty_values(const CLI::App& app, int argc, const char* const* argv) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    const std::vector<std::string> more = known_options(*sub);
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

}  // namespace burin::cli
