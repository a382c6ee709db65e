#include "read.h"

#include <burin/converters/request.h>

#include "text.h"

namespace burin::python {

ReadOptions read_options(const py::object& bounds, const py::kwargs& options) {
  ReadRequest request;
  request.bounds = list_text("bounds", bounds);
  for (const auto& [key, value] : options) {
    const auto name = key.cast<std::string>();
    set_read_option(request, name, value_text(name.c_str(), value));
  }
  return make_read_options(request, Spelling::Keywords);
}

}  // namespace burin::python
