#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/session.h>

#include "stages.h"

namespace burin {

Session::Session() : stages_(std::make_unique<detail::Stages>()) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Drawing Session::draw(const Scene& scene, const Camera& camera, const Style& style,
                      const IllustrateOptions& options, RunContext& context) {
  return stages_->draw(scene, camera, style, options, true, context);
}

std::vector<std::size_t> Session::parts_before(std::span<const std::size_t> shown,
                                               const Camera& camera) const {
  return stages_->parts_before(shown, camera);
}

Box3 drawn_bounds(const Scene& scene, std::span<const PartStyle> part_styles, const Mat3& axes) {
  Box3 box;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (i < part_styles.size() && !part_styles[i].drawn) continue;
    box.add(scene.parts[i].form->bounds(axes));
  }
  return box.empty() ? scene.bounds(axes) : box;
}

std::vector<bool> drawn_parts(const Scene& scene, std::span<const PartStyle> part_styles) {
  std::vector<bool> drawn(scene.parts.size(), true);
  for (std::size_t i = 0; i < drawn.size() && i < part_styles.size(); ++i) {
    drawn[i] = part_styles[i].drawn;
  }
  return drawn;
}

Drawing illustrate(const Scene& scene, const Camera& camera, const Style& style,
                   const IllustrateOptions& options, RunContext& context) {
  return detail::Stages().draw(scene, camera, style, options, false, context);
}

}  // namespace burin
