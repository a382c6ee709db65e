#include <burin/base/input_name.h>
#include <burin/forms/implicit/implicit_form.h>

#include "read_options.h"
#include "readers.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

/// Whether a reader that knows an option also met what it is about.
bool met(std::string_view name, const ReadOptions& options, const std::string& path,
         const Reader& reader, const Scene& scene) {
  const ReadRow* row = find_read_row(name);
  if (name == "input_format") return !given_format(path, options).empty();
  if (row == nullptr || (row->families & reader.family) == 0) return false;
  if (row->families == Added) return row->added == reader.added;
  if (name == "freecad_timeout") return options.recompute;
  // The layout of raw samples goes for any file that nothing else tells of.
  if (name == "raw" || name == "raw_skip") {
    ReadOptions without = options;
    without.volume.raw.reset();
    const std::string suffix = model_suffix(path);
    return suffix == ".raw" || &reader_of(path, without, RunContext()) != &reader;
  }
  if (reader.family != Splines) return true;
  // Files of spline patches may have trivariate ones among them.
  return std::any_of(scene.parts.begin(), scene.parts.end(), [&](const Part& part) {
    return part.source == path && dynamic_cast<const ImplicitForm*>(part.form.get()) != nullptr;
  });
}

}  // namespace

void name_unused(const ReadOptions& options, const std::vector<std::string>& paths,
                 std::span<const Reader* const> readers, Scene& scene) {
  for (const ReadOptions::Given& given : options.given) {
    bool used = false;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      used = used || met(given.name, options, paths[i], *readers[i], scene);
    }
    if (used) continue;
    const ReadRow* row = find_read_row(given.name);
    const std::string where =
        paths.size() == 1 ? paths.front() : fmt::format("any of the {} inputs", paths.size());
    scene.diagnostics.add(Severity::Warning, "option.unused", 1,
                          fmt::format("{} has no effect on {}; it is for {}", given.spelled, where,
                                      row == nullptr ? "other files" : row->purpose));
  }
}

}  // namespace burin::detail

namespace burin {

bool concerns(const std::string& option, const std::filesystem::path& path) {
  const detail::ReadRow* row = detail::find_read_row(option);
  if (row == nullptr) return false;
  // Any file may hold raw samples.
  if (option == "raw" || option == "raw_skip" || option == "input_format") return true;
  return (row->families & detail::reader_of(path, {}, RunContext()).family) != 0;
}

}  // namespace burin
