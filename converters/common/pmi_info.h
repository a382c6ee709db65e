#pragma once
/// What `burin info` and the Python module tell of dimensions, tolerances, datums and notes.

#include <burin/surface/pmi.h>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace burin {

/// How many of each kind there are, and the views that the file names; then one line an item: its
/// kind, its text, its faces, and whether the file shows it. `part`: named in each line where it is
/// not empty.
std::vector<std::pair<std::string, std::string>> pmi_lines(const Pmi& pmi, const std::string& part);

nlohmann::ordered_json pmi_json(const Pmi& pmi);

}  // namespace burin
