#include <burin/area/partition.h>
#include <burin/base/parallel.h>

#include "burin_test/rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;
const Box2 kSheet{Vec2(0), Vec2(100, 80)};

std::vector<Vec2> circle_of(Vec2 center, double radius, int n) {
  std::vector<Vec2> out;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    out.push_back(center + radius * Vec2(std::cos(u), std::sin(u)));
  }
  return out;
}

std::vector<Vec2> rectangle(Vec2 a, Vec2 b) { return {a, {b.x, a.y}, b, {a.x, b.y}}; }

bool holds(std::span<const Vec2> ring, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[j], b = ring[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

bool holds(const Partition& partition, const AreaRegion& region, Vec2 p) {
  return std::ranges::count_if(
             region.rings,
             [&](const AreaRing& ring) { return holds(partition.polygon(ring), p); }) %
             2 ==
         1;
}

Partition part(std::span<const BorderLine> lines, const LabelAt& label_at,
               const PartitionOptions& options = {}) {
  return partition(kSheet, lines, label_at, options, RunContext());
}

void expect_sound(const Partition& p) { test::expect_sound(p, kSheet); }

TEST(Partition, OfASquareHasItsAreaAndNamesItsLineOnEverySide) {
  const auto square = rectangle({20, 20}, {60, 50});
  const std::vector<BorderLine> lines = {{square, true, 7}};
  const Partition p =
      part(lines, [&](Vec2 at) { return AreaLabel{.part = holds(square, at) ? 3 : -1}; });
  expect_sound(p);
  ASSERT_EQ(p.regions.size(), 2u);
  const AreaRegion& inner = p.regions[p.regions[0].label.part == 3 ? 0 : 1];
  EXPECT_NEAR(inner.area, 40 * 30, 1e-9);
  ASSERT_EQ(inner.rings.size(), 1u);
  for (const std::int32_t line : inner.rings[0].lines) EXPECT_EQ(line, 7);
  EXPECT_EQ(p.mixed, 0u);
}

TEST(Partition, OfARingHasAHole) {
  const auto outer = circle_of({50, 40}, 30, 200), inner = circle_of({50, 40}, 12, 100);
  const std::vector<BorderLine> lines = {{outer, true, 0}, {inner, true, 1}};
  const Partition p = part(lines, [&](Vec2 at) {
    return AreaLabel{.part = holds(outer, at) && !holds(inner, at) ? 0 : -1};
  });
  expect_sound(p);
  ASSERT_EQ(p.regions.size(), 3u);
  for (const AreaRegion& region : p.regions) {
    if (region.label.part == 0) {
      EXPECT_EQ(region.rings.size(), 2u);
    }
  }
}

TEST(Partition, OfALineWithAGapDoesNotLeak) {
  // A line from side to side, a piece of it missing.
  for (const double gap : {0.1, 0.2, 1.0, 5.0}) {
    const std::vector<Vec2> left = {{0, 40}, {50 - gap / 2, 40}},
                            right = {{50 + gap / 2, 40}, {100, 40}};
    const std::vector<BorderLine> lines = {{left, false, 0}, {right, false, 1}};
    const Partition p = part(lines, [](Vec2 at) { return AreaLabel{.part = at.y > 40 ? 1 : 0}; });
    expect_sound(p);
    ASSERT_EQ(p.regions.size(), 2u) << gap;
    EXPECT_NEAR(p.regions[0].area, 4000, 0.01 * gap * gap + 1e-6) << gap;
  }
}

TEST(Partition, FindsTheRestOfABorderWhereHalfTheLineIsMissing) {
  const auto disk = circle_of({50, 40}, 20, 200);
  const auto label_at = [&](Vec2 at) { return AreaLabel{.part = holds(disk, at) ? 0 : -1}; };
  const std::vector<BorderLine> lines = {{std::span(disk).first(101), false, 0}};
  double last = 1e9;
  for (const int rounds : {0, 1, 3, 6}) {
    const Partition p = part(lines, label_at, {.rounds = rounds});
    expect_sound(p);
    double error = 0;  // where labels are not those of random places
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, 100), y(0, 80);
    for (int k = 0; k < 20000; ++k) {
      const Vec2 at(x(random), y(random));
      for (const AreaRegion& r : p.regions) {
        if (holds(p, r, at) && r.label != label_at(at)) error += 8000.0 / 20000;
      }
    }
    EXPECT_LE(error, last) << rounds;
    last = error;
  }
  EXPECT_LT(last, 1);
}

TEST(Partition, GivesSliversToTheNeighbour) {
  const auto a = rectangle({20, 20}, {50, 60}), b = rectangle({50.02, 20}, {80, 60});
  const std::vector<BorderLine> lines = {{a, true, 0}, {b, true, 1}};
  const Partition p = part(lines, [&](Vec2 at) {
    return AreaLabel{.part = holds(a, at) ? 0 : holds(b, at) ? 1 : -1};
  });
  expect_sound(p);
  EXPECT_EQ(p.regions.size(), 3u);
}

TEST(Partition, SpecksOfToneGoToTheStepBesideThemAndPartsStay) {
  // A part with a darker band 2 mm wide, a strip of 0.2 mm and a speck of 0.2 mm; another part as
  // small as the speck.
  const std::vector<Vec2> outer = rectangle({10, 10}, {60, 50}),
                          band = rectangle({15, 15}, {45, 17}),
                          strip = rectangle({15, 25}, {45, 25.2}),
                          speck = rectangle({50, 30}, {50.2, 30.2}),
                          small = rectangle({50, 40}, {50.2, 40.2});
  const std::vector<BorderLine> lines{
      {outer, true}, {band, true}, {strip, true}, {speck, true}, {small, true}};
  const auto label_at = [&](Vec2 p) {
    if (holds(small, p)) return AreaLabel{.part = 2};
    const bool dark = holds(band, p) || holds(strip, p) || holds(speck, p);
    return AreaLabel{.part = holds(outer, p) ? 1 : -1, .tone = dark ? 0 : 1};
  };
  EXPECT_EQ(part(lines, label_at).regions.size(), 6u);
  const Partition p = part(lines, label_at, {.least_tone_width = 0.25});
  expect_sound(p);
  ASSERT_EQ(p.regions.size(), 5u) << "band and strip stay";
  for (const AreaRegion& region : p.regions) {
    if (region.label.part == 1 && region.label.tone == 0) {
      EXPECT_GT(region.area, 5) << "no speck";
    }
    if (region.label.part == 2) {
      EXPECT_NEAR(region.area, 0.04, 1e-9);
    }
  }
}

TEST(Partition, ASpeckAsWideAsAPenAtItsWidestPlaceStays) {
  // A drop: a disc a little wider than the pen, with a long thin tail. Twice its area by its border
  // is less than the pen; the same with a disc a little narrower goes.
  const auto drop = [](Vec2 at, double radius) {
    std::vector<Vec2> out{at + Vec2(0.45, 0)};
    for (int i = 1; i < 48; ++i) {
      const double u = 2 * kPi * i / 48;
      out.push_back(at + radius * Vec2(std::cos(u), std::sin(u)));
    }
    return out;
  };
  const std::vector<Vec2> outer = rectangle({10, 10}, {60, 50}), wide = drop({20, 20}, 0.13),
                          narrow = drop({40, 20}, 0.12);
  const std::vector<BorderLine> lines{{outer, true}, {wide, true}, {narrow, true}};
  const auto label_at = [&](Vec2 p) {
    const bool dark = holds(wide, p) || holds(narrow, p);
    return AreaLabel{.part = holds(outer, p) ? 1 : -1, .tone = dark ? 0 : 1};
  };
  const Partition p = part(lines, label_at, {.least_tone_width = 0.25});
  expect_sound(p);
  ASSERT_EQ(p.regions.size(), 3u);
  const auto dark = std::ranges::find_if(
      p.regions, [](const AreaRegion& r) { return r.label.tone == 0 && r.label.part == 1; });
  ASSERT_NE(dark, p.regions.end());
  EXPECT_LT(p.points[dark->rings.front().corners.front()].x, 30) << "the wide one";
}

TEST(Partition, OfRandomRectanglesOverEachOtherAgreesWithRandomPlaces) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-10, 110), y(-10, 90);
  for (int scene = 0; scene < 60; ++scene) {
    std::vector<std::vector<Vec2>> boxes;
    for (int i = 0; i < 2 + scene % 9; ++i) {
      const Vec2 a(x(random), y(random)), b(x(random), y(random));
      boxes.push_back(rectangle(glm::min(a, b), glm::max(a, b)));
    }
    std::vector<BorderLine> lines;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      lines.push_back({boxes[i], true, static_cast<std::int32_t>(i)});
    }
    const auto label_at = [&](Vec2 at) {
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (holds(boxes[i], at)) return AreaLabel{.part = static_cast<std::int32_t>(i)};
      }
      return AreaLabel{};
    };
    const Partition p = part(lines, label_at);
    expect_sound(p);
    int wrong = 0;
    for (int k = 0; k < 400; ++k) {
      const Vec2 at(std::abs(x(random)), std::abs(y(random)));
      if (at.x > 100 || at.y > 80) continue;
      for (const AreaRegion& r : p.regions) {
        if (holds(p, r, at) && r.label != label_at(at)) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << scene;
  }
}

