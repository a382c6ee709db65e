#pragma once
/// What was degraded, mended or left out, in words for the user; carried from the reader to the
/// drawing.

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

enum class Severity { Info, Warning, Error };

/// "info", "warning" or "error".
const char* to_string(Severity severity);

/// One entry: a stable dotted code ("mesh.nonmanifold_edges"), how often it occurred, and one
/// sentence.
struct Diagnostic {
  Severity severity = Severity::Warning;
  std::string code;
  std::int64_t count = 1;
  std::string message;
};

/// An ordered list of entries.
class Diagnostics {
 public:
  void add(Diagnostic d) { entries_.push_back(std::move(d)); }
  void add(Severity severity, std::string code, std::int64_t count, std::string message) {
    entries_.push_back({severity, std::move(code), count, std::move(message)});
  }
  void append(const Diagnostics& other) {
    entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  }
  const std::vector<Diagnostic>& entries() const { return entries_; }
  bool empty() const { return entries_.empty(); }

 private:
  std::vector<Diagnostic> entries_;
};

}  // namespace burin
