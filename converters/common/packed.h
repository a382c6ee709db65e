#pragma once
/// Files that gzip packed, which `Source` unpacks.

#include "source.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace burin {

/// A file as it is, packed or not, for who unpacks it piece by piece. Throws as `Source` does.
Source as_it_is(const std::filesystem::path& path, const RunContext& context);

/// The first `most` bytes of a file, unpacked, as far as they can be had; empty where it cannot be
/// read, of which its reader will say why. Waits for what is piped in.
std::string head_of(const std::filesystem::path& path, std::size_t most, const RunContext& context);

}  // namespace burin
