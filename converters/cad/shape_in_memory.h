#pragma once
/// Shapes that lie in memory: members of other programs' documents.

#include <burin/converters/cad_reader.h>

namespace burin {

/// As `read_brep_shape`.
std::shared_ptr<const BrepShape> read_shape_in_memory(const std::string& bytes, BrepBytes kind,
                                                      RunContext& context);

/// As `read_brep_text`.
std::shared_ptr<const BrepShape> read_text_in_memory(const std::string& brep, RunContext& context);

}  // namespace burin
