#pragma once
// Members of drawing files; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

namespace burin::detail {

/// Decimals of model mm that hold a millionth of a paper mm in the largest view.
int model_decimals(const Drawing& drawing);

void append_json_vec(Buffer& out, Vec3 v);
void append_json_view(Buffer& out, const DrawingView& view);
/// What rays found, as the member `verify` behind another one.
void append_json_verification(Buffer& out, const Verification& v);

}  // namespace burin::detail
