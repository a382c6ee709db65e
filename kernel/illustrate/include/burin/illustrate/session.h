#pragma once
/// Drawings one after the other, each as fast as what has changed allows.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/drawing/drawing.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace burin {

namespace detail {
class Stages;
}

/// Keeps what the last drawing was made of: realised surfaces, curvature and the tree of rays as
/// long as forms, tolerance and, for exact forms, the view are the same; feature lines and what is
/// seen of them as long as the view is, too; strokes of each kind as long as their style, tone and
/// light are, and areas. Widths of lines, haloes and looks are made anew each time. A form is the
/// same where its pointer is. Draws the same, byte by byte, as `illustrate`. Strokes with a field
/// or a tone of the caller's own are not kept. Memory: that of one drawing, two in replacing it.
class Session {
 public:
  Session();
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// As `illustrate`. One drawing at a time. A drawing that was cancelled or failed loses nothing
  /// of what is kept but what it was about to replace.
  Drawing draw(const Scene& scene, const Camera& camera, const Style& style,
               const IllustrateOptions& options, RunContext& context);

  /// The parts, ascending, without which `camera` would see most of some parts of the last drawing,
  /// as few as will do; none where there was no drawing. Cost: 400 rays.
  std::vector<std::size_t> parts_before(std::span<const std::size_t> shown,
                                        const Camera& camera) const;

 private:
  std::unique_ptr<detail::Stages> stages_;
};

}  // namespace burin
