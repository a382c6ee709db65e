#pragma once
/// From what a file holds to parts.

#include <burin/converters/cad_reader.h>
#include <burin/converters/irit_reader.h>
#include <burin/converters/irit_tree.h>
#include <burin/surface/scene.h>

#include "source.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace burin::irit {

/// A scene, and for each of its parts the shape behind it where trimmed surfaces make it.
struct Parts {
  Scene scene;
  std::vector<std::shared_ptr<const BrepShape>> shapes;
};

/// Throws InputError where no surface is left.
Parts make_parts(IritObject root, const Source& source, const std::filesystem::path& path,
                 const IritReadOptions& options);

/// All patches as one part.
Parts make_part(std::vector<NurbsData> patches, const Source& source,
                const std::filesystem::path& path);

}  // namespace burin::irit
