#pragma once
/// Plug-ins for programs that read and write files, too.

namespace burin {

/// `plugin::load_all`, which then also knows the suffixes that our own readers and writers have and
/// the names of the groups of style keys: no plug-in takes one of them. Never throws.
void load_plugins(bool again = false);

}  // namespace burin
