#include <burin/base/error.h>
#include <burin/forms/brep/occt/brep_model.h>

#include "contain.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <fmt/format.h>

#include <sstream>

namespace burin {
namespace {

/// OCCT's binary form begins with "\nOpen CASCADE Topology V..."; its text with
/// "DBRep_DrawableShape" or "CASCADE Topology V".
bool is_binary(const std::string& text) {
  const std::string head = text.substr(0, 64);
  return head.find("Open CASCADE Topology") != std::string::npos;
}

}  // namespace

std::shared_ptr<const BrepModel> brep_from_text(const std::string& text) {
  TopoDS_Shape shape;
  std::string failure;
  try {
    std::istringstream in(text);
    // OCCT's readers loop for ever where a number is missing; an exception ends them.
    in.exceptions(std::ios::failbit | std::ios::badbit);
    failure = contained([&] {
      if (is_binary(text)) {
        BinTools::Read(shape, in);
      } else {
        BRepTools::Read(shape, in, BRep_Builder());
      }
    });
  } catch (const std::ios_base::failure&) {
    throw InputError("a BREP file that is broken or ends early; export the model again");
  }
  if (!failure.empty()) throw InputError(fmt::format("not a BREP file (OCCT: {})", failure));
  if (shape.IsNull()) throw InputError("not a BREP file, or one that holds no shape");
  return make_brep_model(shape);
}

}  // namespace burin
