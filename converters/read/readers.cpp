#include "readers.h"

#include <burin/base/catalogue.h>
#include <burin/base/input_name.h>
#include <burin/converters/cad_reader.h>
#include <burin/converters/fcstd_reader.h>
#include <burin/converters/gltf_reader.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/irit_reader.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/volume_reader.h>

#include "packed.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <system_error>

namespace burin::detail {
namespace {

using Path = std::filesystem::path;

Facets facets_of(const ReadOptions& o) {
  return o.heal.value_or(false) ? Facets::Recognised : Facets::Kept;
}

const Reader kMesh{"STL, OBJ, OFF, PLY, 3MF",
                   nullptr,
                   is_mesh_suffix,
                   [](const Path& path, const ReadOptions& o, RunContext& c) {
                     return ReadResult{read_mesh(path, c, facets_of(o), o.encoding)};
                   },
                   [](const Path& path, const ReadOptions& o, RunContext& c) {
                     return inspect_mesh(path, c, o.encoding);
                   },
                   Meshes};

const Reader kGltf{
    "glTF, GLB",
    is_gltf_content,
    is_gltf_suffix,
    [](const Path& path, const ReadOptions& o, RunContext& c) {
      return ReadResult{read_gltf(path, c, facets_of(o))};
    },
    [](const Path& path, const ReadOptions&, RunContext& c) { return inspect_gltf(path, c); },
    Meshes};

const Reader kCad{"STEP, IGES, BREP",
                  is_cad_content,
                  is_cad_suffix,
                  [](const Path& path, const ReadOptions& o, RunContext& c) {
                    return ReadResult{read_cad(path, c, o.encoding)};
                  },
                  [](const Path& path, const ReadOptions& o, RunContext& c) {
                    return inspect_cad(path, c, o.encoding);
                  },
                  CadFiles};

IritReadOptions irit_options(const ReadOptions& o) {
  return {o.volume.level.value_or(0), o.volume.inside_above.value_or(false), o.bounds, o.encoding};
}

const Reader kIrit{"ITD, IRT, BEZ, BBP",
                   is_irit_content,
                   is_irit_suffix,
                   [](const Path& path, const ReadOptions& o, RunContext& c) {
                     return ReadResult{read_irit(path, c, irit_options(o))};
                   },
                   [](const Path& path, const ReadOptions& o, RunContext& c) {
                     return inspect_irit(path, c, irit_options(o));
                   },
                   Splines};

const Reader kImplicit{"IMPLICIT",
                       nullptr,
                       is_implicit_suffix,
                       [](const Path& path, const ReadOptions& o, RunContext& c) {
                         return ReadResult{read_implicit(path, {o.bounds, {o.mesher}}, c)};
                       },
                       [](const Path& path, const ReadOptions& o, RunContext& c) {
                         return inspect_implicit(path, {o.bounds, {o.mesher}}, c);
                       },
                       Functions};

OpenscadOptions openscad_options(const ReadOptions& o) {
  return {o.defines, o.openscad_timeout, o.csg, o.heal.value_or(true), o.as_implicit};
}

const Reader kOpenscad{"OpenSCAD",
                       nullptr,
                       is_openscad_suffix,
                       [](const Path& path, const ReadOptions& o, RunContext& c) {
                         return read_openscad(path, openscad_options(o), c);
                       },
                       [](const Path& path, const ReadOptions& o, RunContext& c) {
                         return inspect_openscad(path, openscad_options(o), c);
                       },
                       OpenscadFiles};

FcstdOptions fcstd_options(const ReadOptions& o) {
  return {o.objects, o.recompute, o.freecad_timeout};
}

const Reader kFcstd{"FreeCAD",
                    is_fcstd_content,
                    is_fcstd_suffix,
                    [](const Path& path, const ReadOptions& o, RunContext& c) {
                      return ReadResult{read_fcstd(path, fcstd_options(o), c)};
                    },
                    [](const Path& path, const ReadOptions& o, RunContext& c) {
                      return inspect_fcstd(path, fcstd_options(o), c);
                    },
                    FreecadFiles};

const Reader kVolume{"NRRD, MHA, MHD, INR, NII, VTI, RAW",
                     is_volume_content,
                     is_volume_suffix,
                     [](const Path& path, const ReadOptions& o, RunContext& c) {
                       return ReadResult{read_volume_scene(path, o.volume, o.bounds, c)};
                     },
                     [](const Path& path, const ReadOptions& o, RunContext& c) {
                       return inspect_volume(path, o.volume, o.bounds, c);
                     },
                     Volumes};

const std::array kReaders{&kCad, &kGltf, &kIrit, &kImplicit, &kOpenscad, &kFcstd, &kVolume, &kMesh};

/// Those of plug-ins.
struct BroughtReaders {
  std::vector<Reader> readers, forms;
};

const BroughtReaders& brought() {
  static MadeOfCatalogues<BroughtReaders> all;
  return all.get([] {
    BroughtReaders out;
    for (const plugin::ReaderKind& kind : plugin::readers()) {
      out.readers.push_back(brought_reader(kind));
    }
    for (const plugin::FormKind& kind : plugin::forms()) out.forms.push_back(brought_form(kind));
    return out;
  });
}

std::vector<const Reader*> all_readers() {
  std::vector<const Reader*> all(kReaders.begin(), kReaders.end());
  for (const Reader& reader : brought().readers) all.push_back(&reader);
  return all;
}

}  // namespace

std::string given_format(const std::filesystem::path& path, const ReadOptions& options) {
  if (options.input_format.empty()) return {};
  const std::vector<const Reader*> readers = all_readers();
  const auto knows = [&](const Reader* reader) { return reader->knows_suffix(path); };
  const bool told = !is_standard_input(path) && std::ranges::any_of(readers, knows);
  return told ? std::string() : "." + options.input_format;
}

namespace {

/// Whether the content is a mesh and the suffix that of a format which content would show.
bool is_misnamed_mesh(const Reader& reader, const std::filesystem::path& path,
                      const std::string& head) {
  if (&reader != &kCad && &reader != &kGltf) return false;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return is_mesh_content(head, error ? 0 : size);
}

}  // namespace

const Reader& reader_of(const std::filesystem::path& path, const ReadOptions& options,
                        const RunContext& context) {
  if (plugin::names_form(path.string())) {
    const std::string name(plugin::find_form(path.string()).name);
    return *std::ranges::find(brought().forms, name, &Reader::brought);
  }
  const std::string head = head_of(path, kHeadBytes, context);
  const std::vector<const Reader*> readers = all_readers();
  for (const Reader* reader : readers) {
    if (reader->knows_content && reader->knows_content(head)) return *reader;
  }
  for (const Reader* reader : readers) {
    if (!reader->knows_suffix(path)) continue;
    return is_misnamed_mesh(*reader, path, head) ? kMesh : *reader;
  }
  return options.volume.raw ? kVolume : kMesh;
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
  return std::ranges::any_of(detail::kReaders,
                             [&](const detail::Reader* r) { return r->knows_suffix(path); });
}

}  // namespace burin
