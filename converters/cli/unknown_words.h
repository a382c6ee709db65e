#pragma once
/// Words of the command line that nobody takes.

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace burin::cli {

/// `--view=` is an option without its value: for the next word CLI11 would take another option.
/// Throws UsageError.
void refuse_empty_values(const CLI::App& app, int argc, const char* const* argv);

/// What to write where a switch has a value, as in "--legend top-left": the style key of its name
/// that takes the word, "write --legend --set callout.legend=top-left"; empty: no key does.
std::string key_instead(const std::string& option, const std::string& word);

/// A word after an option that is no file, and a value of what the option is about: "--legend
/// top-left", "--highlight lid red". CLI11 takes it for a model. Throws UsageError.
void refuse_loose_values(int argc, const char* const* argv);

/// Throws UsageError for the first word that no option or argument took, naming the nearest.
void refuse_extras(const CLI::App& app, const std::string& command);

/// `help` and `help draw` as `--help` and `draw --help`; other words as they are. Throws UsageError
/// where there is no such command.
std::vector<const char*> without_help(const CLI::App& app, int argc, const char* const* argv);

/// A command is missing or unknown: throws UsageError.
[[noreturn]] void refuse_command(const CLI::App& app);

/// Throws UsageError where `word`, the value of an option, is empty: most likely a shell's variable
/// that is not set, which is no reason to draw by the default.
void refuse_empty(const std::string& option, const std::string& word);

}  // namespace burin::cli
