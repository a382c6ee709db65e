#pragma once
/// HPGL, the language of pen plotters.

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// IN, SP, VS, PU and PD with whole units of 0.025 mm, zero at the lower left corner of the sheet,
/// y up: what HP-GL plotters, HP-GL/2 and most programs read. Lines stand in the order of
/// `plan_pens`. Throws UsageError on a text of pens that says nothing, Cancelled.
void write_hpgl(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context);

}  // namespace burin
