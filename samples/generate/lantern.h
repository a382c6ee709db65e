#pragma once
/// The sample of glTF.

#include <filesystem>

namespace burin::samples {

/// A lantern of base, roof, candle, glass and four posts; as `.glb`.
void write_lantern(const std::filesystem::path& path);

}  // namespace burin::samples
