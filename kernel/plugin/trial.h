#pragma once
// A plug-in tried out: each factory made with its own values and asked about a few places.

#include <burin/plugin.h>

#include <string>

namespace burin::plugin {

/// What went wrong, one sentence; empty where nothing did. The table has no fault. Readers and
/// writers are not called: they may do as they like with files. A crash or a loop that never ends
/// is one of this process.
std::string tried(const burin_plugin_table& table);

}  // namespace burin::plugin
