#pragma once
// Strokes that were asked for and have no direction to follow; internal to the module.

#include <burin/illustrate/illustrate.h>

#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// Looks where ink is wanted and the field says nothing.
class MissingDirections {
 public:
  /// `scene` must outlive it.
  explicit MissingDirections(const Scene& scene) : scene_(scene) {}

  /// What a field leaves out.
  struct Found {
    std::string field;
    /// Parts without any direction, and those with few; their numbers in the scene.
    std::vector<std::size_t> none, some;

    bool operator==(const Found&) const = default;
  };

  /// Asks the field where parts with such strokes are seen and want ink: at most some ten thousand
  /// places of the picture. Nothing where all is well.
  static std::optional<Found> look(const HatchScene& hatched, const Field& field, const Tone& tone,
                                   const HatchStyle& hatch);
  /// Each once.
  void add(const Found& found);
  /// One diagnostic "strokes.no_direction" for each field that left something out.
  void report(Diagnostics& diagnostics) const;

 private:
  std::string names(const std::vector<std::size_t>& parts) const;

  const Scene& scene_;
  std::vector<Found> found_;
};

}  // namespace burin::detail
