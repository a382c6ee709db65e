#pragma once
/// Rows that are asked for by name.

#include <burin/base/error.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

template <class Row>
std::vector<std::string> names_of(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.emplace_back(row.name);
  return names;
}

/// The row of that name. Throws UsageError that lists them all: "unknown hatch.field 'x'; there are
/// ...", where `what` is "hatch.field".
template <class Row>
const Row& find_row(std::span<const Row> rows, std::string_view name, const std::string& what) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  if (found != rows.end()) return *found;
  std::string all;
  for (const Row& row : rows) all += (all.empty() ? "" : ", ") + std::string(row.name);
  throw UsageError("unknown " + what + " '" + std::string(name) + "'; there are " + all);
}

}  // namespace burin