struct CutLines {
  /// Whole, and in pieces whose ends are cut off.
  std::vector<std::vector<Vec2>> disks, pieces;
  std::vector<Vec2> gaps;

  AreaLabel label_at(Vec2 at) const {
    for (std::size_t i = 0; i < disks.size(); ++i) {
      if (holds(disks[i], at)) return {.part = static_cast<std::int32_t>(i)};
    }
    return {};
  }
};

/// `cut` mm are missing at each end of a piece.
CutLines disks_cut_at_random(std::mt19937& random, double cut) {
  std::uniform_real_distribution<double> x(5, 95), y(5, 75);
  CutLines out;
  for (int i = 0; i < 5; ++i)
    out.disks.push_back(circle_of({x(random), y(random)}, 6 + 3 * i, 120));
  for (const auto& disk : out.disks) {
    std::size_t begin = 0;
    while (begin < disk.size()) {
      const std::size_t end = std::min(begin + 20 + random() % 60, disk.size());
      std::vector<Vec2> piece;
      for (std::size_t k = begin; k <= end; ++k) piece.push_back(disk[k % disk.size()]);
      out.gaps.push_back(piece.front());
      const auto shorten = [&](Vec2& from, Vec2 to) { from += cut * glm::normalize(to - from); };
      shorten(piece.front(), piece[1]);
      shorten(piece.back(), piece[piece.size() - 2]);
      out.pieces.push_back(std::move(piece));
      begin = end;
    }
  }
  return out;
}

