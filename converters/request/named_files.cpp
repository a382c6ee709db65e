#include "named_files.h"

#include <burin/converters/pictures.h>

#include <string>

namespace burin::detail {
void find_named_files(Style& style, const std::filesystem::path& folder) {
  for_each_hatch(style, [&](HatchStyle& hatch) {
    if (hatch.motif_is_file()) hatch.motif = read_svg_lines(folder / hatch.motif);
    if (hatch.has_image()) {
      hatch.image = std::filesystem::absolute(folder / hatch.image).lexically_normal().string();
    }
  });
}

void read_images(const Style& style, Images& images) {
  for (std::size_t number = 1; number <= stroke_kind_count(style); ++number) {
    const HatchStyle& hatch = hatch_of(style, number);
    if (!hatch.enabled || !hatch.has_image() || images.contains(hatch.image)) continue;
    images[hatch.image] = std::make_shared<const Image>(read_png(hatch.image));
  }
}

}  // namespace burin::detail
