#include "messages.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace burin::detail {
namespace {

struct Kind {
  std::string_view prefix;
  Severity severity;
};
constexpr std::array<Kind, 9> kKinds{{{"ERROR: ", Severity::Error},
                                      {"EXPORT-ERROR: ", Severity::Error},
                                      {"Can't open input file", Severity::Error},
                                      {"WARNING: ", Severity::Warning},
                                      {"EXPORT-WARNING: ", Severity::Warning},
                                      {"UI-WARNING: ", Severity::Warning},
                                      {"FONT-WARNING: ", Severity::Warning},
                                      {"DEPRECATED: ", Severity::Warning},
                                      {"ECHO: ", Severity::Info}}};

constexpr std::size_t kLongestText = 300;

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
  return (std::filesystem::path(folder) / file).string();
}

void Messages::add(const std::string& line) {
  last_ = clean_name(line);
  if (line.find("Current top level object is not a 3D object") != std::string::npos) {
    two_dimensional_ = true;
  }
  if (line.find("Current top level object is empty") != std::string::npos) empty_ = true;
  for (const Kind& kind : kKinds) {
    if (!line.starts_with(kind.prefix)) continue;
    Remark remark;
    remark.severity = kind.severity;
    // Those without a colon are whole sentences.
    remark.text = kind.prefix.ends_with(' ') ? line.substr(kind.prefix.size()) : line;
    take_place(remark);
    remark.text = clean_name(remark.text.substr(0, kLongestText));
    if (remark.text.find("open library") != std::string::npos &&
        remark.text.find("burin.scad") != std::string::npos) {
      remark.text +=
          " It comes with Burin (share/burin/openscad; samples/openscad of the source); save it "
          "beside the model";
    }
    remark.file = clean_name(remark.file == "<stdin>" && !file_.empty() ? file_ : remark.file);
    keep(std::move(remark));
    return;
  }
}

void Messages::keep(Remark remark) {
  const auto same = std::find_if(remarks_.begin(), remarks_.end(), [&](const Remark& r) {
    return r.severity == remark.severity && r.text == remark.text && r.file == remark.file &&
           r.line == remark.line;
  });
  if (same != remarks_.end()) {
    ++same->count;
    return;
  }
  const auto severity = static_cast<std::size_t>(remark.severity);
  if (kept_[severity] == kMostRemarks) {
    ++dropped_[severity];
    return;
  }
  ++kept_[severity];
  remarks_.push_back(std::move(remark));
}

const Remark* Messages::first(Severity severity) const {
  const auto found = std::find_if(remarks_.begin(), remarks_.end(),
                                  [&](const Remark& r) { return r.severity == severity; });
  return found == remarks_.end() ? nullptr : &*found;
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
