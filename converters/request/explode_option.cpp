#include "explode_option.h"

#include <burin/base/error.h>
#include <burin/converters/values.h>
#include <burin/options/request.h>

namespace burin::detail {

void set_explode(Explode& explode, const std::string& spelled, const std::string& text) {
  explode.wanted = text != "none";
  explode.steps.clear();
  explode.along.reset();
  explode.one_way = false;
  if (text == "none" || text == "auto") return;
  const auto refuse = [&] {
    refuse_value(spelled, "auto, none, an axis x, y or z, one with a sign, or X,Y,Z", text);
  };
  if (text.find('=') != std::string::npos) refuse();
  try {
    const SectionPlane axis = cut_option(spelled, text);
    explode.along = axis.side < 0 ? -axis.axis : axis.axis;
    explode.one_way = axis.side != 0;
  } catch (const UsageError&) {
    refuse();
  }
}

}  // namespace burin::detail
