#pragma once
#include "parts.h"
#include "source.h"

#include <filesystem>

namespace burin::irit {

enum class Kind { Data, Geomview, List };

/// By content; the suffix decides for IRIT data that holds no object. Throws InputError where it is
/// none of these.
Kind kind_of(const Source& source, const std::filesystem::path& path);

Parts read_parts(const std::filesystem::path& path, const RunContext& context,
                 const IritReadOptions& options);

}  // namespace burin::irit
