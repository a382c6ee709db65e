#pragma once
// How each part is drawn; internal to the module.

#include <burin/base/plugin_error.h>
#include <burin/drawing/color.h>
#include <burin/illustrate/illustrate.h>

#include <memory>
#include <span>
#include <vector>

namespace burin::detail {

/// One kind of strokes of a style and the parts that it stands on.
struct StrokeSet {
  const HatchStyle* hatch;
  const tone::ToneOptions* tone;
  /// From 1.
  int number = 1;
  /// Likewise one a part.
  std::vector<bool> parts{};
  /// What share of the bare paper the strokes leave: (1 - ink)^exponent, so that all kinds which
  /// share the tone of a part give it together; empty: 1.
  std::vector<double> exponents{};
};

/// The colour of the lines of parts in a style: its own, else the ink of the sheet, which the style
/// of the whole drawing has.
Rgb line_ink(const Style& style, const Style& whole);

/// The looks of all parts of a scene. Scene, options and style must outlive it.
class PartStyles {
 public:
  /// Throws UsageError where strokes are to stand on parts that there are not.
  PartStyles(const Scene& scene, const Style& style, const IllustrateOptions& options);

  std::size_t size() const { return parts_.size(); }
  const Style& style(std::size_t part) const { return *styles_[parts_[part].style]; }
  bool drawn(std::size_t part) const { return parts_[part].drawn; }
  bool transparent(std::size_t part) const { return parts_[part].transparent; }
  bool hatched(std::size_t part) const { return parts_[part].hatched; }
  bool any_transparent() const;
  /// One a part: the order in which parts stand out where they meet or lie on each other, the
  /// highest before the others. The more their lines show the higher, first those in which they
  /// meet; of equal ones a look of its own before that of the drawing, then solid before
  /// transparent, then small before large, so that what is let in flush is seen. Empty where all
  /// are alike. `sizes`: model mm^2, one a part.
  std::vector<double> meeting_ranks(std::span<const double> sizes) const;

  /// Styles that differ, in the order of the parts that bring them; the first is the drawing's.
  const std::vector<const Style*>& styles() const { return styles_; }
  /// All strokes that stand on any part, a style after the other.
  const std::vector<StrokeSet>& strokes() const { return strokes_; }

 private:
  struct One {
    bool drawn = true, hatched = true, transparent = false;
    std::size_t style = 0;
  };
  void find_strokes(const Scene& scene, bool one_tone);

  std::vector<One> parts_;
  std::vector<const Style*> styles_;
  std::vector<StrokeSet> strokes_;
};

/// Leaves out the parts that a form of a plug-in made which failed; how many.
std::size_t leave_out(const Scene& scene, const PluginError& failed, IllustrateOptions& options);

}  // namespace burin::detail
