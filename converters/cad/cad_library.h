#pragma once
/// The entry point of libburin_cad: one symbol, `burin_cad_library`, which gives this.

#include <burin/base/run_context.h>
#include <burin/converters/cad_reader.h>
#include <burin/converters/file_info.h>
#include <burin/converters/trimmed_faces.h>
#include <burin/forms/charted/chart.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace burin {

/// Both sides are built together and share libburin: C++ types and exceptions pass. `version` must
/// be looked at before anything else is used.
struct CadLibrary {
  const char* version;
  Scene (*read)(const std::filesystem::path& path, const CadReadOptions& options,
                RunContext& context);
  FileInfo (*inspect)(const std::filesystem::path& path, const CadReadOptions& options,
                      RunContext& context);
  std::shared_ptr<const BrepShape> (*read_text)(const std::string& brep, RunContext& context);
  std::shared_ptr<const BrepShape> (*read_shape)(const std::string& bytes, BrepBytes kind,
                                                 RunContext& context);
  std::shared_ptr<const BrepShape> (*trimmed_faces)(const std::vector<TrimmedSurface>& surfaces,
                                                    double weld, const std::string& file,
                                                    const RunContext& context);
};

inline constexpr const char* kCadLibraryEntry = "burin_cad_library";
using CadLibraryEntry = const CadLibrary* (*)();

}  // namespace burin
