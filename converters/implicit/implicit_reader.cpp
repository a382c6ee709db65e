#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/implicit_reader.h>
#include <burin/forms/implicit/implicit_form.h>

#include "source.h"
#include "triangles_info.h"

#include <memory>

namespace burin {

bool is_implicit_suffix(const std::filesystem::path& path) {
  return model_suffix(path) == ".implicit";
}

Scene read_implicit(const std::filesystem::path& path, const ImplicitReadOptions& options,
                    const RunContext& context) {
  const Source source(path, context);
  Scene scene = read_implicit_text(source.bytes(), source.file(), options, context);
  scene.parts.front().name = model_stem(path);
  scene.parts.front().source = path.string();
  return scene;
}

Scene read_implicit_text(std::string_view text, const std::string& file,
                         const ImplicitReadOptions& options, const RunContext& context) {
  const Expression expression = parse_implicit(text, file);
  Scene scene;
  try {
    auto form = std::make_shared<ImplicitForm>(make_function(expression), options.bounds, context,
                                               0, options.proxy);
    scene.parts.push_back({"function", file, std::move(form)});
  } catch (const GeometryError& e) {
    throw InputError(e.what(), file);
  } catch (const UsageError& e) {
    throw InputError(e.what(), file);
  }
  return scene;
}

FileInfo inspect_implicit(const std::filesystem::path& path, const ImplicitReadOptions& options,
                          RunContext& context) {
  const Scene scene = read_implicit(path, options, context);
  FileInfo info;
  info.file = path.string();
  info.format = "implicit function";
  info.parts.push_back(measure_realised_part(scene.parts.front(), info.diagnostics, context));
  return info;
}

}  // namespace burin
