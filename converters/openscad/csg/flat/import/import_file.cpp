#include "import_file.h"

#include <burin/base/ascii.h>

namespace burin::csg {

std::filesystem::path file_of(const Evaluation& e, std::uint32_t node) {
  // An absolute name stays as it is.
  return e.folder / unescaped(e.tree.nodes[node].text("file"));
}

std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped = text[i] == '\\' && i + 1 < text.size();
    const char c = text[escaped ? ++i : i];
    out += !escaped ? c : c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
  }
  return out;
}

std::string suffix_of(const std::filesystem::path& path) {
  return lowered(path.extension().string());
}

}  // namespace burin::csg
