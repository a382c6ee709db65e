#pragma once
/// What makes no part, and how that is reported.

#include <burin/base/diagnostics.h>
#include <burin/converters/irit_tree.h>

#include <string>
#include <vector>

namespace burin::irit {

class Leftovers {
 public:
  /// Counts the item where it makes no part.
  void add(const IritItem& item, std::int64_t object_line);
  void add_invisible(std::int64_t line);

  void report(Diagnostics& diagnostics) const;
  /// Why the file makes no part at all, and the line of the first thing not read (0: none).
  std::string nothing_else() const;
  std::int64_t first_line() const;

 private:
  struct Kind {
    std::string code;
    std::string what;
    std::int64_t count = 0;
    std::int64_t line = 0;
  };
  void count(const std::string& code, const std::string& what, std::int64_t line);

  std::vector<Kind> kinds_;
};

}  // namespace burin::irit
