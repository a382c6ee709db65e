#pragma once
/// Triangle mesh files: STL, OBJ, OFF, PLY, 3MF.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/forms/mesh/texture_map.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace burin {

/// A mesh file as it stands, before any repair: one soup a named object.
struct MeshFile {
  /// "STL (binary)", "STL (ASCII)", "OBJ", "OFF", "PLY (ASCII)", "PLY (binary)", "3MF".
  std::string format;
  std::vector<PolygonSoup> objects;
  Diagnostics diagnostics;
};

/// Whether the suffix (any case) is one of this reader's.
bool is_mesh_suffix(const std::filesystem::path& path);

/// Reads a file without mending anything. The format follows from the content where that is clear,
/// else from the suffix. Throws InputError with the line (text formats) or the byte offset (binary
/// ones). Never allocates more than the bytes of the file can hold. Cost: 0.1 s per million
/// triangles of binary STL. `encoding`: of names, as iconv knows it; empty: it is found out.
MeshFile read_mesh_file(const std::filesystem::path& path, const RunContext& context,
                        const std::string& encoding = {});

/// u and v of a soup, or nothing where it has none. To be taken before `repair`.
std::shared_ptr<const TextureMap> texture_of(const PolygonSoup& soup, const RunContext& context);

/// Repairs each object of a file into a part of its own, named by the file where it has no name. A
/// part of which no triangle is left becomes a diagnostic; throws InputError where that happens to
/// all of them.
Scene repair_parts(MeshFile file, const std::filesystem::path& path, const RunContext& context);

/// Reads and repairs: one part an object, named by the file where the object has no name.
/// Diagnostics of both steps are in the scene's.
Scene read_mesh(const std::filesystem::path& path, const RunContext& context,
                const std::string& encoding = {});

/// Recognises the round surfaces that the facets of mesh parts stand for (kernel/docs/openscad.md);
/// what was found becomes a diagnostic, and what was not leaves its part as it is.
void heal_parts(Scene& scene, const RunContext& context);
/// The diagnostic "mesh.healed", where there are any.
void tell_round_faces(const RecognisedFaces& faces, const std::string& name,
                      Diagnostics& diagnostics);

}  // namespace burin
