#include "about.h"

#include <burin/base/version.h>

#include <fmt/format.h>

namespace burin::cli {

std::string version_text() {
  return fmt::format("burin {}\nbuilt with {}\n", version(), BURIN_LIBRARIES);
}

}  // namespace burin::cli
