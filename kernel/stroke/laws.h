#pragma once
// The laws of strokes that a user writes as formulas; internal to the module.

#include <burin/expression/formula.h>
#include <burin/field/field.h>
#include <burin/stroke/stroke.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace burin::detail {

/// A place that a law is asked about.
struct LawPlace {
  std::int32_t part = 0;
  const SurfacePoint& point;
  const Frame& frame;
  /// The cosine to the viewer of the normal turned to it.
  double facing = 1;
  /// What these strokes are to cover of the paper.
  double ink = 0;
  /// Of the stroke, in [0,1), another one for each law.
  double random = 0.5;
  /// How far along the stroke the place lies, from 0 to 1.
  double along = 0;
};

/// One formula.
class Law {
 public:
  /// `plain`: the text that changes nothing; `known`: how many of the variables it may look at;
  /// `image`: what image(u, v) is.
  /// Throws UsageError that begins with the key.
  Law(const std::string& text, const std::string& plain, const std::string& key, std::size_t known,
      std::shared_ptr<const Image> image);

  /// Whether it changes nothing.
  bool plain() const { return plain_; }
  bool needs_parameters() const;
  bool needs_image() const;
  const std::string& key() const { return key_; }

  /// Its value; `otherwise` where it needs u and v and the surface has none. Throws UsageError
  /// where it is no finite number.
  double at(const LawPlace& place, const Surface& surface, const Field& field,
            double otherwise) const;

 private:
  std::string key_;
  bool plain_ = false;
  expression::Formula formula_;
  expression::Formula::Outside image_;
};

/// The laws that each have random numbers of their own.
constexpr std::uint64_t kWidthLaw = 1, kLengthLaw = 2, kPresenceLaw = 3;

/// The laws of one kind of strokes.
struct Laws {
  /// `group`: what keys begin with; `image`: the picture of the options, where it was read. Throws
  /// UsageError that names the key.
  Laws(const HatchOptions& options, const std::string& group,
       const std::shared_ptr<const Image>& image);

  Law ink, density, width, length, presence;

  /// Whether places of the picture, not strokes alone, follow a law.
  bool shape_picture() const { return !ink.plain() || !density.plain(); }
  bool need_parameters() const;

  /// The ink of a place after its laws, none where it is to have no strokes.
  double inked(const LawPlace& place, const Surface& surface, const Field& field) const;
  /// By what factor strokes stand closer there.
  double denser(const LawPlace& place, const Surface& surface, const Field& field) const;

  /// Of a stroke, for one of its laws, by its number.
  static double random(std::uint64_t seed, std::int32_t part, int family, std::uint64_t law,
                       std::size_t stroke);
};

}  // namespace burin::detail
