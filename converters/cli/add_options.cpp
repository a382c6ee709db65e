#include "add_options.h"

#include <burin/base/error.h>
#include <burin/converters/write.h>

#include "unknown_words.h"

#include <CLI/App.hpp>
#include <fmt/format.h>

#include <sstream>
#include <type_traits>

namespace burin::cli {
namespace {

constexpr const char* kRun = "The run";

/// Lines of help are this long, beside the column of the names.
constexpr std::size_t kHelpWidth = 60;

/// A switch, and the form that turns it off where there is one.
void add_switch(CLI::App& app, const RequestOption& option, Request& request) {
  const std::string& name = option.option.name;
  const auto add = [&](const std::string& flag, const std::string& help, const char* value) {
    app.add_flag_callback(
           spelled(flag, Spelling::Options), [&request, name, value] { request[name] = {value}; },
           wrapped(help))
        ->group(option.group);
  };
  add(name, option.option.meaning, "true");
  if (!option.negated.empty()) add("no_" + name, option.negated, "false");
}

}  // namespace

std::string wrapped(const std::string& text) {
  std::string out;
  std::size_t used = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = used + 1 + word.size() <= kHelpWidth;
    if (used > 0) out += fits ? ' ' : '\n';
    used = fits && used > 0 ? used + 1 + word.size() : word.size();
    out += word;
  }
  return out;
}

std::string format_help() {
  return wrapped(fmt::format("{}: format of outputs without a known suffix", format_list("")));
}

std::string output_help(const char* what) {
  return wrapped(
      fmt::format("{} to write, {} by its suffix; repeatable; - is standard output and "
                  "needs --format",
                  what, format_list()));
}

CLI::Option* text(CLI::App& app, const char* name, std::string& value, const char* type,
                  const char* group, const std::string& help) {
  return app.add_option(name, value, help)
      ->each([option = std::string(name)](const std::string& word) { refuse_empty(option, word); })
      ->type_name(type)
      ->group(group)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void list(CLI::App& app, const char* name, std::vector<std::string>& values, const char* type,
          const char* group, const std::string& help) {
  app.add_option(name, values, help)->type_name(type)->group(group)->allow_extra_args(false);
}

void add_request(CLI::App& app, const RequestOption& option, Request& request) {
  if (std::holds_alternative<Switch>(option.option.takes)) return add_switch(app, option, request);
  const std::string& name = option.option.name;
  const std::string word = spelled(name, Spelling::Options);
  const std::string names = option.letter == 0 ? word : fmt::format("-{},{}", option.letter, word);
  const auto add = [&]<class Values>(CLI::MultiOptionPolicy policy) {
    const auto set = [&request, name, word](const Values& values) {
      if constexpr (std::is_same_v<Values, std::string>) {
        refuse_empty(word, values);
        request[name] = {values};
      } else {
        for (const std::string& value : values) refuse_empty(word, value);
        request[name] = values;
      }
    };
    app.add_option_function<Values>(names, set, wrapped(option.option.meaning))
        ->type_name(option.label)
        ->group(option.group)
        ->allow_extra_args(false)
        ->multi_option_policy(policy);
  };
  if (option.many) {
    add.template operator()<std::vector<std::string>>(CLI::MultiOptionPolicy::TakeAll);
  } else {
    add.template operator()<std::string>(CLI::MultiOptionPolicy::TakeLast);
  }
}

void add_chatter(CLI::App& app, Chatter& chatter) {
  app.add_flag("--quiet,-q", chatter.quiet, "print nothing but errors")->group(kRun);
  app.add_flag("--verbose,-v", chatter.verbose, "print the time of each stage")->group(kRun);
  app.add_flag("--progress", chatter.progress,
               "show progress (default on a terminal); if the output is no\n"
               "terminal, one line a step: burin: progress STAGE SHARE\n"
               "[WORDS]")
      ->group(kRun);
  app.add_flag("--no-progress", chatter.no_progress, "show none")->group(kRun);
}

}  // namespace burin::cli
