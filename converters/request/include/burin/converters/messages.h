#pragma once
/// What the kernel and the readers say, with the user's choices as the user knows them: they write
/// `bounds` in grave accents, the command says --bounds, the Python module says bounds.

#include <burin/base/diagnostics.h>
#include <burin/options/request.h>

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

namespace burin {

/// The message with each option of `all_options`, and `style_keys`, as the front end spells it.
std::string with_spelling(std::string_view message, Spelling spelling);
Diagnostics with_spelling(const Diagnostics& diagnostics, Spelling spelling);

/// "FILE:LINE: WHAT", without what is not known (an empty name, line 0).
std::string located(const std::string& file, std::int64_t line, const std::string& what);

/// What is to be said of an error: "FILE:LINE: WHAT" with its place, where that is known, and its
/// options as the front end spells them. `input`: the file that is named where the error names
/// none; empty where several were read.
std::string error_message(const std::exception& error, Spelling spelling,
                          const std::string& input = "");

}  // namespace burin
