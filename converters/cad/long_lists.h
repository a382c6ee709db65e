#pragma once
/// Lists of triangles in a STEP file, which nothing here draws, shortened before OCCT reads them.

#include <string>
#include <string_view>

namespace burin {

/// OCCT 7.6 takes time that grows with the square of the length of a list: 23,000 corners of the
/// triangles of a note took 4 s. Of the lists in coordinates and triangles of AP242, which OCCT
/// does not draw, the first entry stays; blanks take the place of the others, so that lines keep
/// their numbers. Returns the text so changed, an empty one where no list has over 1,000
/// characters. Linear in the text.
std::string without_triangle_lists(std::string_view text);

}  // namespace burin
