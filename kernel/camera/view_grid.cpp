#include <burin/base/error.h>
#include <burin/camera/view_grid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace burin {
namespace {

struct Cell {
  int column = 0, row = 0;  // row: upwards
};

/// Beside the front view in third angle; in first angle all but the back view change sides.
constexpr std::array<std::pair<std::string_view, Cell>, 6> kPrincipal{{
    {"front", {0, 0}},
    {"back", {2, 0}},
    {"left", {-1, 0}},
    {"right", {1, 0}},
    {"top", {0, 1}},
    {"bottom", {0, -1}},
}};
constexpr int kPictorialInRow = 3;

/// The cell of a view that has one beside the front view.
std::optional<Cell> principal_cell(const GridView& view, int side) {
  const auto known =
      std::ranges::find(kPrincipal, view.name, &decltype(kPrincipal)::value_type::first);
  if (known == kPrincipal.end()) return std::nullopt;
  const Cell cell = known->second;
  return view.name == "back" ? cell : Cell{side * cell.column, side * cell.row};
}

std::vector<Cell> cells_of(std::span<const GridView> views, ProjectionMethod method) {
  const int side = method == ProjectionMethod::ThirdAngle ? 1 : -1;
  // Pictorial views stand in the corner beside the view from above, or of the row of the front view
  // where nothing stands there, after all of that row.
  bool corner = false;
  int last = 0;
  for (const GridView& view : views) {
    const auto cell = principal_cell(view, side);
    if (!cell) continue;
    corner |= cell->row == side;
    last = std::max(last, cell->column);
  }
  const Cell first = corner ? Cell{1, side} : Cell{last + 1, 0};
  int pictorial = 0;
  std::vector<Cell> cells;
  for (const GridView& view : views) {
    const auto cell = principal_cell(view, side);
    cells.push_back(cell ? *cell
                         : Cell{first.column + pictorial % kPictorialInRow,
                                first.row + side * (pictorial / kPictorialInRow)});
    if (!cell) ++pictorial;
  }
  return cells;
}

/// Where a lane begins and ends, and where the middles of its views are.
struct LanePlace {
  double begin = 0, middle = 0, end = 0;
};

/// The columns, or the rows, that have a view.
class Lanes {
 public:
  Lanes(std::span<const GridView> views, std::span<const Cell> cells, bool columns, double gap)
      : gap_(gap) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      const auto& [name, size, room] = views[i];
      lanes_[columns ? cells[i].column : cells[i].row].push_back(
          columns ? Extent{size.x, room.left, room.right} : Extent{size.y, room.bottom, room.top});
    }
  }

  double width(double scale) const {
    double sum = gap_ * static_cast<double>(lanes_.size() - 1);
    for (const auto& [lane, views] : lanes_) sum += place_of(views, scale, 0).end;
    return sum;
  }

  std::map<int, LanePlace> places(double scale, double begin) const {
    std::map<int, LanePlace> places;
    for (const auto& [lane, views] : lanes_) {
      places[lane] = place_of(views, scale, begin);
      begin = places[lane].end + gap_;
    }
    return places;
  }

 private:
  /// Model mm, and paper mm before and after.
  struct Extent {
    double size = 0, before = 0, after = 0;
  };

  static LanePlace place_of(const std::vector<Extent>& views, double scale, double begin) {
    double before = 0, after = 0;
    for (const Extent& view : views) {
      before = std::max(before, 0.5 * view.size * scale + view.before);
      after = std::max(after, 0.5 * view.size * scale + view.after);
    }
    return {begin, begin + before, begin + before + after};
  }

  std::map<int, std::vector<Extent>> lanes_;
  double gap_;
};

/// The largest scale at which the lanes are no wider than that: their width grows with it.
double largest_scale(const Lanes& lanes, double most) {
  if (!(lanes.width(0) < most)) {
    throw UsageError(
        "the sheet has no room for so many views: name fewer, or give a larger `paper`");
  }
  double low = 0, high = 1;
  constexpr double kHuge = 1e12;
  while (lanes.width(high) <= most && high < kHuge) low = high, high *= 2;
  constexpr int kHalvings = 100;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (lanes.width(middle) <= most ? low : high) = middle;
  }
  return low;
}

}  // namespace

ViewGrid arrange_views(std::span<const GridView> views, ProjectionMethod method, const Box2& frame,
                       double gap, std::optional<double> scale) {
  const std::vector<Cell> cells = cells_of(views, method);
  const Lanes columns(views, cells, true, gap), rows(views, cells, false, gap);
  if (std::ranges::all_of(views, [](const GridView& v) { return v.size == Vec2(0); })) {
    throw GeometryError("nothing to draw: the model has no extent");
  }
  ViewGrid grid;
  grid.scale =
      scale ? *scale
            : std::min(largest_scale(columns, frame.size().x), largest_scale(rows, frame.size().y));
  const Vec2 size(columns.width(grid.scale), rows.width(grid.scale));
  grid.box = {frame.center() - 0.5 * size, frame.center() + 0.5 * size};
  const auto x = columns.places(grid.scale, grid.box.min.x);
  const auto y = rows.places(grid.scale, grid.box.min.y);
  for (const Cell& cell : cells) {
    const LanePlace &column = x.at(cell.column), &row = y.at(cell.row);
    grid.boxes.push_back({{column.begin, row.begin}, {column.end, row.end}});
    grid.middles.emplace_back(column.middle, row.middle);
  }
  return grid;
}

NamedView view_in_grid(std::string_view name) {
  NamedView view = named_view(name);
  if (name == "bottom") view.up = -view.up;
  return view;
}

double standard_scale(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  constexpr double kRounding = 1 + 1e-9;
  for (const double step : {10.0, 5.0, 2.0}) {
    if (step * power <= most * kRounding) return step * power;
  }
  return power;
}

std::string scale_text(double scale) {
  return scale >= 1 ? fmt::format("{:.3g}:1", scale) : fmt::format("1:{:.3g}", 1 / scale);
}

}  // namespace burin
