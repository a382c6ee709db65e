#pragma once
/// Triangle mesh files: STL, OBJ, OFF, PLY, 3MF, AMF.

#include <burin/base/diagnostics.h>
#include <burin/base/placement.h>
#include <burin/base/run_context.h>
#include <burin/forms/mesh/texture_map.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// An object of a mesh file where it stands: a part. All but `object` and `place` are as those of
/// Part; without a name it has that of its object.
struct MeshUse {
  std::size_t object = 0;
  /// Any affine map.
  Placement place = {};
  std::string name = {};
  std::vector<std::string> assembly = {};
  std::string color = {};
  std::string definition = {};
  double opacity = 1;
};

/// A mesh file as it stands, before any repair: one soup a named object.
struct MeshFile {
  /// "STL (binary)", "STL (ASCII)", "OBJ", "OFF", "PLY (ASCII)", "PLY (binary)", "3MF", "AMF".
  std::string format;
  std::vector<PolygonSoup> objects;
  Diagnostics diagnostics;
  /// Where the objects stand, once or many times; empty: each once, as it is.
  std::vector<MeshUse> uses = {};
  /// One an object, by the numbers of its polygons, which have no colour where that says -1; absent
  /// where they look alike. Fewer: the rest look alike. They go before the colour of a use.
  std::vector<std::shared_ptr<const FaceColors>> polygon_colors = {};
};

/// The objects as they stand, one a use, for those who want triangles alone.
std::vector<PolygonSoup> placed_objects(MeshFile file);

/// Whether the suffix (any case) is one of this reader's.
bool is_mesh_suffix(const std::filesystem::path& path);
/// Whether a file of `size` bytes (0: unknown) that begins so can only be a mesh, whatever it is
/// called: what text says, or the size of a binary STL.
bool is_mesh_content(std::string_view head, std::uintmax_t size);

/// Reads a file without mending anything. The format follows from the content where that is clear,
/// else from the suffix. Throws InputError with the line (text formats) or the byte offset (binary
/// ones). Never allocates more than the bytes of the file can hold. Cost: 0.1 s per million
/// triangles of binary STL. `encoding`: of names, as iconv knows it; empty: it is found out.
MeshFile read_mesh_file(const std::filesystem::path& path, const RunContext& context,
                        const std::string& encoding = {});

/// u and v of a soup, or nothing where it has none. To be taken before `repair`.
std::shared_ptr<const TextureMap> texture_of(const PolygonSoup& soup, const RunContext& context);

/// Whether facets stay as they are, or become the round surfaces that they stand for.
enum class Facets { Kept, Recognised };

/// Repairs each object of a file once and makes a part of each of its uses, named by the file where
/// it has no name; parts that are turned, moved or scaled share one form. An object of which no
/// triangle is left becomes a diagnostic; throws InputError where that happens to all of them.
Scene repair_parts(MeshFile file, const std::filesystem::path& path, const RunContext& context,
                   Facets facets = Facets::Kept);

/// Reads and repairs. Diagnostics of both steps are in the scene's.
Scene read_mesh(const std::filesystem::path& path, const RunContext& context,
                Facets facets = Facets::Kept, const std::string& encoding = {});

/// The round surfaces that the facets of a mesh stand for (kernel/forms/recognised/README.md); what
/// was found becomes a diagnostic. The form itself where nothing was.
std::shared_ptr<const Form> recognised(std::shared_ptr<const Form> mesh, const std::string& name,
                                       Diagnostics& diagnostics, const RunContext& context);
/// The diagnostic "mesh.healed", where there are any.
void report_round_faces(const RecognisedFaces& faces, const std::string& name,
                        Diagnostics& diagnostics);

}  // namespace burin
