#include "readers.h"

#include <burin/base/catalogue.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/mesh_reader.h>
#include <burin/converters/read_formats.h>

#include "packed.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>

namespace burin::detail {
namespace {

/// Those of plug-ins.
struct AddedReaders {
  std::vector<Reader> readers, forms;
};

const AddedReaders& added() {
  static MadeOfCatalogues<AddedReaders> all;
  return all.get([] {
    AddedReaders out;
    for (const plugin::ReaderKind& kind : plugin::readers()) {
      out.readers.push_back(added_reader(kind));
    }
    for (const plugin::FormKind& kind : plugin::forms()) out.forms.push_back(added_form(kind));
    return out;
  });
}

std::vector<const Reader*> all_readers() {
  const std::span<const Reader* const> own = own_readers();
  std::vector<const Reader*> all(own.begin(), own.end());
  for (const Reader& reader : added().readers) all.push_back(&reader);
  return all;
}

}  // namespace

std::string given_format(const std::filesystem::path& path, const ReadOptions& options) {
  if (options.input_format.empty()) return {};
  const std::vector<const Reader*> readers = all_readers();
  const auto knows = [&](const Reader* reader) { return reader->knows_suffix(path); };
  const bool is_known = !is_standard_input(path) && std::ranges::any_of(readers, knows);
  return is_known ? std::string() : "." + options.input_format;
}

namespace {

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

/// Null where Burin was built without.
const Reader* own_reader(Family family) {
  const auto own = own_readers();
  // The last one: glTF is a mesh, too.
  const auto found =
      std::find_if(own.rbegin(), own.rend(), [&](const Reader* r) { return r->family == family; });
  return found == own.rend() ? nullptr : *found;
}

/// Whether the content is a mesh and the suffix that of a format which content would show.
bool is_misnamed_mesh(const Reader& reader, const std::filesystem::path& path,
                      const std::string& head) {
  if (!reader.content_shows) return false;
  return is_mesh_content(head, size_of(path));
}

}  // namespace

const Reader& reader_of(const std::filesystem::path& path, const ReadOptions& options,
                        const RunContext& context) {
  if (plugin::names_form(path.string())) {
    const std::string name(plugin::find_form(path.string()).name);
    return *std::ranges::find(added().forms, name, &Reader::added);
  }
  const std::string head = head_of(path, kHeadBytes, context);
  const std::vector<const Reader*> readers = all_readers();
  for (const Reader* reader : readers) {
    if (reader->knows_content && reader->knows_content(head)) return *reader;
  }
  for (const Reader* reader : readers) {
    if (!reader->knows_suffix(path)) continue;
    return is_misnamed_mesh(*reader, path, head) ? *own_reader(Meshes) : *reader;
  }
  const Reader* const samples = options.volume.raw ? own_reader(Volumes) : nullptr;
  if (samples != nullptr) return *samples;
  const std::string needed = needed_for(path);
  const bool is_mesh = is_mesh_content(head, size_of(path));
  if (!needed.empty() && !is_mesh) throw InputError(needed, path.string());
  return *own_reader(Meshes);
}

}  // namespace burin::detail

namespace burin {

bool is_read_suffix(std::string_view suffix) {
  const std::filesystem::path path = "x" + std::string(suffix);
  return std::ranges::any_of(detail::all_readers(),
                             [&](const detail::Reader* r) { return r->knows_suffix(path); });
}

bool is_own_suffix(std::string_view suffix) {
  const std::filesystem::path path = "x" + std::string(suffix);
  return std::ranges::any_of(detail::own_readers(),
                             [&](const detail::Reader* r) { return r->knows_suffix(path); });
}

std::vector<std::string> read_formats() {
  std::vector<std::string> names;
  for (const detail::Reader* reader : detail::own_readers()) names.push_back(reader->formats);
  return names;
}

}  // namespace burin
