#pragma once
// What details take as text; internal to the module.

#include <burin/arrange/illustration.h>

#include <string>

namespace burin::detail {

/// "NAME", "X,Y,Z,R" and "=A:B" or "=S" behind either. Throws UsageError.
DetailView detail_option(const std::string& spelled, const std::string& text);

}  // namespace burin::detail
