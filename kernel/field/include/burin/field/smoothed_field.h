#pragma once
/// The smoothed cross field as an object: what field::smoothed wraps, for tests and pictures.

#include <burin/field/field.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace burin::field {

/// A triangle around which a cross field turns by a multiple of a quarter turn, in quarters.
struct Singularity {
  std::uint32_t face = 0;
  int index = 0;
};

/// A smoothed 4-symmetric cross field on the proxies of surfaces, which must outlive it. Immutable.
/// Cost: 0.8 s per million triangles to build on 2 cores, 0.3 us per query. @cite Knoeppel2013
class SmoothedField {
 public:
  SmoothedField(const std::vector<const Surface*>& surfaces, const SmoothedOptions& options,
                const RunContext& context);
  ~SmoothedField();
  SmoothedField(const SmoothedField&) = delete;
  SmoothedField& operator=(const SmoothedField&) = delete;

  /// The cross at a point; its certainty is 2 on flat parts, which have one cross each, elsewhere
  /// the frame's confidence. Nothing where the field is singular.
  std::optional<Cross> cross(const FieldQuery& query) const;

  /// The curved triangles of a part around which the crosses turn. On a closed, curved surface the
  /// indices add up to four times the Euler characteristic.
  std::vector<Singularity> singularities(std::int32_t part) const;
  /// For each triangle of the part's proxy the flat part that it belongs to; -1 = curved.
  const std::vector<std::int32_t>& flat_patches(std::int32_t part) const;

 private:
  struct Part;
  std::vector<std::unique_ptr<const Part>> parts_;
};

}  // namespace burin::field
