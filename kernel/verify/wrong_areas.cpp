#include <burin/base/box.h>
#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/verify/wrong_areas.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace burin {
namespace {

// Paper mm between places that are tested, more where these would be too many.
constexpr double kAreaCell = 0.5;
constexpr double kMostPlaces = 1e6;
// Places along a side of a square that is wrong.
constexpr int kCloser = 4;
// Paper mm^2 of the smallest patch that counts: as wide as the shortest stretch of a line is long.
constexpr double kSmallest = 0.25;

/// Squares of a box of the sheet.
class AreaGrid {
 public:
  explicit AreaGrid(const Box2& box)
      : from_(box.min),
        cell_(std::max(kAreaCell, std::sqrt(box.size().x * box.size().y / kMostPlaces))) {
    columns_ = static_cast<std::size_t>(std::ceil(box.size().x / cell_));
    rows_ = static_cast<std::size_t>(std::ceil(box.size().y / cell_));
  }
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  std::size_t size() const { return columns_ * rows_; }
  double cell() const { return cell_; }

  /// A place in a square by its shares.
  Vec2 place(std::size_t i, Vec2 share) const {
    const std::size_t column = i % columns_, row = i / columns_;
    return from_ + cell_ * (Vec2(static_cast<double>(column), static_cast<double>(row)) + share);
  }
  template <class F>
  void each_beside(std::size_t i, const F& each) const {
    const std::size_t x = i % columns_, y = i / columns_;
    for (std::size_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, rows_ - 1); ++v) {
      for (std::size_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, columns_ - 1); ++u) {
        if (u != x || v != y) each(v * columns_ + u);
      }
    }
  }

 private:
  Vec2 from_;
  double cell_;
  std::size_t columns_ = 0, rows_ = 0;
};

/// Follows patches from a square to those beside it.
class Patches {
 public:
  /// `found`: at a place in each square.
  Patches(const AreaJudge& judge, const AreaGrid& grid, const std::vector<AreaFinding>& found,
          const RunContext& context)
      : judge_(judge), grid_(grid), found_(found), context_(context), seen_(grid.size(), 0) {}

  /// The patch around a wrong place.
  WrongArea patch(std::size_t first) {
    const AreaFinding kind = found_[first];
    std::vector<Vec2> wrong;
    std::vector<std::size_t> squares{first};
    see(first, kind);
    for (std::size_t k = 0; k < squares.size(); ++k) {
      context_.check();
      const std::size_t before = wrong.size();
      add_wrong(squares[k], kind, wrong);
      if (wrong.size() == before) continue;
      grid_.each_beside(squares[k], [&](std::size_t next) {
        if (seen(next, kind)) return;
        see(next, kind);
        squares.push_back(next);
      });
    }
    if (wrong.empty()) return {};
    Vec2 middle(0);
    for (const Vec2& p : wrong) middle += p / static_cast<double>(wrong.size());
    const Vec2 at =
        *std::ranges::min_element(wrong, {}, [&](Vec2 p) { return glm::distance(p, middle); });
    const double each = grid_.cell() * grid_.cell() / (kCloser * kCloser);
    AreaAnswer answer = judge_.at(at);
    answer.finding = kind;
    return {answer, each * static_cast<double>(wrong.size()), at};
  }
  bool seen(std::size_t i, AreaFinding kind) const { return (seen_[i] & bit(kind)) != 0; }

 private:
  static unsigned bit(AreaFinding kind) { return 1U << static_cast<unsigned>(kind); }
  void see(std::size_t i, AreaFinding kind) { seen_[i] |= static_cast<std::uint8_t>(bit(kind)); }

  /// The wrong places of a square; amid wrong ones all are.
  void add_wrong(std::size_t square, AreaFinding kind, std::vector<Vec2>& wrong) const {
    bool amid = found_[square] == kind;
    grid_.each_beside(square, [&](std::size_t i) { amid = amid && found_[i] == kind; });
    for (int j = 0; j < kCloser * kCloser; ++j) {
      const Vec2 share = (Vec2(j % kCloser, j / kCloser) + 0.5) / static_cast<double>(kCloser);
      const Vec2 p = grid_.place(square, share);
      if (amid || judge_.test(p).finding == kind) wrong.push_back(p);
    }
  }

  const AreaJudge& judge_;
  const AreaGrid& grid_;
  const std::vector<AreaFinding>& found_;
  const RunContext& context_;
  /// A bit a kind.
  std::vector<std::uint8_t> seen_;
};

}  // namespace

AreaFindings wrong_areas(const AreaJudge& judge, const Box2& box, std::uint64_t seed,
                         const RunContext& context) {
  AreaFindings out;
  if (box.empty() || box.min.x >= box.max.x || box.min.y >= box.max.y) return out;
  const AreaGrid grid(box);
  const Rng random(seed);
  std::vector<AreaFinding> found(grid.size(), AreaFinding::Holds);
  parallel_for(
      grid.rows(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * grid.columns(); i < end * grid.columns(); ++i) {
          const Vec2 share(random.uniform(2 * i), random.uniform(2 * i + 1));
          found[i] = judge.test(grid.place(i, share)).finding;
        }
      },
      &context);
  out.tested = box.size().x * box.size().y;
  Patches patches(judge, grid, found, context);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == AreaFinding::Holds || patches.seen(i, found[i])) continue;
    const WrongArea patch = patches.patch(i);
    if (patch.size >= kSmallest) out.wrong.push_back(patch);
  }
  std::ranges::stable_sort(out.wrong, std::ranges::greater{}, &WrongArea::size);
  return out;
}

}  // namespace burin
