#pragma once
// What pages of HTML are put together from; internal to the module.

#include <burin/base/run_context.h>
#include <burin/converters/write.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/format_options.h>

#include <span>
#include <string>

namespace burin::html {

std::string escaped(const std::string& text);

/// The element of a drawing alone, without what a file of its own begins with.
std::string inline_svg(const Drawing& drawing, SvgOptions svg, const RunContext& context);

/// All before <main>.
std::string head(const std::string& title);

/// The end of <main>, the parts list beside it, and all that follows.
std::string list_and_tail(std::span<const DrawingItem> items, const HtmlOptions& options = {});

}  // namespace burin::html
