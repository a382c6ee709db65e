#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/input_name.h>
#include <burin/base/missing_file.h>
#include <burin/base/platform.h>
#include <burin/base/plugin_error.h>
#include <burin/converters/read.h>
#include <burin/plugin/sources.h>

#include "readers.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace burin {

void check_inputs(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (plugin::names_form(path)) {
      plugin::find_form(path);
      continue;
    }
    if (is_standard_input(path)) continue;
    InputFiles::opens(path);
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
      throw MissingFile(path.empty() ? "the name of a model file is empty"
                                     : "there is no such file; check the path",
                        path);
    }
    if (error) throw InputError("cannot be opened: " + error.message(), path);
    if (is_directory(status)) throw InputError("is a folder; name a model file in it", path);
    if (!platform::may_read(path)) {
      throw InputError("no permission to read it; change that or copy the file", path);
    }
  }
}

namespace {

/// A form of a plug-in that fails is left out where there is something else.
ReadResult read_one(const std::string& path, const detail::Reader& reader,
                    const ReadOptions& options, bool may_fail, RunContext& context) {
  try {
    return reader.read(path, options, context);
  } catch (const PluginError& e) {
    if (!may_fail) throw;
    ReadResult none;
    none.scene.diagnostics.add(Severity::Warning, "plugin.quarantined", 1,
                               std::string(e.what()) + "; the drawing goes on without it");
    return none;
  }
}

/// What a file is called in warnings: without its folder, so that drawing files do not depend on
/// that, unless another input has the same name.
std::string name_in_warnings(const std::string& path, const std::vector<std::string>& paths) {
  if (is_standard_input(path)) return "standard input";
  const auto name = [](const std::string& p) {
    return std::filesystem::path(p).filename().string();
  };
  const auto same = [&](const std::string& p) { return p != path && name(p) == name(path); };
  return std::ranges::any_of(paths, same) ? path : name(path);
}

/// Readers know a file by its bytes, and many warnings are of layers that know no file at all.
void add_named(const Diagnostics& found, const std::string& name, Diagnostics& all) {
  for (Diagnostic one : found.entries()) {
    if (one.severity != Severity::Info && one.message.find(name) == std::string::npos) {
      one.message.insert(0, name + ": ");
    }
    all.add(std::move(one));
  }
}

}  // namespace

ReadResult read_files(const std::vector<std::string>& paths, const ReadOptions& options,
                      RunContext& context) {
  context.begin_stage(RunStage::Read);
  ReadResult all;
  Scene& scene = all.scene;
  std::vector<const detail::Reader*> readers;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const GivenFormat format(paths[i], detail::given_format(paths[i], options));
    readers.push_back(&detail::reader_of(paths[i], options, context));
    ReadResult one = read_one(paths[i], *readers.back(), options, paths.size() > 1, context);
    std::ranges::move(one.scene.parts, std::back_inserter(scene.parts));
    std::ranges::move(one.marks, std::back_inserter(all.marks));
    add_named(one.scene.diagnostics, name_in_warnings(paths[i], paths), scene.diagnostics);
    context.progress(static_cast<double>(i + 1) / static_cast<double>(paths.size()));
  }
  detail::name_unused(options, paths, readers, scene);
  context.end_stage();
  return all;
}

Scene read_scene(const std::vector<std::string>& paths, const ReadOptions& options,
                 RunContext& context) {
  return read_files(paths, options, context).scene;
}

FileInfo inspect_file(const std::filesystem::path& path, const ReadOptions& options,
                      RunContext& context) {
  const GivenFormat format(path, detail::given_format(path, options));
  return detail::reader_of(path, options, context).inspect(path, options, context);
}

}  // namespace burin
