#include <burin/base/error.h>
#include <burin/base/text_place.h>

namespace burin {

void fail_at(const std::string& file, TextPlace place, const std::string& what) {
  const std::string column =
      place.column > 0 ? "column " + std::to_string(place.column) + ": " : std::string();
  throw InputError(column + what, file, place.line);
}

}  // namespace burin
