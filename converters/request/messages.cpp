#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>

#include <fmt/format.h>

namespace burin {

std::string with_spelling(std::string_view message, Spelling spelling) {
  std::string out = spelled_message(message, all_options(), spelling);
  // No option of a drawing: what lists the keys.
  constexpr std::string_view kKeys = "`style_keys`";
  const std::size_t at = out.find(kKeys);
  if (at != out.npos) {
    out.replace(at, kKeys.size(),
                spelling == Spelling::Options ? "burin styles --keys" : "burin.style_keys()");
  }
  return out;
}

std::string located(const std::string& file, std::int64_t line, const std::string& what) {
  if (file.empty()) return what;
  if (file == "-") return located("standard input", line, what);
  return line > 0 ? fmt::format("{}:{}: {}", file, line, what) : fmt::format("{}: {}", file, what);
}

std::string error_message(const std::exception& error, Spelling spelling,
                          const std::string& input) {
  const std::string what = with_spelling(error.what(), spelling);
  if (const auto* bad = dynamic_cast<const InputError*>(&error)) {
    return located(bad->file().empty() ? input : bad->file(), bad->line(), what);
  }
  if (const auto* bad = dynamic_cast<const OutputError*>(&error)) {
    return located(bad->file(), 0, what);
  }
  return dynamic_cast<const UsageError*>(&error) ? what : located(input, 0, what);
}

Diagnostics with_spelling(const Diagnostics& diagnostics, Spelling spelling) {
  Diagnostics out;
  for (const Diagnostic& d : diagnostics.entries()) {
    out.add(d.severity, d.code, d.count, with_spelling(d.message, spelling));
  }
  return out;
}

}  // namespace burin
