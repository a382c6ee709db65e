#include "messages.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace burin::detail {
namespace {

struct MessageKind {
  std::string_view prefix;
  Severity severity;
};
constexpr std::array<MessageKind, 9> kKinds{{{"ERROR: ", Severity::Error},
                                             {"EXPORT-ERROR: ", Severity::Error},
                                             {"Can't open input file", Severity::Error},
                                             {"WARNING: ", Severity::Warning},
                                             {"EXPORT-WARNING: ", Severity::Warning},
                                             {"UI-WARNING: ", Severity::Warning},
                                             {"FONT-WARNING: ", Severity::Warning},
                                             {"DEPRECATED: ", Severity::Warning},
                                             {"ECHO: ", Severity::Info}}};

constexpr std::size_t kLongestText = 300;
/// Of one remark; a quote that never closes swallows no more.
constexpr int kMostLines = 20;

/// Takes " in file NAME, line N" off the end of the text.
void take_place(Remark& remark) {
  constexpr std::string_view kIn = " in file ", kLine = ", line ";
  const std::size_t line = remark.text.rfind(kLine);
  if (line == std::string::npos) return;
  const std::size_t in = remark.text.rfind(kIn, line);
  if (in == std::string::npos) return;
  std::int64_t number = 0;
  const std::string digits = remark.text.substr(line + kLine.size());
  for (const char c : digits) {
    if (c < '0' || c > '9' || number > 1'000'000'000) return;
    number = 10 * number + (c - '0');
  }
  remark.line = number;
  remark.file = remark.text.substr(in + kIn.size(), line - in - kIn.size());
  remark.text.resize(in);
  while (remark.text.ends_with(',') || remark.text.ends_with(' ')) remark.text.pop_back();
}

const char* code_of(Severity severity) {
  return severity == Severity::Error     ? "openscad.error"
         : severity == Severity::Warning ? "openscad.warning"
                                         : "openscad.echo";
}

}  // namespace

std::string in_folder(const std::string& folder, const std::string& file) {
  if (file.empty() || folder.empty() || std::filesystem::path(file).is_absolute()) return file;
  const std::filesystem::path there = std::filesystem::path(folder) / file,
                              plain = there.lexically_normal();
  // Of what happens within an expression OpenSCAD tells the name of the file without its folder.
  std::error_code error;
  if (!std::filesystem::exists(there, error)) return file;
  return (std::filesystem::equivalent(there, plain, error) ? plain : there).string();
}

bool Messages::begin(const std::string& line) {
  const auto kind = std::ranges::find_if(
      kKinds, [&](const MessageKind& k) { return line.starts_with(k.prefix); });
  if (kind == kKinds.end()) return false;
  end();
  Remark remark;
  remark.severity = kind->severity;
  // Those without a colon are whole sentences.
  remark.text = kind->prefix.ends_with(' ') ? line.substr(kind->prefix.size()) : line;
  open_ = std::move(remark);
  lines_ = 1;
  return true;
}

bool Messages::go_on(const std::string& line) {
  constexpr std::string_view kTrace = "TRACE: ";
  if (!open_ || lines_ >= kMostLines || line.starts_with(kTrace)) return false;
  if (std::ranges::count(open_->text, '"') % 2 == 0) return false;
  std::string_view more = line;
  more.remove_prefix(std::min(more.find_first_not_of(" \t"), more.size()));
  // Libraries begin their texts with an empty line.
  if (!more.empty() && !open_->text.ends_with('"')) open_->text += ' ';
  open_->text += more;
  ++lines_;
  return true;
}

void Messages::trace(const std::string& line) {
  constexpr std::string_view kCalled = "TRACE: called by '";
  if (traced_ || !line.starts_with(kCalled) || remarks_.empty()) return;
  Remark call;
  call.text = line.substr(kCalled.size());
  take_place(call);
  cut_folder(call.file);
  if (call.line == 0 || (call.file != "<stdin>" && call.file != file_)) return;
  traced_ = true;
  while (call.text.ends_with('\'')) call.text.pop_back();
  remarks_.back().text += fmt::format("; called by {} in {}, line {}", in_quotes(call.text),
                                      clean_name(file_), call.line);
}

void Messages::cut_folder(std::string& file) const {
  if (!folder_.empty() && file.starts_with(folder_ + "/")) file.erase(0, folder_.size() + 1);
}

void Messages::end() {
  if (!open_) return;
  Remark remark = *std::exchange(open_, std::nullopt);
  take_place(remark);
  cut_folder(remark.file);
  remark.text = clean_name(remark.text.substr(0, kLongestText));
  if (remark.text.find("open library") != std::string::npos &&
      remark.text.find("burin.scad") != std::string::npos) {
    remark.text +=
        " It comes with Burin (share/burin/openscad; samples/openscad of the source); save it "
        "beside the model";
  }
  remark.file = clean_name(remark.file == "<stdin>" && !file_.empty() ? file_ : remark.file);
  traced_ = remark.severity != Severity::Error || remark.line == 0 || remark.file == file_;
  if (!keep(std::move(remark))) traced_ = true;
}

void Messages::add(const std::string& line) {
  last_ = clean_name(line);
  if (line.find("Current top level object is not a 3D object") != std::string::npos) {
    two_dimensional_ = true;
  }
  if (line.find("Current top level object is empty") != std::string::npos) empty_ = true;
  if (begin(line) || go_on(line)) return;
  end();
  trace(line);
}

bool Messages::keep(Remark remark) {
  const auto same = std::find_if(remarks_.begin(), remarks_.end(), [&](const Remark& r) {
    return r.severity == remark.severity && r.text == remark.text && r.file == remark.file &&
           r.line == remark.line;
  });
  if (same != remarks_.end()) {
    ++same->count;
    return false;
  }
  const auto severity = static_cast<std::size_t>(remark.severity);
  if (kept_[severity] == kMostRemarks) {
    ++dropped_[severity];
    return false;
  }
  ++kept_[severity];
  remarks_.push_back(std::move(remark));
  return true;
}

const Remark* Messages::first(Severity severity) const {
  const auto found = std::find_if(remarks_.begin(), remarks_.end(),
                                  [&](const Remark& r) { return r.severity == severity; });
  return found == remarks_.end() ? nullptr : &*found;
}

std::optional<std::string> Messages::not_understood() const {
  // Modules, functions and parameters that came after 2021.01.
  constexpr std::array<std::string_view, 12> kNewer{
      "module 'roof'",     "module 'fill'",     "function 'textmetrics'", "function 'fontmetrics'",
      "function 'import'", "function 'object'", "function 'is_object'",   "function 'has_key'",
      "module 'import3d'", "variable v not",    "variable start not",     "function 'import3d'"};
  for (const Remark& remark : remarks_) {
    if (remark.severity == Severity::Error && remark.text.starts_with("Parser error")) {
      return "its syntax";
    }
    if (remark.severity != Severity::Warning) continue;
    for (const std::string_view newer : kNewer) {
      if (remark.text.find(newer) == std::string::npos) continue;
      const std::string_view word = newer.substr(newer.find(' ') + 1);
      return word.ends_with(" not") ? fmt::format("'{}'", word.substr(0, word.size() - 4))
                                    : std::string(word);
    }
  }
  return {};
}

Diagnostics Messages::diagnostics(const std::string& folder) const {
  Diagnostics all;
  for (const Remark& r : remarks_) {
    std::string text = r.severity == Severity::Info ? "ECHO: " + r.text : r.text;
    if (r.line > 0) text = fmt::format("{}:{}: {}", in_folder(folder, r.file), r.line, text);
    all.add(r.severity, code_of(r.severity), r.count, "OpenSCAD: " + text);
  }
  for (const Severity s : {Severity::Error, Severity::Warning, Severity::Info}) {
    const std::int64_t dropped = dropped_[static_cast<std::size_t>(s)];
    if (dropped == 0) continue;
    all.add(s, code_of(s), dropped, fmt::format("OpenSCAD: {} more lines of the kind", dropped));
  }
  return all;
}

}  // namespace burin::detail
