#pragma once
// What the tone of a picture needs as a whole: one gamma for all of it, and faces that stand apart.

#include <burin/tone/options.h>

#include <cstdint>
#include <vector>

namespace burin::detail {

struct Picture;
struct ViewRaster;

/// Changes the ink that the tone of each place alone asks for.
class ToneBalance {
 public:
  /// What it does to a smooth region. Ink grows with the depth: what is near is darker.
  struct Shift {
    float ink = 0;
    float a_depth = 0;  // ink a model mm of depth
    float depth = 0;    // where it adds nothing
  };

  ToneBalance() = default;

  /// Of the ink in the cells of a raster, which is what the tone asks for. Planes are those regions
  /// whose visible part is flat. Cost: some 50 ns a cell.
  ToneBalance(const Picture& picture, const ViewRaster& raster, const tone::ToneOptions& options);

  /// The exponent of all ink; 1 = as the tone says.
  double gamma() const { return gamma_; }
  bool active() const { return gamma_ != 1 || !shifts_.empty(); }

  double ink(double asked, std::int32_t part, std::int32_t region, double depth) const;

 private:
  double gamma_ = 1;
  std::vector<std::vector<Shift>> shifts_;  // of each part, of each of its regions; or none
};

}  // namespace burin::detail
