#pragma once
/// Compares drawings as text: numbers within a tolerance, everything else exactly.

#include <optional>
#include <string>
#include <string_view>

namespace burin::golden {

/// The drawing file without what may differ between two runs of the same program (paths of folders,
/// the program's version), one path a line, numbers rounded to a thousandth.
std::string canonical(const std::string& drawing_json);

/// The first difference in words ("line 12: 3.50 instead of 3.10"), or nothing where the texts
/// agree. Numbers with a decimal point may differ by `tolerance` (paper mm); whole numbers (ids,
/// counts) and all other text may not.
std::optional<std::string> difference(std::string_view expected, std::string_view actual,
                                      double tolerance);

}  // namespace burin::golden
