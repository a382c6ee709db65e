#include "hidden.h"

#include <burin/base/box_corners.h>
#include <burin/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_set>

namespace burin {
namespace {

// Finest cubes along a cell of the grid, and along cubes of which samples tell what is there:
// components as large as two of those have one wholly inside.
constexpr int kFinest = 32, kSampled = 4;
// Sampled cubes of which nothing can be told that are divided further.
constexpr std::size_t kDoubtful = 4096;
// Cubes of one size, from a cell on, beyond which those that the grid's samples explain are passed
// over: walls as thin as a cell have so many.
constexpr std::size_t kMany = 20'000;
// Nanoseconds an operation: values over a box, slopes over it.
constexpr double kRange = 20, kSlope = 40;
// Samples of a straight way within a cell.
constexpr int kWay = 9;

bool inside(double v) { return v < 0; }  // what is not a number is outside

bool bounded(Interval r) { return std::abs(r.min) < 1e300 && std::abs(r.max) < 1e300; }

// Whether f never falls, or never rises: from any place inside a component a straight way then
// leads out of the box without leaving the component.
bool steady(Interval slope) { return slope.min >= 0 || slope.max <= 0; }

// A cube of finest cubes, with the part of the function that matters there; from a cell on that of
// the cell.
struct HiddenCube {
  Cell first{0};
  int side = 0;
  const ImplicitFunction* function = nullptr;
  std::shared_ptr<const ImplicitFunction> own;
};

enum class Finding : std::uint8_t { Nothing, Same, Open };  // Same: one sign, proved
enum class Answer : std::uint8_t { Explained, Hidden, Undecided };

// Whether f may be level somewhere in the box, and may be zero: by its slopes, which also tell how
// far it is from its value in the middle.
// `work`: the nanoseconds that it takes, an operation of the function.
Finding examine(const ImplicitFunction& f, const Box3& box, double& work) {
  work += work::kGradient * work::kOneValue;
  const Vec3 middle = box.center();
  const Gradient1 g = f.gradient(middle);
  const Vec3 size = box.size();
  // Where the tangent plane passes near the middle, so does the surface: no range needs to say so.
  constexpr double kPasses = 0.4;
  const double reached = kPasses * std::min({size.x, size.y, size.z}) * glm::length(g.gradient);
  if (!(std::abs(g.value) < reached)) {
    work += kRange;
    if (judge(f.range(box)) != Verdict::Unknown) return Finding::Same;
  }
  const Vec3 up = normalize_or(g.gradient, Vec3(0));
  const auto slope = [&](Vec3 along) {
    work += kSlope;
    return f.slope(box, along);
  };
  if (up != Vec3(0) && steady(slope(up))) return Finding::Nothing;
  Vec3 mean(0);
  double reach = 0;
  for (int a = 0; a < 3; ++a) {
    Vec3 along(0);
    along[a] = 1;
    const Interval s = slope(along);
    if (steady(s)) return Finding::Nothing;
    if (!bounded(s)) return Finding::Open;
    mean[a] = 0.5 * (s.min + s.max);
    reach += 0.5 * size[a] * std::max(std::abs(s.min), std::abs(s.max));
  }
  if (judge({g.value - reach, g.value + reach}) != Verdict::Unknown) return Finding::Same;
  // Where pieces meet at an angle, the mean of their gradients is up for both.
  mean = normalize_or(mean, Vec3(0));
  if (mean != Vec3(0) && steady(slope(mean))) return Finding::Nothing;
  return Finding::Open;
}

std::array<Vec3, 9> corners_and_middle(const Box3& box) {
  std::array<Vec3, 9> p;
  std::ranges::copy(corners_of(box), p.begin());
  p[8] = box.center();
  return p;
}

class Search {
 public:
  Search(const ImplicitFunction& f, const GridLayout& layout, const Box3& within,
         const std::vector<Vec3>& surface, const WorkBudget& budget, const RunContext& context)
      : f_(f),
        grid_(layout),
        fine_{layout.origin, layout.step / kFinest, layout.cells * kFinest},
        within_(within),
        surface_(surface),
        left_(budget.left()),
        context_(context) {}

