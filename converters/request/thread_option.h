#pragma once
// What threads take as text; internal to the module.

#include <burin/arrange/illustration.h>

#include "draw_options.h"

#include <string>
#include <vector>

namespace burin::detail {

/// "NAME=SIZE". Throws UsageError.
ThreadRow thread_option(const std::string& spelled, const std::string& text);

std::vector<RequestRow<Draft>> thread_rows();

}  // namespace burin::detail
