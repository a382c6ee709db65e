#pragma once
/// Where the members of a JSON file stand, so that errors name the line.

#include <burin/base/error.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace burin {

/// The line of every member and element of a JSON text, comments allowed; nothing where it is no
/// JSON.
class JsonLines {
 public:
  explicit JsonLines(std::string_view text);

  /// From 1, by a path such as "/parts/0/file": its own, else that of what holds it.
  std::int64_t line(std::string_view path) const;
  /// The line where reading ended: the last, or that of what could not be read.
  std::int64_t last() const { return last_; }
  /// The first key that an object has twice, and the line of the second.
  const std::optional<std::pair<std::string, std::int64_t>>& repeated() const { return repeated_; }

 private:
  std::int64_t last_ = 1;
  std::optional<std::pair<std::string, std::int64_t>> repeated_;
  std::map<std::string, std::int64_t, std::less<>> lines_;
};

/// The line of a place in a text, from 1.
std::int64_t line_at(std::string_view text, std::size_t position);

/// Throws InputError where a text is in UTF-16, as shells of Windows write what is sent to a file.
void check_no_utf16(std::string_view text, const std::string& source);

/// The object that a JSON file of the user's holds, comments allowed; `Json` is nlohmann's. `what`:
/// "style file"; `begins` says what it is, where it is something else. Throws InputError that names
/// `source` and the line.
template <class Json>
Json parse_json_object(std::string_view text, const std::string& source, const std::string& what,
                       const std::string& begins) {
  check_no_utf16(text, source);
  try {
    Json json = Json::parse(text, nullptr, true, true);
    if (json.is_object()) return json;
  } catch (const typename Json::parse_error& e) {
    throw InputError("not valid JSON here; mend the " + what, source,
                     line_at(text, e.byte > 0 ? e.byte - 1 : 0));
  } catch (const typename Json::out_of_range&) {
    throw InputError("a number is too large here; mend the " + what, source,
                     JsonLines(text).last());
  }
  throw InputError(begins, source, 1);
}

}  // namespace burin
