#pragma once
// The table of readers; internal to the module.

#include <burin/converters/read.h>
#include <burin/plugin/sources.h>

#include "read_options.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// One family of formats. A new one is a source in families/ and its name in cmake/pieces.cmake.
struct Reader {
  /// For help: "STL, OBJ".
  std::string formats;
  /// Whether the first bytes of a file (as many as `kHeadBytes`, less where the file is shorter)
  /// can only be this family's; absent = the content never tells.
  std::function<bool(std::string_view head)> knows_content;
  std::function<bool(const std::filesystem::path& path)> knows_suffix;
  std::function<ReadResult(const std::filesystem::path& path, const ReadOptions& options,
                           RunContext& context)>
      read;
  std::function<FileInfo(const std::filesystem::path& path, const ReadOptions& options,
                         RunContext& context)>
      inspect;
  Family family;
  /// Of `Brought`: its name.
  std::string added = {};
  /// The options that are about its files alone.
  std::vector<ReadRow> (*options)() = nullptr;
  /// Whether `knows_content` knows all of its files, so that what it does not know is another's.
  bool content_shows = false;
};

/// Those that Burin was built with, in the order in which they are asked.
std::span<const Reader* const> own_readers();

/// "STEP files need Burin with OCCT (BURIN_CAD)": for the suffixes of readers that it was built
/// without, and that nobody else reads; else empty.
std::string needed_for(const std::filesystem::path& path);

/// The readers and the forms that plug-ins added.
Reader added_reader(const plugin::ReaderKind& kind);
Reader added_form(const plugin::FormKind& kind);

inline constexpr std::size_t kHeadBytes = 4096;

/// Adds a diagnostic for each option that was given and that none of the files looked at: the
/// readers that read them, one per path, and what they made of them.
void name_unused(const ReadOptions& options, const std::vector<std::string>& paths,
                 std::span<const Reader* const> readers, Scene& scene);

/// By content where that is clear, else by the suffix, else raw data where its layout is given,
/// else the readers of meshes, which say what is wrong with a file that nobody knows.
const Reader& reader_of(const std::filesystem::path& path, const ReadOptions& options,
                        const RunContext& context);

/// The suffix that the user gave a file by `input_format`; empty where its name has one that is
/// known.
std::string given_format(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace burin::detail
