#pragma once
// FreeCAD itself, run to recompute a copy of a document; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>

#include <filesystem>
#include <memory>

namespace burin::detail {

/// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The recomputed copy of `document` in `folder`; the document stays as it is. Objects that FreeCAD
/// could not compute become diagnostics "fcstd.recompute". Throws InputError.
std::filesystem::path recompute(const std::filesystem::path& document, double timeout,
                                const TemporaryFolder& folder, Diagnostics& diagnostics,
                                RunContext& context);

}  // namespace burin::detail
