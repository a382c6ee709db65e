#pragma once
/// From what a file holds to parts.

#include <burin/converters/irit_reader.h>
#include <burin/converters/irit_tree.h>
#include <burin/surface/scene.h>

#include "source.h"

namespace burin::irit {

/// Throws InputError where no surface is left.
Scene make_parts(IritObject root, const Source& source, const std::filesystem::path& path,
                 const IritReadOptions& options);

/// All patches as one part.
Scene make_part(std::vector<NurbsData> patches, const Source& source,
                const std::filesystem::path& path);

}  // namespace burin::irit