std::vector<BorderLine> borders(const std::vector<std::vector<Vec2>>& lines, bool closed) {
  std::vector<BorderLine> out;
  for (const auto& line : lines) {
    out.push_back({line, closed, static_cast<std::int32_t>(out.size())});
  }
  return out;
}

std::map<AreaLabel, double> sizes_by_label(const Partition& p) {
  std::map<AreaLabel, double> out;
  for (const AreaRegion& region : p.regions) out[region.label] += region.area;
  return out;
}

TEST(Partition, OfLinesCutAtRandomIsWrongAtTheGapsAlone) {
  std::mt19937 random(7);
  for (const double cut : {0.1, 0.3}) {
    for (const int rounds : {0, 3}) {
      for (int scene = 0; scene < 30; ++scene) {
        const CutLines lines = disks_cut_at_random(random, cut);
        const auto label_at = [&](Vec2 at) { return lines.label_at(at); };
        const Partition whole = part(borders(lines.disks, true), label_at, {.rounds = rounds});
        const Partition p = part(borders(lines.pieces, false), label_at, {.rounds = rounds});
        expect_sound(p);
        // A triangle over a gap is as long as that, and as high as the arc over it or its
        // continuation is off: 2 cut * (2 cut)^2 / 8 r, and what slivers beside it hold.
        const double a_gap = 0.05 * cut;
        auto before = sizes_by_label(whole), after = sizes_by_label(p);
        for (const auto& [label, size] : before) {
          EXPECT_NEAR(after[label], size, a_gap * static_cast<double>(lines.gaps.size()))
              << scene << ' ' << cut << ' ' << label.part;
        }
        // Nowhere else is any place wrong.
        std::uniform_real_distribution<double> x(0.1, 99.9), y(0.1, 79.9);
        for (int k = 0; k < 1000; ++k) {
          const Vec2 at(x(random), y(random));
          const bool near_gap = std::ranges::any_of(
              lines.gaps, [&](Vec2 gap) { return glm::distance(gap, at) < 4 * cut; });
          for (const AreaRegion& r : p.regions) {
            if (!near_gap && holds(p, r, at)) {
              EXPECT_EQ(r.label, label_at(at)) << scene << ' ' << at.x << ' ' << at.y;
            }
          }
        }
      }
    }
  }
}

