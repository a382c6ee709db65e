// The formats that the kernel itself writes.

#include <burin/drawing/writers.h>

#include "own_formats.h"

namespace burin::detail {

Format svg_format() {
  return {"svg",
          {"svg.flatten", "svg.merge", "svg.order"},
          [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
            write_svg(d, o.svg, out, c);
          }};
}

Format json_format() {
  return {"json",
          {"json."},
          [](const Drawing& d, const WriteOptions& o, std::ostream& out, const RunContext& c) {
            write_json(d, values_in<JsonOptions>(o.formats), out, c);
          }};
}

}  // namespace burin::detail
