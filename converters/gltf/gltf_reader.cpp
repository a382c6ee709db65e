#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/gltf_reader.h>
#include <burin/converters/mesh_info.h>

#include "document.h"
#include "nodes.h"
#include "source.h"

#include <new>
#include <string>

namespace burin {

bool is_gltf_content(std::string_view head) {
  if (head.starts_with("glTF")) return true;
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  if (begin == head.npos || head[begin] != '{') return false;
  const auto has = [&](std::string_view word) { return head.find(word) != head.npos; };
  return has("\"asset\"") && has("\"version\"") && !has("\"burin");
}

bool is_gltf_suffix(const std::filesystem::path& path) {
  const std::string suffix = model_suffix(path);
  return suffix == ".gltf" || suffix == ".glb";
}

MeshFile read_gltf_file(const std::filesystem::path& path, const RunContext& context) {
  try {
    const Source source(path, context);
    return gltf::parts_of(gltf::load(source), source);
  } catch (const std::bad_alloc&) {
    throw InputError("does not fit into the memory of this machine", path.string());
  }
}

Scene read_gltf(const std::filesystem::path& path, const RunContext& context, Facets facets) {
  return repair_parts(read_gltf_file(path, context), path, context, facets);
}

FileInfo inspect_gltf(const std::filesystem::path& path, RunContext& context) {
  return inspect_mesh_file(read_gltf_file(path, context), path, context);
}

}  // namespace burin