TEST(Partition, OutlinesOfSeveralRegionsAreThoseOfTheirUnion) {
  const auto outer = circle_of({50, 40}, 30, 200), inner = circle_of({50, 40}, 12, 100);
  const std::vector<Vec2> across = {{50, 0}, {50, 80}};
  const std::vector<BorderLine> lines = {{outer, true, 0}, {inner, true, 1}, {across, false, 2}};
  const Partition p = part(lines, [&](Vec2 at) {
    if (!holds(outer, at) || holds(inner, at)) return AreaLabel{};
    return AreaLabel{.part = 0, .tone = at.x < 50 ? 0 : 1};
  });
  std::vector<std::uint32_t> both;
  double sum = 0;
  for (std::uint32_t i = 0; i < p.regions.size(); ++i) {
    if (p.regions[i].label.part < 0) continue;
    both.push_back(i);
    sum += p.regions[i].area;
    const std::vector<std::uint32_t> alone = {i};
    ASSERT_EQ(p.outline(alone).size(), 1u);
    EXPECT_EQ(p.outline(alone)[0].size(), p.polygon(p.regions[i].rings[0]).size());
  }
  ASSERT_EQ(both.size(), 2u);
  const auto rings = p.outline(both);
  ASSERT_EQ(rings.size(), 2u) << "the rim and the hole";
  double area = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
  }
  EXPECT_NEAR(area, sum, 1e-9);
  // Two squares that meet in a corner: two rings, none of which crosses itself.
  const auto left = rectangle({20, 20}, {50, 40}), right = rectangle({50, 40}, {80, 60});
  const std::vector<BorderLine> corner = {{left, true, 0}, {right, true, 1}};
  const Partition q = part(corner, [&](Vec2 at) {
    return AreaLabel{.part = holds(left, at) ? 0 : holds(right, at) ? 1 : -1};
  });
  std::vector<std::uint32_t> squares;
  for (std::uint32_t i = 0; i < q.regions.size(); ++i) {
    if (q.regions[i].label.part >= 0) squares.push_back(i);
  }
  EXPECT_EQ(q.outline(squares).size(), 2u);
}

TEST(Partition, IsTheSameForAnyNumberOfThreads) {
  const auto disk = circle_of({40, 40}, 25, 300);
  const std::vector<BorderLine> lines = {{disk, true, 0}};
  const auto label_at = [&](Vec2 at) {
    return AreaLabel{.part = holds(disk, at) ? 0 : -1, .tone = at.x + 0.3 * at.y > 50 ? 1 : 0};
  };
  const Partition many = part(lines, label_at);
  const ThreadLimit one(1);
  const Partition alone = part(lines, label_at);
  EXPECT_EQ(many.points, alone.points);
  ASSERT_EQ(many.regions.size(), alone.regions.size());
  for (std::size_t i = 0; i < many.regions.size(); ++i) {
    EXPECT_EQ(many.regions[i].rings[0].corners, alone.regions[i].rings[0].corners);
  }
}

/// One place says little of a triangle as thin as lines and labels may differ.
TEST(Partition, AThinTriangleIsWhatLiesBeyondItsSidesWithoutALine) {
  const std::vector<Vec2> line = {{0, 0.3}, {40, 0.3}, {41, 0.3}, {100, 0.3}};
  const std::vector<BorderLine> lines = {{line, false, 1}};
  // Those between the short piece of the line and a corner of the sheet.
  const std::array thin = {Vec2(81, 0.6) / 3.0, Vec2(181, 0.6) / 3.0};
  std::atomic<int> asked = 0;
  const LabelAt label_at = [&](Vec2 at) {
    const bool wrong =
        std::ranges::any_of(thin, [&](Vec2 p) { return glm::distance(p, at) < 0.01; });
    asked += wrong ? 1 : 0;
    return AreaLabel{.part = at.y < 0.3 && !wrong ? 1 : 0};
  };
  const Partition p = part(lines, label_at, {.slack = 0.04});
  expect_sound(p);
  EXPECT_GT(asked, 0) << "another triangulation";
  ASSERT_EQ(p.regions.size(), 2u);
  for (const AreaRegion& region : p.regions) {
    EXPECT_NEAR(region.area, region.label.part == 1 ? 30 : 7970, 1e-9);
  }
}

}  // namespace
}  // namespace burin
