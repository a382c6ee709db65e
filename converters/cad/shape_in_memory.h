#pragma once
/// Shapes that lie in memory: members of other programs' documents.

#include <burin/converters/cad_reader.h>
#include <burin/converters/trimmed_faces.h>

namespace burin {

/// As `read_brep_shape`.
std::shared_ptr<const BrepShape> read_shape_in_memory(const std::string& bytes, BrepBytes kind,
                                                      RunContext& context);

/// As `read_brep_text`.
std::shared_ptr<const BrepShape> read_text_in_memory(const std::string& brep, RunContext& context);

/// As `make_trimmed_faces`.
std::shared_ptr<const BrepShape> trimmed_faces_in_memory(
    const std::vector<TrimmedSurface>& surfaces, double weld, const std::string& file,
    const RunContext& context);

}  // namespace burin
