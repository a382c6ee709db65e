#pragma once
/// Files that are often met under the name of a model.

#include <string_view>

namespace burin {

/// What a file is that begins so, and what to do, for an error; null where that is not known.
const char* foreign_file(std::string_view bytes);

}  // namespace burin
