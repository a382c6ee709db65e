#pragma once
/// Drawings as text and back.

#include <burin/base/error.h>
#include <burin/converters/read_drawing.h>
#include <burin/converters/write.h>

#include <burin_test/drawings.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace burin::test {

inline std::string written(const Drawing& drawing, std::string_view format,
                           const WriteOptions& options = {}) {
  std::ostringstream out;
  write_drawing(drawing, *format_named(format), options, out, RunContext());
  return out.str();
}

inline Drawing parsed(const std::string& text) {
  return parse_drawing(text, "a.json", RunContext());
}

/// What reading `text` says, with its file and line; "" where it reads.
inline std::string refusal(const std::string& text) {
  try {
    parsed(text);
    return "";
  } catch (const InputError& e) {
    const std::string line = e.line() > 0 ? ":" + std::to_string(e.line()) : "";
    return e.file() + line + ": " + e.what();
  }
}

/// The least that another program may write, with `path` as its one path.
inline std::string least(const std::string& path = R"({"points": [[0, 0], [100, 50]]})") {
  return R"({"format": "burin-drawing", "version": 1,
 "paper": {"width": 200, "height": 150},
 "layers": [{"name": "a", "paths": [)" +
         path + "]}]}";
}

}  // namespace burin::test
