#pragma once
/// Zip archives: what 3MF files and FreeCAD documents are.

#include "source.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// Members of an archive in memory, unpacked one at a time (libzip behind it). Errors are
/// InputErrors of `source`.
class Package {
 public:
  /// `kind` for messages: "3MF archive". Throws where it is no zip archive.
  Package(const Source& source, std::string kind);
  ~Package();
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  /// The names of all members.
  std::vector<std::string> names() const;
  /// Whether there is a member of this name (in any case, with or without a leading slash).
  bool has(const std::string& name) const;
  /// The unpacked bytes; the run is polled for a cancel. Refused where they are far more than their
  /// packed size or this machine's memory allows.
  std::string read(const std::string& name) const;

 private:
  struct Impl;
  const Source& source_;
  std::string kind_;
  std::unique_ptr<Impl> impl_;
};

/// An archive of members, (name, bytes), packed; the same bytes for the same members. Throws
/// OutputError.
std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& members);

}  // namespace burin
