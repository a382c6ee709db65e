#include "import_file.h"

#include <burin/base/ascii.h>

namespace burin::csg {

std::filesystem::path file_of(const Evaluation& e, std::uint32_t node) {
  // An absolute name stays as it is.
  return e.folder / e.tree.nodes[node].text("file");
}

std::string suffix_of(const std::filesystem::path& path) {
  return lowered(path.extension().string());
}

}  // namespace burin::csg
