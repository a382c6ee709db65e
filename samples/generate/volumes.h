#pragma once
/// Sample volumes and the files they are written to.

#include "kit.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace burin::samples {

/// Samples of 16 bits, i fastest.
struct SampleVolume {
  std::array<std::int32_t, 3> size{};
  double spacing = 1;
  std::vector<std::uint16_t> samples;
  /// What a reader should know of them.
  std::string comment;
};

/// A run of pipe with two branches, hollow; all four ends are cut open by the sides of the data.
/// The surface is at 30000, larger values are inside. Few samples, which are meant as the
/// coefficients of a cubic spline (figure 13b of Elber's paper).
SampleVolume tube_joints();

/// A head as a scanner of medicine sees it: skull, nose, ears, eyes, a neck that the data cut off,
/// and grain. The surface is at 500 (figure 13a).
SampleVolume head();

/// NRRD with the samples inside, little-endian.
void write_nrrd(const SampleVolume& volume, const std::filesystem::path& path);

}  // namespace burin::samples
