#include <burin/converters/mesh_reader.h>

#include "encoding.h"
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
    case MeshFormat::Amf:
      return read_amf(source);
  }
  source.fail("is of an unknown format");
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path, const RunContext& context,
                        const std::string& encoding) {
  try {
    const Source source(path, context);
    MeshFile file = read_as(detect_format(source, path), source);
    TextDecoder decoder(encoding);
    for (const PolygonSoup& soup : file.objects) decoder.learn(soup.name);
    for (PolygonSoup& soup : file.objects) {
      soup.name = clean_name(decoder.utf8(soup.name));
      drop_empty_texture(soup);
    }
    decoder.report(file.diagnostics);
    return file;
  } catch (const std::bad_alloc&) {
    throw InputError("does not fit into the memory of this machine", path.string());
  }
}

Scene read_mesh(const std::filesystem::path& path, const RunContext& context, Facets facets,
                const std::string& encoding) {
  return repair_parts(read_mesh_file(path, context, encoding), path, context, facets);
}

}  // namespace burin
