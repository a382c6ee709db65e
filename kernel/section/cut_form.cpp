#include <burin/base/affine.h>
#include <burin/base/box_corners.h>
#include <burin/section/section.h>
#include <burin/surface/empty_surface.h>

#include "cut_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// What is left of a box before a plane, as the corners of a polyhedron.
void cut_box(const Box3& box, const CutPlane& plane, std::vector<Vec3>& left) {
  const std::array<Vec3, 8> corners = corners_of(box);
  const auto beyond = [&](std::size_t i) {
    return glm::dot(plane.normal, corners[i]) - plane.offset;
  };
  for (std::size_t i = 0; i < 8; ++i) {
    const double a = beyond(i);
    if (a <= 0) left.push_back(corners[i]);
    for (const std::size_t axis : {1U, 2U, 4U}) {
      const std::size_t j = i | axis;
      if (j == i) continue;
      const double b = beyond(j);
      if ((a > 0) != (b > 0)) left.push_back(glm::mix(corners[i], corners[j], a / (a - b)));
    }
  }
}

class CutForm final : public Form {
 public:
  CutForm(std::shared_ptr<const Form> form, CutRegion region, std::int32_t number, std::string name)
      : form_(std::move(form)),
        region_(std::move(region)),
        number_(number),
        name_(std::move(name)) {}

  /// As tight as the box that the form has along its own axes.
  Box3 bounds(const Mat3& axes) const override {
    // What lies before any of the planes is left.
    std::vector<Vec3> left;
    for (const CutPlane& plane : region_) cut_box(form_->bounds(Mat3(1)), plane, left);
    const Box3 whole = form_->bounds(axes);
    if (left.empty()) return {};
    Box3 box;
    for (const Vec3& p : left) box.add(axes * p);
    return {glm::max(box.min, whole.min), glm::min(box.max, whole.max)};
  }

  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override {
    auto whole = form_->realise(options, context);
    context.begin_stage(RunStage::Build);
    detail::CutProxy cut = detail::cut_proxy(*whole, region_, number_, context);
    context.end_stage();
    if (cut.whole) return whole;
    if (cut.gone) return empty_surface();
    if (cut.open && options.diagnostics) {
      options.diagnostics->add(
          Severity::Warning, "section.open", 1,
          fmt::format("{}: its surface has holes where it is cut, so that the cut is not closed",
                      name_));
    }
    return std::make_shared<detail::CutSurface>(std::move(whole), std::move(cut), region_);
  }
  std::shared_ptr<const Form> mapped(const Placement& by) const override {
    auto form = form_->mapped(by);
    if (!form) return nullptr;
    CutRegion region;
    for (const CutPlane& plane : region_) {
      const Vec3 normal = placed_normal(by, plane.normal);
      region.push_back({normal, glm::dot(normal, by.point(plane.offset * plane.normal))});
    }
    return std::make_shared<CutForm>(std::move(form), std::move(region), number_, name_);
  }
  bool looks_at_view() const override { return form_->looks_at_view(); }
  bool same_as(const Form& other) const override {
    const auto* cut = dynamic_cast<const CutForm*>(&other);
    return cut && cut->region_ == region_ && cut->number_ == number_ && cut->name_ == name_ &&
           cut->form_->same_as(*form_);
  }

  /// Cut open it is still what it was.
  Definition definition() const override { return form_->definition(); }
  bool realised_beside_others() const override { return form_->realised_beside_others(); }
  ShapeMeasure measure(RunContext& context) const override { return form_->measure(context); }

 private:
  std::shared_ptr<const Form> form_;
  CutRegion region_;
  std::int32_t number_;
  std::string name_;
};

}  // namespace

std::shared_ptr<const Form> cut_form(std::shared_ptr<const Form> form, CutRegion region,
                                     std::int32_t number, std::string name) {
  return std::make_shared<CutForm>(std::move(form), std::move(region), number, std::move(name));
}

std::shared_ptr<const Form> cut_form(std::shared_ptr<const Form> form, const CutPlane& plane,
                                     std::int32_t number, std::string name) {
  return cut_form(std::move(form), CutRegion{plane}, number, std::move(name));
}

}  // namespace burin
