#pragma once
/// G-code for pen plotters and lasers.

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// Millimetres (G21), absolute places (G90), G0 with the pen up, G1 with it down, in the order of
/// `plan_pens`; what puts the pen down, lifts and changes it by the options. A comment tells sheet,
/// pens and lengths. Throws UsageError on texts that cannot be commands, Cancelled.
void write_gcode(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                 const RunContext& context);

}  // namespace burin
