#include <burin/annotate/letters.h>
#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/drawing/views.h>
#include <burin/section/section.h>

#include "left_whole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

namespace burin {
namespace {

/// Sides of an opening around a place.
constexpr int kSides = 24;

/// A plane where it stands, and how far what is drawn reaches along its axis.
struct PlacedPlane {
  Vec3 axis{0};
  int side = 1;
  double offset = 0, low = 0, high = 0;

  CutPlane cut() const { return {static_cast<double>(side) * axis, side * offset}; }
  bool misses() const { return side > 0 ? offset >= high : offset <= low; }
  bool takes_all() const { return side > 0 ? offset <= low : offset >= high; }
};

class SectionRegions {
 public:
  SectionRegions(const Scene& scene, const Illustration& illustration, const Section& section)
      : scene_(scene), illustration_(illustration), section_(section) {
    for (const SectionPlane& text : section.planes) planes_.push_back(placed_plane(text));
  }

  /// What goes, one after the other; none where the section misses.
  std::vector<CutRegion> find() {
    if (section_.around) return around(*section_.around);
    return section_.steps ? steps(planes_) : region(planes_);
  }
  /// How it misses.
  const std::string& missed() const { return missed_; }
  /// Where it cuts, of one that has a view of its own. Throws UsageError where that is no plane and
  /// no steps.
  SectionView view() const {
    if (section_.around || (section_.planes.size() > 1 && !section_.steps)) {
      throw UsageError(section_.place +
                       "a section with a view of its own is cut by one plane or in steps");
    }
    const PlacedPlane& first = planes_.front();
    SectionView view;
    view.direction = static_cast<double>(first.side) * first.axis;
    view.axis = first.axis;
    view.place = section_.place;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const PlacedPlane& plane = planes_[i];
      const bool inside = plane.offset > plane.low && plane.offset < plane.high;
      if (section_.steps && !inside) {
        throw UsageError(says(plane) + ": each step of a section view lies within the model");
      }
      (i % 2 == 0 ? view.faces : view.ends).push_back(plane.offset);
      if (i == 1) view.across = plane.axis;
    }
    return view;
  }

 private:
  PlacedPlane placed_plane(const SectionPlane& text) const {
    constexpr double kAcross = 1e-6;  // radians
    double to_viewer = glm::dot(text.axis, glm::normalize(illustration_.view.direction));
    // A view of its own looks at the plane, and so as most views do where that of the sheet does
    // not.
    if (section_.own_view && std::abs(to_viewer) < kAcross)
      to_viewer = glm::dot(text.axis, named_view("iso").direction);
    PlacedPlane plane = along(text.axis);
    plane.offset = text.offset.value_or(0.5 * (plane.low + plane.high));
    plane.side = text.side != 0 ? text.side : to_viewer >= 0 ? 1 : -1;
    return plane;
  }

  PlacedPlane along(Vec3 axis) const {
    Mat3 across(0);  // its first row is the axis
    for (int k = 0; k < 3; ++k) across[k][0] = axis[k];
    const Box3 box = drawn_bounds(scene_, illustration_.illustrate.part_styles, across);
    return {.axis = axis, .low = box.min.x, .high = box.max.x};
  }

  std::string says(const PlacedPlane& plane) const {
    return fmt::format("{}the section at {:.6g} mm, of a model from {:.6g} to {:.6g} mm",
                       section_.place, plane.offset, plane.low, plane.high);
  }

  bool misses(const PlacedPlane& plane) {
    if (plane.misses()) missed_ = says(plane) + ", cuts nothing";
    return plane.misses();
  }

  std::vector<CutRegion> region(const std::vector<PlacedPlane>& planes) {
    if (std::ranges::all_of(planes, &PlacedPlane::takes_all)) {
      throw UsageError(says(planes.front()) + ", takes all of it away");
    }
    CutRegion region;
    for (const PlacedPlane& plane : planes) {
      if (misses(plane)) return {};
      region.push_back(plane.cut());
    }
    return {region};
  }

  /// Each cut from where the one before ends to where it ends itself.
  std::vector<CutRegion> steps(const std::vector<PlacedPlane>& planes) {
    const std::size_t ends = planes.size() / 2;
    const auto end = [&](std::size_t i) { return planes[2 * i + 1]; };
    const bool falls = ends > 1 && end(1).offset < end(0).offset;
    const auto beside = [&](std::size_t i, bool after) {
      PlacedPlane plane = end(i);
      plane.side = after != falls ? 1 : -1;
      return plane.cut();
    };
    std::vector<CutRegion> regions;
    bool all = true;
    for (std::size_t i = 0; i <= ends; ++i) {
      const PlacedPlane& face = planes[2 * i];
      all = all && face.takes_all();
      if (misses(face)) continue;
      CutRegion region{face.cut()};
      if (i > 0) region.push_back(beside(i - 1, true));
      if (i < ends) region.push_back(beside(i, false));
      regions.push_back(region);
    }
    if (all) throw UsageError(says(planes.front()) + ", takes all of it away");
    return regions;
  }

