#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/repair/repair.h>

#include "encoding.h"
#include "formats.h"
#include "text.h"
#include "texture.h"

#include <fmt/format.h>

#include <memory>

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

void tell_partly_textured(const PolygonSoup& soup, Diagnostics& diagnostics) {
  const std::int64_t without = polygons_without_texture(soup);
  if (without == 0) return;
  diagnostics.add(Severity::Info, "mesh.partly_textured", without,
                  "faces have no texture coordinates though others of their part have them; laws "
                  "of u and v change nothing there");
}

/// The entries of one part's repair, with the part's name where there are several.
void append(Diagnostics& all, const Diagnostics& part, const std::string& name, bool several) {
  for (Diagnostic d : part.entries()) {
    if (several) d.message = fmt::format("{}: {}", name, d.message);
    all.add(std::move(d));
  }
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
    decoder.tell(file.diagnostics);
    return file;
  } catch (const std::bad_alloc&) {
    throw InputError("does not fit into the memory of this machine", path.string());
  }
}

Scene repair_parts(MeshFile file, const std::filesystem::path& path, const RunContext& context) {
  Scene scene;
  scene.diagnostics = std::move(file.diagnostics);
  const bool several = file.objects.size() > 1;
  std::string first_failure;
  for (PolygonSoup& soup : file.objects) {
    const std::string name = soup.name.empty() ? clean_name(path.stem().string()) : soup.name;
    Diagnostics diagnostics;
    try {
      auto texture = texture_of(soup, context);
      tell_partly_textured(soup, diagnostics);
      TriMesh mesh = repair(std::move(soup), {}, diagnostics, context);
      scene.parts.push_back(
          {name, path.string(), std::make_shared<MeshForm>(std::move(mesh), std::move(texture))});
    } catch (const GeometryError& e) {
      if (first_failure.empty()) first_failure = e.what();
      diagnostics.add(Severity::Error, "mesh.empty_part", 1,
                      "the part was left out: " + std::string(e.what()));
    }
    append(scene.diagnostics, diagnostics, name, several);
  }
  if (scene.parts.empty()) throw InputError(first_failure, path.string());
  return scene;
}

Scene read_mesh(const std::filesystem::path& path, const RunContext& context,
                const std::string& encoding) {
  return repair_parts(read_mesh_file(path, context, encoding), path, context);
}

}  // namespace burin
