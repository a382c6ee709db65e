#pragma once
/// Where models come from beside our own readers: files that plug-ins read, and forms that they
/// make.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/options/declared.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::plugin {

/// What a reader found: triangles as they stand in the file.
struct ReadMeshes {
  std::vector<PolygonSoup> objects;
  Diagnostics diagnostics;
};

/// A family of files. Texts live as long as the program.
struct ReaderKind {
  std::string_view name, meaning;
  /// ".tiny", lower case.
  std::vector<std::string> suffixes = {};
  /// Whether the first bytes of a file can only be this family's; empty: they never tell.
  std::function<bool(std::string_view head)> knows = {};
  /// `values`: of `options`, in their order. Throws InputError, Cancelled.
  std::function<ReadMeshes(const std::filesystem::path&, std::string_view bytes,
                           const std::vector<OptionValue>& values, RunContext&)>
      read = {};
  std::vector<DeclaredOption> options{};
};

/// A form that is asked for by name: the input "form:NAME".
struct FormKind {
  std::string_view name, meaning;
  /// Throws PluginError, GeometryError.
  std::function<std::shared_ptr<const Form>(const std::vector<OptionValue>& values, RunContext&)>
      make;
  std::vector<DeclaredOption> options{};
};

/// All that were added.
std::span<const ReaderKind> readers();
std::span<const FormKind> forms();

/// Adds one, or puts it in the place of one of its name.
void add(ReaderKind kind);
void add(FormKind kind);

/// What inputs that are forms begin with.
inline constexpr std::string_view kFormPrefix = "form:";

/// Whether an input names a form ("form:gyroids"), not a file.
bool names_form(std::string_view input);

/// The form that an input names. Throws UsageError that lists them all.
const FormKind& find_form(std::string_view input);

}  // namespace burin::plugin
