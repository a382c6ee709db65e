#include <burin/base/error.h>
#include <burin/converters/pictures.h>

#include "flat/import/import_file.h"
#include "source.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace burin::csg {
namespace {

constexpr std::size_t kMostHeights = 5'000'000;

/// Rows of heights from the front to the back; what is not given is 0.
struct Heights {
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;
  double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

bool is_png(const Source& source) { return source.bytes().starts_with("\x89PNG\r\n\x1a\n"); }

Heights of_picture(const std::filesystem::path& path, bool invert) {
  constexpr double kWhite = 100;  // mm, as OpenSCAD has it
  const Image image = read_png(path);
  Heights out{static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), {}};
  for (const float v : image.values) {
    // Of 0 to 255, which OpenSCAD forgets when it turns them round.
    out.values.push_back(invert ? kWhite / 255 - kWhite * v : kWhite * v);
  }
  return out;
}

Heights of_text(const Source& source, RunContext& run) {
  std::vector<std::vector<double>> rows;
  Heights out;
  std::size_t count = 0;
  for (TextCursor cursor(source); !cursor.at_end(); cursor.next_line()) {
    run.check();
    cursor.skip_blanks();
    if (cursor.at_line_end() || cursor.peek() == '#') continue;
    std::vector<double>& row = rows.emplace_back();
    for (; !cursor.at_line_end(); cursor.skip_blanks()) {
      row.push_back(cursor.number("a height"));
      if (!std::isfinite(row.back())) cursor.fail("a height that is no finite number");
      if (++count > kMostHeights) cursor.fail("more than five million heights");
    }
    out.columns = std::max(out.columns, row.size());
  }
  out.rows = rows.size();
  if (static_cast<double>(out.rows) * static_cast<double>(out.columns) > kMostHeights) {
    source.fail("a grid of more than five million heights");
  }
  out.values.assign(out.rows * out.columns, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::copy(rows[i].begin(), rows[i].end(),
              out.values.begin() + static_cast<std::ptrdiff_t>(i * out.columns));
  }
  return out;
}

class Block {
 public:
  Block(const Heights& heights, bool center) : h_(heights) {
    if (center) {
      shift_ = -0.5 * Vec2(static_cast<double>(h_.columns - 1), static_cast<double>(h_.rows - 1));
    }
  }

  Solid run(RunContext& run) {
    double low = 0;
    for (const double v : h_.values) low = std::min(low, v - 1);
    for (std::size_t j = 0; j < h_.rows; ++j) {
      for (std::size_t i = 0; i < h_.columns; ++i) point(i, j, h_.at(i, j));
    }
    for (std::size_t j = 0; j + 1 < h_.rows; ++j) {
      run.check();
      for (std::size_t i = 0; i + 1 < h_.columns; ++i) square(i, j);
    }
    skirt(low);
    solid_.surface.assign(solid_.triangles.size(), -1);
    return std::move(solid_);
  }

 private:
  std::uint32_t point(double x, double y, double z) {
    solid_.positions.emplace_back(x + shift_.x, y + shift_.y, z);
    return static_cast<std::uint32_t>(solid_.positions.size()) - 1;
  }
  std::uint32_t point(std::size_t i, std::size_t j, double z) {
    return point(static_cast<double>(i), static_cast<double>(j), z);
  }
  std::uint32_t top(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(j * h_.columns + i);
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    solid_.triangles.push_back({a, b, c});
  }

  /// Four triangles about the mean of its corners.
  void square(std::size_t i, std::size_t j) {
    const std::array<std::uint32_t, 4> v{top(i, j), top(i + 1, j), top(i + 1, j + 1),
                                         top(i, j + 1)};
    double mean = 0;
    for (const std::uint32_t p : v) mean += solid_.positions[p].z / 4;
    const std::uint32_t m = point(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5, mean);
    for (std::size_t k = 0; k < 4; ++k) add(v[k], v[(k + 1) % 4], m);
  }

  /// The walls below the rim, and the bottom as a fan, whose corners all lie on a rectangle.
  void skirt(double low) {
    std::vector<std::uint32_t> rim;
    const std::size_t c = h_.columns - 1, r = h_.rows - 1;
    for (std::size_t i = 0; i < c; ++i) rim.push_back(top(i, 0));
    for (std::size_t j = 0; j < r; ++j) rim.push_back(top(c, j));
    for (std::size_t i = c; i > 0; --i) rim.push_back(top(i, r));
    for (std::size_t j = r; j > 0; --j) rim.push_back(top(0, j));
    const auto first = static_cast<std::uint32_t>(solid_.positions.size());
    const auto n = static_cast<std::uint32_t>(rim.size());
    for (const std::uint32_t p : rim) {
      const Vec3 at = solid_.positions[p];
      solid_.positions.emplace_back(at.x, at.y, low);
    }
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n;
      add(rim[k], first + k, first + next);
      add(rim[k], first + next, rim[next]);
    }
    const Vec2 middle(static_cast<double>(c) / 2, static_cast<double>(r) / 2);
    const std::uint32_t m = point(middle.x, middle.y, low);
    for (std::uint32_t k = 0; k < n; ++k) add(first + (k + 1) % n, first + k, m);
  }

  const Heights& h_;
  Vec2 shift_{0};
  Solid solid_;
};

}  // namespace

Solid height_map(Evaluation& e, std::uint32_t node) {
  return if_there(e, node, [&]() -> Solid {
    const std::filesystem::path path = file_of(e, node);
    const Source source(path, e.run);
    const Node& n = e.tree.nodes[node];
    const Heights heights =
        is_png(source) ? of_picture(path, n.truth("invert", false)) : of_text(source, e.run);
    if (heights.columns < 2 || heights.rows < 2) {
      source.fail("has less than two rows or columns of heights");
    }
    if (heights.values.size() > kMostHeights) source.fail("has more than five million heights");
    return Block(heights, n.truth("center", false)).run(e.run);
  });
}

}  // namespace burin::csg
