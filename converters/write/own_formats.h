#pragma once
// The table of formats. CMake makes it (own_formats.cpp) of BURIN_WRITERS: each writer ends with
// its row, `Format NAME_format()` in this namespace. What a user chooses of a format is a struct
// `NameOptions` in NAME_options.h; its rows are a part of styles in every build.

#include <burin/converters/write.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// Those that Burin was built with.
std::vector<Format> own_formats();

/// The names of all that it can be built with.
std::span<const std::string_view> known_formats();

/// "PDF files need Burin with cairo (BURIN_PICTURES)": of a format that it was built without; else
/// empty.
std::string needed_to_write(std::string_view format);

}  // namespace burin::detail
