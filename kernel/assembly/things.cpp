#include <burin/assembly/things.h>

namespace burin {

std::vector<std::size_t> things_of(const Scene& scene) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    first.push_back(i > 0 && scene.parts[i].joined ? first.back() : i);
  }
  return first;
}

std::size_t end_of_thing(const Scene& scene, std::size_t index) {
  std::size_t end = index + 1;
  while (end < scene.parts.size() && scene.parts[end].joined) ++end;
  return end;
}

}  // namespace burin
