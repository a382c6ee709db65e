#include <burin/base/error.h>
#include <burin/converters/pictures.h>

#include "svg_file.h"

#include <iterator>

namespace burin {

std::string read_svg_lines(const std::filesystem::path& path) {
  const SvgFile file(path);
  std::vector<Subpath> lines;
  file.walk({}, [&](const pugi::xml_node& node, const SvgTransform& transform) {
    std::ranges::move(file.lines(node, transform), std::back_inserter(lines));
  });
  if (lines.empty()) {
    throw InputError(
        "the file has no lines: paths, polygons, circles ...; texts have to be "
        "turned into paths",
        file.name());
  }
  return to_path_data(lines);
}

}  // namespace burin
