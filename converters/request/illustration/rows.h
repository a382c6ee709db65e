#pragma once
// The keys of illustration files: they are read, written and described by these rows; internal to
// the module.

#include "key_row.h"

#include <vector>

namespace burin::detail {

/// Those about what the file is have no reader: they are looked at before all others, or by nobody.
const std::vector<KeyRow<IllustrationFile>>& rows_of_file();

}  // namespace burin::detail
