#pragma once
// What OpenSCAD says, sorted; internal to the module.

#include <burin/base/diagnostics.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {

/// One line of OpenSCAD's: without its "WARNING:", its place taken out of the text.
struct Remark {
  Severity severity = Severity::Info;
  std::string text;
  /// As OpenSCAD names it: relative to its folder; empty and 0 where the remark has no place.
  std::string file = {};
  std::int64_t line = 0;
  std::int64_t count = 1;
};

/// Gathers the lines of one run. What comes again is counted; no more than kMostRemarks are kept
/// of each severity.
class Messages {
 public:
  /// `file`: the name of what OpenSCAD reads on its standard input. `folder`: where it runs; names
  /// of files in it, which today's OpenSCAD gives in full, are cut short.
  explicit Messages(std::string file = {}, std::string folder = {})
      : file_(std::move(file)), folder_(std::move(folder)) {}

  /// A line, of a remark or of one that began before: texts of assert() and echo() may have
  /// several.
  void add(const std::string& line);
  /// No line comes any more.
  void end();

  /// The first of a severity, or nullptr.
  const Remark* first(Severity severity) const;
  bool two_dimensional() const { return two_dimensional_; }
  bool empty() const { return empty_; }
  /// What a newer OpenSCAD may know and this one did not: "its syntax", a word of the language in
  /// quotes; or nothing.
  std::optional<std::string> not_understood() const;
  /// The last line, for programs that are no OpenSCAD.
  const std::string& last() const { return last_; }
  /// As "openscad.warning" and so on; `folder` is put before the names of files.
  Diagnostics diagnostics(const std::string& folder) const;

 private:
  bool begin(const std::string& line);
  bool go_on(const std::string& line);
  void trace(const std::string& line);
  void cut_folder(std::string& file) const;
  /// Whether it is a new one.
  bool keep(Remark remark);

  /// The remark whose text has not ended, and how many lines it has.
  std::optional<Remark> open_;
  int lines_ = 0;
  /// Whether the last remark needs no place in the program: it is no error in another file, or
  /// already names the call that led there.
  bool traced_ = true;
  std::vector<Remark> remarks_;
  std::int64_t kept_[3] = {0, 0, 0}, dropped_[3] = {0, 0, 0};
  bool two_dimensional_ = false, empty_ = false;
  std::string file_, folder_, last_;
};

inline constexpr std::int64_t kMostRemarks = 50;

/// `file` under `folder` where it is relative, the folder has a name and the file is there.
std::string in_folder(const std::string& folder, const std::string& file);

}  // namespace burin::detail
