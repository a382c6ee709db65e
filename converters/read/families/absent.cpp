#include "absent.h"

#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/input_name.h>

#include "../readers.h"

#include <algorithm>
#include <vector>

namespace burin::detail {
namespace {

/// What the readers of Burin know, whether or not this one was built with them.
struct Known {
  std::string_view files, piece;
  std::vector<std::string_view> suffixes;
};

const std::vector<Known>& known() {
  static const std::vector<Known> rows{
      {"STEP, IGES and BREP files",
       kWithOcct,
       {".step", ".stp", ".p21", ".iges", ".igs", ".brep", ".brp"}},
      {"glTF files", "the reader gltf (BURIN_READERS)", {".gltf", ".glb"}},
      {"IRIT and Geomview files",
       "the reader irit (BURIN_READERS)",
       {".itd", ".irt", ".bez", ".bbp"}},
      {"functions", "the reader implicit (BURIN_READERS)", {".implicit"}},
      {"OpenSCAD files", kWithOpenscad, {".scad", ".csg"}},
      {"FreeCAD documents", "the reader fcstd (BURIN_READERS)", {".fcstd"}},
      {"volumes",
       "the reader volume (BURIN_READERS)",
       {".nrrd", ".nhdr", ".mha", ".mhd", ".inr", ".nii", ".hdr", ".img", ".vti", ".raw"}}};
  return rows;
}

}  // namespace

std::string needed_for(const std::filesystem::path& path) {
  const std::string suffix = model_suffix(path);
  // A reader that is there has refused the file for another reason: it is packed.
  const auto knows = [plain = "x" + suffix](const Reader* r) { return r->knows_suffix(plain); };
  if (std::ranges::any_of(own_readers(), knows)) return {};
  for (const Known& row : known()) {
    if (std::ranges::find(row.suffixes, suffix) != row.suffixes.end()) {
      return needs(row.files, row.piece);
    }
  }
  return {};
}

}  // namespace burin::detail
