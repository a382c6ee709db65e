#pragma once
/// Lines whose ends meet, one after the other. Internal to the module.

#include <burin/drawing/pen_order.h>

namespace burin {

/// The lines that are left when ends within `tolerance` of each other are joined, each in the order
/// of its first given line; nothing is known of their order of drawing. Polls `context`.
PenOrder join_lines(std::span<const PenPath> paths, double tolerance, const RunContext& context);

}  // namespace burin
