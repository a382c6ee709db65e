#pragma once
// What programs bring themselves, without a file; internal to the module.

#include <burin/plugin/plugins.h>

#include <vector>

namespace burin::plugin {

/// All that was noted, by `note` and `note_refused`.
std::vector<Plugin> added();

}  // namespace burin::plugin