  HiddenPlaces run() {
    HiddenCube root;
    root.function = &f_;
    const int longest = std::max({fine_.cells.x, fine_.cells.y, fine_.cells.z});
    for (root.side = kFinest; root.side < longest;) root.side *= 2;
    std::vector<HiddenCube> cubes{root};
    while (!cubes.empty()) cubes = next(cubes);
    return std::move(found_);
  }

 private:
  // Nanoseconds an operation: values at the corners and in the middle, and on ways to the corners
  // of the cell.
  static constexpr double kSamples = 60 * work::kValue;
  // What a cube takes at most.
  static constexpr double kExpected = kRange + 5 * kSlope;

  Box3 box_of(const HiddenCube& c) const {
    const Box3 b = fine_.box(c.first, c.first + c.side);
    return {glm::max(b.min, within_.min), glm::min(b.max, within_.max)};
  }
  Cell cell_of(const HiddenCube& c) const { return c.first / kFinest; }

  // What is left of the cubes of one size, divided.
  std::vector<HiddenCube> next(std::vector<HiddenCube>& cubes) {
    const int side = cubes.front().side;
    // Those that are not looked at before the budget ends stay open.
    std::vector<Finding> findings(cubes.size(), Finding::Open);
    const bool all = examine_all(cubes, findings);
    const bool hopeless = all && side > 1 && is_hopeless(cubes, findings);
    if (hopeless && side > kFinest) set_aside(cubes, findings);
    if (!all || (hopeless && (side <= kFinest || is_hopeless(cubes, findings)))) {
      leave(cubes, findings);
      return {};
    }
    std::vector<HiddenCube> parts;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (side > 1 && findings[i] == Finding::Open) divide(cubes[i], parts);
    }
    return parts;
  }

  // False where the budget ends.
  bool examine_all(std::vector<HiddenCube>& cubes, std::vector<Finding>& findings) {
    const int side = cubes.front().side;
    if (!in_turn(cubes.size(), [&](std::size_t i) { return look_at(cubes[i], findings[i]); })) {
      return false;
    }
    const auto open =
        static_cast<std::size_t>(std::count(findings.begin(), findings.end(), Finding::Open));
    if (side < kFinest && !keep_hidden(cubes, findings)) return false;
    return !(side <= kSampled || (side <= kFinest && open > kMany)) ||
           settle(cubes, findings, side, open);
  }

  // Nothing is begun that the budget does not hold: the open cubes in eight parts each. Where
  // dividing rules out nothing of late, as at walls that are thinner than a cell, what that takes
  // down to the cells is foretold, with a margin as long as cubes are large.
  bool is_hopeless(const std::vector<HiddenCube>& cubes, const std::vector<Finding>& findings) {
    double operations = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (findings[i] == Finding::Open) operations += cubes[i].function->cost();
    }
    // A surface that no slope explains passes through four of eight parts.
    constexpr double kSurface = 3.9;
    const bool spreads = operations > kSurface * operations_;
    operations_ = operations;
    if (operations * 8 * (kRange + kSlope) > left_) return true;
    const int along = cubes.front().side / kFinest;
    constexpr int kNear = 4;
    if (!spreads || along < 1 || along > 2 * kNear) return false;
    const double margin = along > kNear ? 4 : 1;
    return operations * 2 * along * along * kExpected > margin * left_;
  }

