#include <burin/assembly/things.h>

namespace burin {

std::vector<std::size_t> things_of(const Scene& scene) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    first.push_back(i > 0 && scene.parts[i].joined ? first.back() : i);
  }
  return first;
}

}  // namespace burin
