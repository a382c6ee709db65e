#pragma once
/// Letters that name details and sections.

#include <span>
#include <string>

namespace burin {

/// The first of A, B, C ... that is not taken, without I, O and Q (ISO 128-3); Z where all are.
std::string next_letter(std::span<const std::string> taken);

}  // namespace burin
