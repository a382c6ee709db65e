#include <burin/converters/mesh_reader.h>

#include "formats.h"
#include "text.h"
#include "texture.h"

#include <new>

namespace burin {
namespace {

MeshFile read_as(MeshFormat format, const Source& source) {
  switch (format) {
    case MeshFormat::StlBinary:
      return read_stl_binary(source);
    case MeshFormat::StlAscii:
      return read_stl_ascii(source);
    case MeshFormat::Obj:
      return read_obj(source);
    case MeshFormat::Off:
      return read_off(source);
    case MeshFormat::Ply:
      return read_ply(source);
    case MeshFormat::ThreeMf:
      return read_3mf(source);
  }
  source.fail("is of an unknown format");
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path, const RunContext& context) {
  try {
    const Source source(path, context);
    MeshFile file = read_as(detect_format(source, path), source);
    for (PolygonSoup& soup : file.objects) {
      soup.name = clean_name(soup.name);
      drop_empty_texture(soup);
    }
    return file;
  } catch (const std::bad_alloc&) {
    throw InputError("does not fit into the memory of this machine", path.string());
  }
}

Scene read_mesh(const std::filesystem::path& path, const RunContext& context, Facets facets) {
  return repair_parts(read_mesh_file(path, context), path, context, facets);
}

}  // namespace burin
