#pragma once
// How each part is drawn; internal to the module.

#include <burin/illustrate/illustrate.h>

#include <memory>
#include <vector>

namespace burin::detail {

/// The looks of all parts of a scene. Options and style must outlive it.
class PartStyles {
 public:
  PartStyles(std::size_t parts, const Style& style, const IllustrateOptions& options);

  std::size_t size() const { return parts_.size(); }
  const Style& style(std::size_t part) const { return *styles_[parts_[part].style]; }
  bool drawn(std::size_t part) const { return parts_[part].drawn; }
  bool transparent(std::size_t part) const { return parts_[part].transparent; }
  bool hatched(std::size_t part) const { return parts_[part].hatched; }
  bool any_transparent() const;

  /// Styles that differ, in the order of the parts that bring them; the first is the drawing's.
  const std::vector<const Style*>& styles() const { return styles_; }
  /// The solid parts whose strokes follow a style: one flag a part.
  std::vector<bool> hatched_by(std::size_t style) const;

 private:
  struct One {
    bool drawn = true, hatched = true, transparent = false;
    std::size_t style = 0;
  };
  std::vector<One> parts_;
  std::vector<const Style*> styles_;
};

}  // namespace burin::detail
