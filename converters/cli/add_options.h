#pragma once
/// Options as CLI11 takes them, all made alike.

#include <burin/converters/request.h>

#include "arguments.h"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace burin::cli {

/// A paragraph of help in lines of its column.
std::string wrapped(const std::string& text);
std::string format_help();
/// `what`: what is written ("drawing").
std::string output_help(const char* what);

/// An option with one text, the last where it is given several times; an empty one is refused.
CLI::Option* text(CLI::App& app, const char* name, std::string& value, const char* type,
                  const char* group, const std::string& help);
/// An option that may be given several times, one value each time.
void list(CLI::App& app, const char* name, std::vector<std::string>& values, const char* type,
          const char* group, const std::string& help);
/// An option of drawings or of reading, with its letter and its "no-" form.
void add_request(CLI::App& app, const RequestOption& option, Request& request);
/// --quiet, --verbose, --progress, --no-progress.
void add_chatter(CLI::App& app, Chatter& chatter);

}  // namespace burin::cli
