// The order of a pen: the same lines as before, less travel.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/join.h>
#include <burin/drawing/pen_order.h>

#include <burin_test/drawings.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

namespace burin {
namespace {

struct Line {
  std::vector<Vec2> points;
  bool closed = false;
  std::uint32_t group = 0;
  std::int64_t mark = 0;
};

std::vector<PenPath> paths_of(const std::vector<Line>& lines) {
  std::vector<PenPath> paths;
  for (const Line& l : lines) paths.push_back({l.points, l.closed, l.group, l.mark});
  return paths;
}

using Segment = std::tuple<std::uint32_t, double, double, double, double>;

/// How often each segment is drawn in each group, whichever way; points that stand alone, too.
std::map<Segment, int> segments(const std::vector<Vec2>& points, bool closed, std::uint32_t group) {
  std::map<Segment, int> found;
  std::vector<Vec2> all = points;
  if (closed) all.push_back(all.front());
  if (all.size() == 1) all.push_back(all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    std::array<std::pair<double, double>, 2> ends{std::pair(all[i - 1].x, all[i - 1].y),
                                                  std::pair(all[i].x, all[i].y)};
    std::ranges::sort(ends);
    if (ends[0] == ends[1] && points.size() > 1) continue;
    ++found[{group, ends[0].first, ends[0].second, ends[1].first, ends[1].second}];
  }
  return found;
}

template <class Map>
void add_up(const Map& some, Map& all) {
  for (const auto& [key, count] : some) all[key] += count;
}

void expect_same_segments(const std::vector<Line>& lines, const PenOrder& order) {
  std::map<Segment, int> before, after;
  for (const Line& l : lines) add_up(segments(l.points, l.closed, l.group), before);
  std::vector<int> used(lines.size(), 0);
  const std::vector<PenPath> paths = paths_of(lines);
  for (const PenLine& line : order.lines) {
    add_up(segments(points_of(line, order, paths), line.closed, line.group), after);
    for (std::uint32_t k = 0; k < line.runs; ++k) ++used[order.runs[line.first_run + k].path];
  }
  EXPECT_TRUE(std::ranges::all_of(used, [](int n) { return n == 1; }));
  EXPECT_EQ(before, after);
}

/// Lines between the points of a grid, so that many meet; some closed, some points, some doubled.
std::vector<Line> random_lines(unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Line> lines(static_cast<std::size_t>(1 + any(120)));
  const int size = 2 + any(20), groups = 1 + any(3);
  for (Line& line : lines) {
    const int points = 1 + any(6);
    while (static_cast<int>(line.points.size()) < points) {
      const Vec2 p(any(size), any(size));
      if (line.points.empty() || line.points.back() != p) line.points.push_back(p);
    }
    line.closed = points > 2 && any(4) == 0;
    line.group = static_cast<std::uint32_t>(any(groups));
    line.mark = any(3) - 1;
  }
  for (int i = any(5); i > 0; --i) lines.push_back(lines[random() % lines.size()]);
  return lines;
}

bool same(const PenOrder& a, const PenOrder& b) {
  const auto key = [](const PenLine& l) {
    return std::tuple(l.group, l.first_run, l.runs, l.closed, l.start);
  };
  return std::ranges::equal(a.lines, b.lines, {}, key, key) &&
         std::ranges::equal(a.runs, b.runs, [](const PenRun& r, const PenRun& s) {
           return r.path == s.path && r.reversed == s.reversed;
         });
}

TEST(PenOrder, DrawsTheSameSegmentsWithLessTravel) {
  const RunContext context;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    const std::vector<Line> lines = random_lines(seed);
    const std::vector<PenPath> paths = paths_of(lines);
    const PenOrder order = pen_order(paths, {}, context);
    expect_same_segments(lines, order);
    EXPECT_TRUE(std::ranges::is_sorted(order.lines, {}, &PenLine::group));
    const PenOrder given = given_order(paths, Vec2(0), context);
    EXPECT_NEAR(order.drawn, given.drawn, 1e-6);
    // The nearest first is no better by luck than the order of a few lines.
    if (lines.size() > 30) {
      EXPECT_LT(order.travel, 0.8 * given.travel) << seed;
    }
    // Lines of a mark and group of their own stay so.
    for (const PenLine& line : order.lines) {
      for (std::uint32_t k = 1; k < line.runs; ++k) {
        const PenPath& first = paths[order.runs[line.first_run].path];
        const PenPath& other = paths[order.runs[line.first_run + k].path];
        EXPECT_EQ(other.mark, first.mark);
        EXPECT_EQ(other.group, first.group);
        EXPECT_GE(other.mark, 0);
      }
    }
    ASSERT_FALSE(HasFailure()) << seed;
  }
}

TEST(PenOrder, IsTheSameForAnyNumberOfThreads) {
  std::mt19937 random(7);
  std::vector<Line> lines(20'000);
  for (Line& line : lines) {
    const Vec2 a(static_cast<double>(random() % 2000) / 10,
                 static_cast<double>(random() % 2000) / 10);
    line.points = {a, a + Vec2(static_cast<double>(random() % 40) / 10, 1)};
  }
  const std::vector<PenPath> paths = paths_of(lines);
  const RunContext context;
  const PenOrder order = pen_order(paths, {}, context);
  EXPECT_TRUE(same(order, pen_order(paths, {}, context)));
  {
    const ThreadLimit one(1);
    EXPECT_TRUE(same(order, pen_order(paths, {}, context)));
  }
  // A tour through n random places of an area A is about 0.71 sqrt(n A) long; lines have two ends
  // to be met at.
  EXPECT_LT(order.travel, 0.8 * std::sqrt(20'000.0 * 200 * 200));
  EXPECT_LT(order.travel, 0.02 * given_order(paths, Vec2(0), context).travel);
  RunContext cancelled;
  cancelled.cancel();
  EXPECT_THROW(pen_order(paths, {}, cancelled), Cancelled);
}

TEST(PenOrder, JoinsARingOfPiecesAndBeginsItWhereThePenComesBy) {
  // A square in four pieces, two of them the other way round, and a line that leads to its far
  // side.
  const std::vector<Line> lines{{{{10, 10}, {20, 10}}},
                                {{{20, 20}, {20, 10}}},
                                {{{20, 20}, {10, 20}}},
                                {{{10, 10}, {10, 20}}},
                                {{{0, 0}, {30, 0}, {30, 19}}}};
  const std::vector<PenPath> paths = paths_of(lines);
  const PenOrder order = pen_order(paths, {}, RunContext());
  ASSERT_EQ(order.lines.size(), 2u);
  EXPECT_FALSE(order.lines[0].closed);
  EXPECT_TRUE(order.lines[1].closed);
  EXPECT_EQ(order.lines[1].runs, 4u);
  const std::vector<Vec2> ring = points_of(order.lines[1], order, paths);
  EXPECT_EQ(ring.size(), 4u);
  EXPECT_EQ(ring.front(), Vec2(20, 20));
  EXPECT_NEAR(order.travel, glm::distance(Vec2(30, 19), Vec2(20, 20)), 1e-12);
  expect_same_segments(lines, order);
}

TEST(PenOrder, GoesStraightOnWhereMoreThanTwoEndsMeet) {
  const std::vector<Line> lines{
      {{{0, 10}, {10, 10}}}, {{{10, 0}, {10, 10}}}, {{{10, 10}, {20, 10}}}, {{{10, 20}, {10, 10}}}};
  const std::vector<PenPath> paths = paths_of(lines);
  const PenOrder order = pen_order(paths, {}, RunContext());
  ASSERT_EQ(order.lines.size(), 2u);
  for (const PenLine& line : order.lines) {
    const std::vector<Vec2> points = points_of(line, order, paths);
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1], Vec2(10, 10));
    EXPECT_EQ(0.5 * (points[0] + points[2]), points[1]);
  }
}

TEST(PenOrder, TakesAnyLines) {
  const RunContext context;
  EXPECT_TRUE(pen_order({}, {}, context).lines.empty());
  // Ten thousand lines from one place, the same line many times, points in one place.
  std::vector<Line> star, doubled, points;
  for (int i = 0; i < 10'000; ++i) {
    star.push_back({{{50, 50}, {50 + 20 * std::cos(i), 50 + 20 * std::sin(i)}}});
    doubled.push_back({{{1, 1}, {2, 3}}});
    points.push_back({{{5, 5}}});
  }
  for (const auto& lines : {star, doubled, points}) {
    const std::vector<PenPath> paths = paths_of(lines);
    expect_same_segments(lines, pen_order(paths, {}, context));
  }
  // There and back is drawn twice, as it was given, and is no ring.
  const std::vector<Line> twice{{{{1, 1}, {2, 3}}}, {{{2, 3}, {1, 1}}}};
  const PenOrder order = pen_order(paths_of(twice), {}, context);
  ASSERT_EQ(order.lines.size(), 1u);
  EXPECT_FALSE(order.lines[0].closed);
  expect_same_segments(twice, order);
}

TEST(TravelOrder, KeepsWhatIsSaidOfPathsAndTheirWidths) {
  const Drawing drawing = test::sample_drawing();
  std::vector<const Path*> all;
  for (const Path& path : drawing.layers[0].paths) all.push_back(&path);
  Vec2 pen(0);
  const JoinedPaths out = in_travel_order(all, pen, RunContext());
  ASSERT_EQ(out.paths.size(), all.size());
  std::size_t turned = 0;
  for (const Path* path : out.paths) {
    const auto it = std::ranges::find_if(all, [&](const Path* p) {
      return p == path || std::ranges::equal(p->points.rbegin(), p->points.rend(),
                                             path->points.begin(), path->points.end());
    });
    ASSERT_NE(it, all.end());
    turned += *it != path;
    EXPECT_EQ(path->source, (*it)->source);
    EXPECT_EQ(path->kind, (*it)->kind);
    EXPECT_EQ(path->width.size(), path->points.size());
    EXPECT_EQ(path->width[40], (*it)->width[*it == path ? 40 : path->points.size() - 41]);
  }
  EXPECT_GT(turned, 0u);  // neighbours are drawn there and back
  const Path& last = *out.paths.back();
  EXPECT_EQ(pen, last.points.back());
}

}  // namespace
}  // namespace burin
