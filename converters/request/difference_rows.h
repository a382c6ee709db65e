#pragma once
// Differences in words; internal to the module.

#include <burin/converters/diff.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin::detail {

std::vector<DifferenceRow> rows_of(const Difference& difference);
std::vector<DifferenceRow> rows_of(const LineDifference& difference);
/// "14 parts, 13 before: 12 same, 1 added"
std::string counts_of(const Difference& difference, std::size_t before, std::size_t after);
std::string counts_of(const LineDifference& difference);

}  // namespace burin::detail
