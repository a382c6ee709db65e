// In the place of all that loads plug-ins, where Burin was built without (BURIN_PLUGINS).

#include <burin/plugin/plugins.h>

#include "../added.h"

namespace burin::plugin {

bool are_loaded() { return false; }
void reserve(Reserved /*is_reserved*/) {}
std::vector<std::filesystem::path> search_path() { return {}; }
void load_all(bool /*again*/) {}
std::vector<Plugin> plugins() { return added(); }
std::string probe(const std::filesystem::path& /*file*/, double /*timeout*/) {
  return "plug-ins need Burin with BURIN_PLUGINS";
}
Plugin load(const std::filesystem::path& file) {
  return {.file = file.string(), .refused = probe(file)};
}

}  // namespace burin::plugin
