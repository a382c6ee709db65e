#include <burin/surface/pmi.h>

namespace burin {

const char* to_string(PmiKind kind) {
  switch (kind) {
    case PmiKind::Dimension:
      return "dimension";
    case PmiKind::Tolerance:
      return "tolerance";
    case PmiKind::Datum:
      return "datum";
    case PmiKind::DatumTarget:
      return "datum_target";
    case PmiKind::Note:
      return "note";
    case PmiKind::Other:
      break;
  }
  return "other";
}

}  // namespace burin
