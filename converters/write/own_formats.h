#pragma once
// The rows of the table of formats: each writer ends with its own. CMake compiles those of
// BURIN_WRITERS and lists them in own_formats.cpp.

#include <burin/converters/write.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

Format svg_format();
Format pdf_format();
Format eps_format();
Format png_format();
Format dxf_format();
Format hpgl_format();
Format gcode_format();
Format json_format();
Format html_format();

/// Those that Burin was built with.
std::vector<Format> own_formats();

/// "PDF files need Burin with cairo (BURIN_PICTURES)": of a format that it was built without; else
/// empty.
std::string needed_to_write(std::string_view format);

}  // namespace burin::detail
