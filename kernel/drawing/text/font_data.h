#pragma once
/// The file osifont.ttf, as the build found it.

#include <span>

namespace burin {

std::span<const unsigned char> font_data();

}  // namespace burin
