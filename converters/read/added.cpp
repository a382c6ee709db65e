#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>

#include "readers.h"
#include "source.h"
#include "triangles_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin::detail {
namespace {

using Path = std::filesystem::path;

Scene read(const plugin::ReaderKind& kind, const Path& path, const ReadOptions& options,
           RunContext& context) {
  const Source source(path, context);
  plugin::ReadMeshes read = kind.read(
      path, source.bytes(), values_of(options.declared, kind.name, kind.options), context);
  if (read.objects.empty()) {
    throw InputError(fmt::format("the reader '{}' finds no part in it", kind.name), path.string());
  }
  return repair_parts({std::string(kind.meaning), std::move(read.objects), read.diagnostics}, path,
                      context);
}

FileInfo inspect(const plugin::ReaderKind& kind, const Path& path, const ReadOptions& options,
                 RunContext& context) {
  FileInfo info;
  info.file = path.string();
  info.format = std::string(kind.meaning);
  const Scene scene = read(kind, path, options, context);
  info.diagnostics = scene.diagnostics;
  measure_mesh_parts(scene, info, context);
  return info;
}

Scene make(const plugin::FormKind& kind, const Path& path, const ReadOptions& options,
           RunContext& context) {
  Scene scene;
  try {
    scene.parts.push_back(
        {std::string(kind.name), path.string(),
         kind.make(values_of(options.declared, kind.name, kind.options), context)});
    // What cannot tell these is of no use for any sheet.
    scene.parts.front().form->bounds(Mat3(1));
  } catch (const GeometryError& e) {
    throw InputError(e.what(), path.string());
  }
  scene.parts.front().plugin_form = kind.name;
  return scene;
}

FileInfo inspect(const plugin::FormKind& kind, const Path& path, const ReadOptions& options,
                 RunContext& context) {
  constexpr double kChord = 1e-4;  // of the size
  const Scene scene = make(kind, path, options, context);
  FileInfo info;
  info.file = path.string();
  info.format = std::string(kind.meaning);
  PartInfo part;
  part.name = scene.parts.front().name;
  part.bounds = scene.parts.front().form->bounds(Mat3(1));
  RealiseOptions realise;
  realise.tolerance = kChord * part.bounds.diagonal();
  realise.diagnostics = &info.diagnostics;
  const auto surface = scene.parts.front().form->realise(realise, context);
  const ProxyMesh& proxy = surface->proxy();
  part.components = static_cast<std::int64_t>(proxy.topology.component_closed.size());
  part.faces = proxy.region_count;
  part.boundary_edges = std::ranges::count(proxy.topology.opposite, kNoHalfEdge);
  measure_triangles(proxy.mesh, part);
  info.parts.push_back(std::move(part));
  return info;
}

}  // namespace

Reader added_reader(const plugin::ReaderKind& kind) {
  return {.formats = std::string(kind.meaning),
          .knows_content = kind.knows,
          .knows_suffix =
              [kind](const Path& path) {
                const std::string suffix = model_suffix(path);
                return std::ranges::find(kind.suffixes, suffix) != kind.suffixes.end();
              },
          .read = [kind](const Path& path, const ReadOptions& o,
                         RunContext& c) { return ReadResult{read(kind, path, o, c)}; },
          .inspect = [kind](const Path& path, const ReadOptions& o,
                            RunContext& c) { return inspect(kind, path, o, c); },
          .family = Added,
          .added = std::string(kind.name)};
}

Reader added_form(const plugin::FormKind& kind) {
  return {.formats = std::string(kind.meaning),
          .knows_content = {},
          .knows_suffix = [](const Path&) { return false; },
          .read = [kind](const Path& path, const ReadOptions& o,
                         RunContext& c) { return ReadResult{make(kind, path, o, c)}; },
          .inspect = [kind](const Path& path, const ReadOptions& o,
                            RunContext& c) { return inspect(kind, path, o, c); },
          .family = Added,
          .added = std::string(kind.name)};
}

}  // namespace burin::detail
