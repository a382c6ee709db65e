#pragma once
// What a document keeps of its window; internal to the module.

#include "document.h"
#include "xml.h"

#include <functional>

namespace burin::detail {

/// Takes visibility, colour and transparency of one view provider; `list` gives the bytes of a
/// member of the archive, empty where there is none.
void apply_view(const pugi::xml_node& provider,
                const std::function<std::string(const std::string&)>& list, FcObject& object);

}  // namespace burin::detail