  // Leaves out the open cubes that the known surface passes through, and those beside them, since
  // meshes of thin walls have holes: empty space, where what is missed would be seen best, takes
  // little.
  void set_aside(const std::vector<HiddenCube>& cubes, std::vector<Finding>& findings) {
    const int side = cubes.front().side;
    constexpr double kVertex = 50;  // nanoseconds
    std::unordered_set<std::uint64_t> passed;
    left_ -= kVertex * static_cast<double>(surface_.size());
    for (const Vec3& p : surface_) passed.insert(name_of(fine_.cell_of(p) / side));
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      bool near = false;
      for (int k = 0; k < 27 && findings[i] == Finding::Open && !near; ++k) {
        const Cell beside = Cell(k % 3, k / 3 % 3, k / 9) - 1;
        near = passed.contains(name_of(cubes[i].first / side + beside));
      }
      if (!near) continue;
      findings[i] = Finding::Nothing;
      found_.whole = false;
    }
  }

  // Where the budget ends, what was found so far counts.
  void leave(const std::vector<HiddenCube>& cubes, const std::vector<Finding>& findings) {
    if (cubes.front().side > kFinest) {
      found_.whole = found_.whole && std::ranges::find(findings, Finding::Open) == findings.end();
      return;
    }
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (findings[i] != Finding::Open) continue;
      found_.doubtful.push_back({cell_of(cubes[i]), box_of(cubes[i])});
    }
  }

  // `run` for each of n, which returns the nanoseconds that it took: counted after some at a time,
  // so that what is done beyond the budget is little, and the same for any number of threads.
  // False where the budget ends before all are done.
  template <class Run>
  bool in_turn(std::size_t n, const Run& run) {
    constexpr std::size_t kAtATime = 512;
    std::array<double, kAtATime> spent;
    const std::size_t together = work::grain(kExpected * f_.cost(), kAtATime);
    for (std::size_t begin = 0; begin < n; begin += together) {
      if (!(left_ >= 0)) return false;
      const std::size_t end = std::min(n, begin + together);
      parallel_for(
          end - begin, 16,
          [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) spent[i] = run(begin + i);
          },
          &context_);
      for (std::size_t i = 0; i < end - begin; ++i) left_ -= spent[i];
    }
    return true;
  }

  // Returns the nanoseconds that it took, as those that `in_turn` calls do.
  double look_at(HiddenCube& c, Finding& finding) const {
    const Box3 box = box_of(c);
    finding = Finding::Nothing;
    for (int a = 0; a < 3; ++a) {
      if (!(box.min[a] < box.max[a])) return 0;
    }
    double work = 0;
    const double cost = c.function->cost();
    finding = examine(*c.function, box, work);
    if (finding == Finding::Open && c.side >= kFinest) {
      work += kRange;
      // Of the whole cube: ways to its corners may lead out of `within`.
      if (auto part = c.function->restricted(fine_.box(c.first, c.first + c.side))) {
        c.own = std::move(part);
        c.function = c.own.get();
      }
    }
    return work * cost;
  }

  void divide(const HiddenCube& c, std::vector<HiddenCube>& parts) const {
    for (int k = 0; k < 8; ++k) {
      HiddenCube part = c;
      part.side = c.side / 2;
      part.first += part.side * Cell(k & 1, (k >> 1) & 1, (k >> 2) & 1);
      const Cell end = fine_.cells;
      if (part.first.x < end.x && part.first.y < end.y && part.first.z < end.z) {
        parts.push_back(std::move(part));
      }
    }
  }

  // Cubes of one sign smaller than a cell, which may be what no sample shows; those that are not
  // asked before the budget ends are open.
  bool keep_hidden(const std::vector<HiddenCube>& cubes, std::vector<Finding>& findings) {
    std::vector<Answer> answers(cubes.size(), Answer::Undecided);
    const bool all = in_turn(cubes.size(), [&](std::size_t i) {
      if (findings[i] != Finding::Same) return 0.0;
      const Vec3 p = box_of(cubes[i]).center();
      const bool sign = inside(cubes[i].function->value(p));
      answers[i] = shown(cubes[i], p, sign) ? Answer::Explained : Answer::Hidden;
      return cubes[i].function->cost() * kSamples;
    });
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (findings[i] != Finding::Same) continue;
      if (answers[i] == Answer::Hidden)
        found_.places.push_back({cell_of(cubes[i]), box_of(cubes[i])});
      if (answers[i] == Answer::Undecided) findings[i] = Finding::Open;
    }
    return all;
  }

  // Tells by samples what is in the cubes that are open still; passes over those that the grid
  // explains, and at last those of which nothing can be told.
  bool settle(const std::vector<HiddenCube>& cubes, std::vector<Finding>& findings, int side,
              std::size_t open) {
    const bool fine = side <= kSampled, last = side == 1 || open > kDoubtful;
    std::vector<Answer> answers(cubes.size(), Answer::Undecided);
    const bool all = in_turn(cubes.size(), [&](std::size_t i) {
      if (findings[i] != Finding::Open) return 0.0;
      answers[i] = ask(cubes[i], fine);
      return cubes[i].function->cost() * kSamples;
    });
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (findings[i] != Finding::Open) continue;
      const HiddenPlace place{cell_of(cubes[i]), box_of(cubes[i])};
      if (answers[i] == Answer::Explained || answers[i] == Answer::Hidden || (fine && last)) {
        findings[i] = Finding::Nothing;
      }
      if (answers[i] == Answer::Hidden) found_.places.push_back(place);
      if (answers[i] == Answer::Undecided && fine && last) found_.doubtful.push_back(place);
    }
    return all;
  }

  // What samples of a cube tell.
  Answer ask(const HiddenCube& c, bool fine) const {
    const std::array<Vec3, 9> points = corners_and_middle(box_of(c));
    std::array<double, 9> values;
    c.function->values(points, values);
    // No number at all: the function ends before.
    if (std::ranges::all_of(values, [](double v) { return std::isnan(v); }))
      return Answer::Explained;
    std::optional<Vec3> of[2];
    for (std::size_t k = 0; k < points.size(); ++k) of[inside(values[k]) ? 1 : 0] = points[k];
    if (!(of[0] && of[1]) && fine) beyond(c, points[8], of);
    for (const bool sign : {false, true}) {
      if (of[sign] && !shown(c, *of[sign], sign)) return Answer::Hidden;
    }
    return of[0] && of[1] ? Answer::Explained : Answer::Undecided;
  }

  // Looks for the other sign by Newton's rule, which leads to where f would be zero.
  void beyond(const HiddenCube& c, Vec3 from, std::optional<Vec3> (&of)[2]) const {
    constexpr int kSteps = 4;
    constexpr double kFarther = 1.5;
    Vec3 p = from;
    const bool sign = of[1].has_value();
    for (int i = 0; i < kSteps; ++i) {
      const Gradient1 g = c.function->gradient(p);
      if (inside(g.value) != sign) {
        of[sign ? 0 : 1] = p;
        return;
      }
      const double square = glm::dot(g.gradient, g.gradient);
      if (!(square > 0)) return;
      p -= kFarther * g.value / square * g.gradient;
      if (!(glm::distance(p, from) < c.side * fine_.step)) return;
    }
  }

  // Whether a straight way leads to a sample of the grid with the same sign.
  bool shown(const HiddenCube& c, Vec3 p, bool sign) const {
    const Cell cell = cell_of(c);
    const Box3 box = grid_.box(cell, cell + 1);
    const std::array<Vec3, 9> ends = corners_and_middle(box);
    std::array<double, 8> at_ends;
    c.function->values(std::span(ends).first(8), at_ends);
    std::array<Vec3, kWay> way;
    std::array<double, kWay> values;
    for (std::size_t k = 0; k < at_ends.size(); ++k) {
      if (inside(at_ends[k]) != sign) continue;
      for (int i = 0; i < kWay; ++i) {
        way[static_cast<std::size_t>(i)] = p + (i + 1.0) / (kWay + 1) * (ends[k] - p);
      }
      c.function->values(way, values);
      if (std::ranges::all_of(values, [&](double v) { return inside(v) == sign; })) return true;
    }
    return false;
  }

  const ImplicitFunction& f_;
  const GridLayout grid_, fine_;
  const Box3 within_;
  const std::vector<Vec3>& surface_;
  double left_;            // nanoseconds
  double operations_ = 1;  // of the cubes of one size that were open
  const RunContext& context_;
  HiddenPlaces found_;
};

}  // namespace

HiddenPlaces find_hidden(const ImplicitFunction& f, const GridLayout& layout, const Box3& within,
                         const std::vector<Vec3>& surface, WorkBudget budget,
                         const RunContext& context) {
  return Search(f, layout, within, surface, budget, context).run();
}

}  // namespace burin