  /// From the viewer down to the place.
  std::vector<CutRegion> around(const Section::Around& around) {
    const Vec3 to_viewer = glm::normalize(illustration_.view.direction);
    PlacedPlane floor = along(to_viewer);
    floor.offset = glm::dot(to_viewer, around.center);
    if (misses(floor)) return {};
    CutRegion region{floor.cut()};
    const Vec3 u = any_orthogonal(to_viewer), v = glm::cross(to_viewer, u);
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      const Vec3 inwards = -std::cos(angle) * u - std::sin(angle) * v;
      region.push_back({inwards, glm::dot(inwards, around.center) - around.radius});
    }
    return {region};
  }

  const Scene& scene_;
  const Illustration& illustration_;
  const Section& section_;
  std::vector<PlacedPlane> planes_;
  std::string missed_;
};

bool is_drawn(const Illustration& illustration, std::size_t part) {
  const auto& styles = illustration.illustrate.part_styles;
  return part >= styles.size() || styles[part].drawn;
}

/// Whether a box may have something in a region.
bool reaches_into(const Box3& box, const CutRegion& region) {
  return std::ranges::all_of(region, [&](const CutPlane& plane) {
    const Vec3 n = plane.normal;
    const Vec3 far(n.x > 0 ? box.max.x : box.min.x, n.y > 0 ? box.max.y : box.min.y,
                   n.z > 0 ? box.max.z : box.min.z);
    return glm::dot(n, far) > plane.offset;
  });
}

bool any_reaches_into(const Scene& scene, const Illustration& illustration,
                      const std::vector<CutRegion>& regions) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (!is_drawn(illustration, i)) continue;
    const Box3 box = scene.parts[i].form->bounds(Mat3(1));
    const auto reached = [&](const CutRegion& region) { return reaches_into(box, region); };
    if (std::ranges::any_of(regions, reached)) return true;
  }
  return false;
}

/// The parts that stay whole because somebody says so.
std::vector<bool> uncut_parts(const Scene& scene, const Section& section,
                              const Illustration& illustration) {
  std::vector<bool> uncut(scene.parts.size(), false);
  for (const std::string& selector : illustration.uncut.value_or(std::vector<std::string>{})) {
    for (const std::size_t part : select(scene, selector)) uncut[part] = true;
  }
  try {
    for (const std::string& selector : section.exclude.value_or(std::vector<std::string>{})) {
      for (const std::size_t part : select(scene, selector)) uncut[part] = true;
    }
  } catch (const UsageError& e) {
    throw UsageError(section.place + e.what());
  }
  return uncut;
}

/// Where a part lies to a plane.
enum class Lies { Before, Beyond, Along, Across };

Lies lies(const Form& form, const CutPlane& plane) {
  constexpr double kLong = 1.5;  // times as long as wide: cut across its length
  const Vec3 u = any_orthogonal(plane.normal), v = glm::cross(plane.normal, u);
  Mat3 axes(0);
  for (int k = 0; k < 3; ++k) axes[k] = {plane.normal[k], u[k], v[k]};
  const Box3 box = form.bounds(axes);
  const Vec3 size = box.max - box.min;
  const double near = 1e-6 * size.x;
  if (box.max.x <= plane.offset + near) return Lies::Before;
  if (box.min.x >= plane.offset - near) return Lies::Beyond;
  return size.x > kLong * std::max(size.y, size.z) ? Lies::Across : Lies::Along;
}

/// Whether a region leaves a part whole that is not cut along by custom: one of its planes runs
/// along it. What lies in it goes; what is cut across only, as a shaft by a plane through which it
/// comes, is cut.
bool cuts_along(const CutRegion& region, const Form& form) {
  bool along = false;
  for (const CutPlane& plane : region) {
    const Lies where = lies(form, plane);
    if (where == Lies::Before) return false;
    along = along || where == Lies::Along;
  }
  return along;
}

