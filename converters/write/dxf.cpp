#include "dxf.h"

#include <burin/base/error.h>

namespace burin {

void write_dxf(const Drawing&, const WriteOptions&, std::ostream&, const RunContext&) {
  throw Error("DXF cannot be written yet; write SVG or PDF");
}

}  // namespace burin
