// In the place of the readers of pictures where Burin was built without (BURIN_PICTURES).

#include "absent.h"

#include <burin/base/error.h>
#include <burin/converters/pictures.h>

namespace burin {

std::string read_svg_lines(const std::filesystem::path& path) {
  throw InputError(needs("pictures that a style names", kWithPictures), path.string());
}

TitleBlockLayout read_title_block(const std::filesystem::path& path) {
  throw InputError(needs("templates of title blocks", kWithPictures), path.string());
}

Image read_png(const std::filesystem::path& path) {
  throw InputError(needs("pictures that a style names", kWithPictures), path.string());
}

}  // namespace burin