/// Those that stay whole by custom, where that leaves something to cut.
class Custom {
 public:
  Custom(const Scene& scene, const Illustration& illustration)
      : scene_(scene),
        illustration_(illustration),
        words_(scene.parts.size()),
        reported_(scene.parts.size(), false) {
    bool any_cut = false;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      words_[i] = detail::left_whole_by_custom(scene.parts[i]);
      any_cut = any_cut || (is_drawn(illustration, i) && !words_[i]);
    }
    if (!any_cut) words_.assign(words_.size(), std::nullopt);
  }

  /// The parts that these regions leave whole.
  std::vector<bool> whole(const std::vector<CutRegion>& regions) {
    std::vector<bool> whole(words_.size(), false);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (!words_[i]) continue;
      const Form& form = *scene_.parts[i].form;
      whole[i] = std::ranges::any_of(
          regions, [&](const CutRegion& region) { return cuts_along(region, form); });
      reported_[i] = reported_[i] || (whole[i] && is_drawn(illustration_, i));
    }
    return whole;
  }

  void report(Diagnostics& out) const {
    constexpr std::size_t kMost = 8;
    std::int64_t count = 0;
    std::set<std::string> names;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!reported_[i]) continue;
      ++count;
      names.insert(*words_[i]);
    }
    if (count == 0) return;
    const bool more = names.size() > kMost;
    while (names.size() > kMost) names.erase(std::prev(names.end()));
    out.add(Severity::Info, "section.left_whole", count,
            fmt::format("{} {} whole, as drawings do not cut along them ({}{}); `section_exclude` "
                        "none cuts them too",
                        count, count == 1 ? "part stays" : "parts stay", fmt::join(names, ", "),
                        more ? ", ..." : ""));
  }

 private:
  const Scene& scene_;
  const Illustration& illustration_;
  std::vector<std::optional<std::string>> words_;
  std::vector<bool> reported_;
};

/// Cuts parts by sections, one after the other; each cut face has a number.
class Cutting {
 public:
  Cutting(const Illustration& illustration, Custom& custom)
      : illustration_(illustration), custom_(custom) {}

  /// Whether it cut anything.
  bool cut(Scene& scene, const Section& section, SectionRegions& places) {
    const std::vector<CutRegion> regions = places.find();
    if (regions.empty()) {
      scene.diagnostics.add(Severity::Warning, "section.missed", 1, places.missed());
      return false;
    }
    if (!any_reaches_into(scene, illustration_, regions)) {
      scene.diagnostics.add(Severity::Warning, "section.missed", 1,
                            section.place + "the section reaches into no part, cuts nothing");
      return false;
    }
    std::vector<bool> uncut = uncut_parts(scene, section, illustration_);
    if (!illustration_.uncut && !section.exclude) uncut = custom_.whole(regions);
    for (const CutRegion& region : regions) {
      for (std::size_t part = 0; part < scene.parts.size(); ++part) {
        Part& one = scene.parts[part];
        if (!uncut[part]) one.form = cut_form(one.form, region, number_, one.name);
      }
      number_ += static_cast<std::int32_t>(region.size());
    }
    return true;
  }

 private:
  const Illustration& illustration_;
  Custom& custom_;
  std::int32_t number_ = 0;
};

/// The letters that sections with views of their own have.
std::vector<std::string> section_letters(const Illustration& illustration) {
  std::vector<std::string> taken, letters;
  const auto take = [&](const std::string& letter, const std::string& place) {
    if (letter.empty()) return;
    if (std::ranges::find(taken, letter) != taken.end()) {
      throw UsageError(
          fmt::format("{}two places of the sheet have the letter '{}'", place, letter));
    }
    taken.push_back(letter);
  };
  for (const Section& section : illustration.sections) take(section.letter, section.place);
  for (const DetailView& detail : illustration.details) take(detail.letter, detail.place);
  for (const Section& section : illustration.sections) {
    if (!section.own_view) continue;
    letters.push_back(section.letter.empty() ? next_letter(taken) : section.letter);
    taken.push_back(letters.back());
  }
  return letters;
}

}  // namespace

void cut_parts(Scene& scene, Illustration& illustration) {
  constexpr std::size_t kMostSections = 16;
  if (illustration.sections.size() > kMostSections) {
    throw UsageError("more than 16 sections; each takes something away");
  }
  illustration.section_views.clear();
  if (illustration.sections.empty()) return;
  Custom custom(scene, illustration);
  Cutting all(illustration, custom);
  for (const Section& section : illustration.sections) {
    if (section.own_view) continue;
    SectionRegions places(scene, illustration, section);
    all.cut(scene, section, places);
  }
  const std::vector<std::string> letters = section_letters(illustration);
  std::size_t lettered = 0;
  for (const Section& section : illustration.sections) {
    if (!section.own_view) continue;
    SectionRegions places(scene, illustration, section);
    Scene own = scene;
    own.diagnostics = {};
    Cutting alone = all;
    SectionView view = places.view();
    view.letter = letters[lettered++];
    if (alone.cut(own, section, places)) {
      view.scene = std::make_shared<Scene>(std::move(own));
      illustration.section_views.push_back(std::move(view));
    } else {
      append_new(own.diagnostics, scene.diagnostics);
    }
  }
  custom.report(scene.diagnostics);
}

}  // namespace burin
