#include <burin/converters/cad_reader.h>
#include <burin/converters/trimmed_faces.h>

#include "../cad_format.h"
#include "../cad_library.h"
#include "beside.h"

namespace burin {
namespace {

const CadLibrary& load() {
  const LibraryWords words{"reads CAD files", "or export the model as STL"};
  const auto entry =
      reinterpret_cast<CadLibraryEntry>(library_entry(BURIN_CAD_LIBRARY, kCadLibraryEntry, words));
  const CadLibrary& cad = *entry();
  check_library_version(BURIN_CAD_LIBRARY, cad.version, words);
  return cad;
}

const CadLibrary& library() {
  static const CadLibrary& cad = load();
  return cad;
}

}  // namespace

bool is_cad_suffix(const std::filesystem::path& path) {
  return cad_format_of_suffix(path).has_value();
}

bool is_cad_content(std::string_view head) { return cad_format_of(head).has_value(); }

Scene read_cad(const std::filesystem::path& path, RunContext& context,
               const CadReadOptions& options) {
  return library().read(path, options, context);
}

FileInfo inspect_cad(const std::filesystem::path& path, RunContext& context,
                     const CadReadOptions& options) {
  return library().inspect(path, options, context);
}

std::shared_ptr<const BrepShape> read_brep_text(const std::string& brep, RunContext& context) {
  return library().read_text(brep, context);
}

Part read_brep_text(const std::string& brep, const Placement& placement, RunContext& context) {
  Part part;
  part.form = read_brep_text(brep, context)->form(placement);
  return part;
}

std::shared_ptr<const BrepShape> read_brep_shape(const std::string& bytes, BrepBytes kind,
                                                 RunContext& context) {
  return library().read_shape(bytes, kind, context);
}

std::shared_ptr<const BrepShape> make_trimmed_faces(const std::vector<TrimmedSurface>& surfaces,
                                                    double weld, const std::string& file,
                                                    const RunContext& context) {
  return library().trimmed_faces(surfaces, weld, file, context);
}

}  // namespace burin
