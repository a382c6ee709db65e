#pragma once
/// The date in a PDF.

#include <string>

namespace burin {

/// The date that a build or a test asks for (SOURCE_DATE_EPOCH) in a form of strftime; empty, which
/// leaves dates out, without one.
std::string asked_date(const char* form);

}  // namespace burin
