#pragma once
// The title block of a sheet, as options have it; internal to the module.

#include <burin/converters/request.h>

#include <string>

namespace burin::detail {

struct Draft;

/// "iso", "none", or FILE.svg, a template. Throws UsageError, InputError.
void set_title_block(Draft& draft, const Asked& asked);

/// "NAME=TEXT", each a field of the block that there is. Throws UsageError that names its fields.
void set_title_block_fields(Draft& draft, const Asked& asked);

}  // namespace burin::detail
