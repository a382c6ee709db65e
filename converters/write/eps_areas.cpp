#include "eps_areas.h"

#include <burin/base/box.h>
#include <burin/drawing/areas_at.h>
#include <burin/drawing/ink.h>

#include "eps_pen.h"

#include <algorithm>
#include <set>

namespace burin {
namespace {

// Paper mm between places at which it is looked what lies beneath.
constexpr double kStep = 0.25;
constexpr std::size_t kMostThrough = 3;

void append_rings(Buffer& out, const Area& area) {
  EpsPen pen(out);
  for (const std::vector<Vec2>& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) i == 0 ? pen.move(ring[i]) : pen.line(ring[i]);
    append(out, "h\n");
  }
}

}  // namespace

EpsAreas::EpsAreas(const Drawing& drawing)
    : drawing_(drawing), areas_(painted_areas(drawing)), beneath_(areas_.size()) {
  if (std::ranges::any_of(areas_, [](const Area* area) { return area->opacity < 1; })) {
    find_beneath();
  }
}

void EpsAreas::find_beneath() {
  std::vector<Area> all;
  Box2 box;
  for (const Area* area : areas_) {
    all.push_back(*area);
    for (const std::vector<Vec2>& ring : area->rings) {
      for (const Vec2& p : ring) box.add(p);
    }
  }
  box = {glm::max(box.min, Vec2(0)),
         glm::min(box.max, Vec2(drawing_.paper_width, drawing_.paper_height))};
  const AreasAt at(all, kStep);
  std::vector<std::set<std::size_t>> beneath(areas_.size());
  for (double y = box.min.y + kStep / 2; y < box.max.y; y += kStep) {
    for (double x = box.min.x + kStep / 2; x < box.max.x; x += kStep) {
      const std::vector<std::size_t> here = at.at({x, y});
      for (std::size_t i = 1; i < here.size(); ++i) {
        if (areas_[here[i]]->opacity < 1)
          beneath[here[i]].insert(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  for (std::size_t i = 0; i < beneath.size(); ++i) {
    beneath_[i].assign(beneath[i].begin(), beneath[i].end());
  }
}

std::string EpsAreas::color(std::size_t area, const std::vector<std::size_t>& through) const {
  Rgb color = rgb_of(drawing_.paper_color).value_or(Rgb{});
  const auto lay = [&](std::size_t one) {
    color = over(rgb_of(areas_[one]->fill).value_or(Rgb{}), areas_[one]->opacity, color);
  };
  lay(area);
  for (const std::size_t one : through) lay(one);
  return to_text(color);
}

void EpsAreas::append(Buffer& out, std::size_t area,
                      const std::vector<std::size_t>& through) const {
  const Area& one = *areas_[area];
  append_rings(out, one);
  if (one.opacity >= 1) {
    fmt::format_to(fmt::appender(out), "gsave eofill grestore {} w s\n",
                   std::llround(kTrap * kUnitsPerMm));
    return;
  }
  if (beneath_[area].empty() || through.size() >= kMostThrough)
    return burin::append(out, "eofill\n");
  burin::append(out, "gsave gsave eofill grestore eoclip newpath\n");
  std::vector<std::size_t> more{area};
  more.insert(more.end(), through.begin(), through.end());
  for (const std::size_t k : beneath_[area]) {
    burin::append(out, eps_color(color(k, more)) + "\n");
    append(out, k, more);
  }
  // The path comes back, too.
  burin::append(out, "grestore newpath\n");
}

}  // namespace burin
