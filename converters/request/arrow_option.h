#pragma once
// What arrows take as text; internal to the module.

#include <burin/arrange/illustration.h>

#include "draw_options.h"

#include <string>
#include <vector>

namespace burin::detail {

/// "NAME=X,Y,Z". Throws UsageError.
ArrowRow arrow_option(const std::string& spelled, const std::string& text);

std::vector<RequestRow<Draft>> arrow_rows();

}  // namespace burin::detail
