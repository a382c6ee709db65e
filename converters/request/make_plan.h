#pragma once
// Pieces of which plans are made; internal to the module.

#include <burin/converters/read_result.h>
#include <burin/converters/request.h>
#include <burin/illustrate/unused_keys.h>

#include "style_files.h"

#include <vector>

namespace burin::detail {

/// As `make_plan`, of a scene whose parts have styles. Lights that are asked for shine on them too.
DrawPlan plan_of(const DrawRequest& request, const std::vector<PartStyle>& part_styles,
                 Spelling spelling);

/// With its style, whose pictures are read, in the light that is asked for. Throws UsageError that
/// names the look.
Look look_of(const LookRequest& asked, const DrawRequest& request, DrawPlan& plan);

/// What is asked for beside what the style that was named has.
std::vector<AskedKey> asked_keys(const DrawRequest& request, const Style& named,
                                 const DrawPlan& plan);

/// The keys of a text that starts from `start`, but for those that other options changed in the
/// style as it is used.
WrittenKeys written_in(const LoadedStyle& read, const Style& start, const Style& used);

/// Keys that are asked for and change nothing of the drawing whose parts are arranged.
Diagnostics unused_keys(const DrawPlan& plan, const KeySurroundings& around);

/// What options ask that has no effect on what the plan draws, whatever its style and models
/// are.
Diagnostics unused_choices(const Request& options, const DrawPlan& plan);

/// Adds what marks in models ask, where the request asks nothing else. Throws UsageError that names
/// the model.
void follow_marks(const std::vector<ModelMarks>& marks, const DrawRequest& request, DrawPlan& plan);

}  // namespace burin::detail
