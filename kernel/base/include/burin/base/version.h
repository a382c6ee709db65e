#pragma once

namespace burin {

/// The version of the library, e.g. "0.2.0".
const char* version();

}  // namespace burin
