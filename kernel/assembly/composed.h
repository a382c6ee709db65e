#pragma once
// Letters with accents, which Unicode writes in two ways; internal to the module.

#include <string>
#include <string_view>

namespace burin::detail {

/// UTF-8 with each accent in its letter (NFC), whether it stood there or behind it, as file systems
/// and programs of macOS write it (NFD). What is no UTF-8 stays as it is.
std::string composed(std::string_view text);

}  // namespace burin::detail
