#include "exchange.h"

#include <burin/base/error.h>
#include <burin/base/platform.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <type_traits>

namespace burin::csg {
namespace {

constexpr std::uint64_t kMagic = 0x3230'6769'7275'6273;

[[noreturn]] void fail(const char* what) {
  throw Error(std::string("what the evaluator of trees and its parent share: ") + what);
}

/// Rows without pointers are written as they lie in memory: both sides are one build.
template <class T>
void put(std::string& out, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
void put_all(std::string& out, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  put(out, static_cast<std::uint64_t>(values.size()));
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

class Taker {
 public:
  explicit Taker(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T take() {
    T value;
    if (bytes_.size() < sizeof value) fail("it ends too early");
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> take_all() {
    const auto n = take<std::uint64_t>();
    if (n > bytes_.size() / sizeof(T)) fail("it ends too early");
    std::vector<T> out(n);
    if (n > 0) std::memcpy(static_cast<void*>(out.data()), bytes_.data(), n * sizeof(T));
    bytes_.remove_prefix(n * sizeof(T));
    return out;
  }

 private:
  std::string_view bytes_;
};

void put_surface(std::string& out, const Turned& t) {
  for (const Vec3& v : {t.origin, t.axis}) put(out, v);
  for (const double d : {t.step, t.radius, t.profile_step}) put(out, d);
  for (const Vec2& v : {t.a, t.b, t.middle}) put(out, v);
  put(out, t.profile);
  if (t.profile != Turned::Profile::Grid) return;
  put(out, t.grid->rows);
  put(out, t.grid->columns);
  put(out, t.grid->rows_close);
  put(out, t.grid->columns_close);
  put_all(out, t.grid->points);
  put_all(out, t.grid->row_knots);
  put_all(out, t.grid->column_knots);
  put(out, t.grid->window);
}

PointGrid take_grid(Taker& in) {
  PointGrid g;
  g.rows = in.take<std::int32_t>();
  g.columns = in.take<std::int32_t>();
  g.rows_close = in.take<bool>();
  g.columns_close = in.take<bool>();
  g.points = in.take_all<Vec3>();
  g.row_knots = in.take_all<double>();
  g.column_knots = in.take_all<double>();
  g.window = in.take<GridWindow>();
  const auto fits = [](std::size_t n, std::int32_t of) {
    return n == static_cast<std::size_t>(of);
  };
  const bool whole =
      g.rows >= 2 && g.columns >= 2 &&
      g.points.size() == static_cast<std::size_t>(g.rows) * static_cast<std::size_t>(g.columns) &&
      fits(g.row_knots.size(), g.cell_rows() + 1) &&
      fits(g.column_knots.size(), g.cell_columns() + 1);
  if (!whole) fail("it does not fit together");
  return g;
}

Turned take_surface(Taker& in) {
  Turned t;
  for (Vec3* v : {&t.origin, &t.axis}) *v = in.take<Vec3>();
  for (double* d : {&t.step, &t.radius, &t.profile_step}) *d = in.take<double>();
  for (Vec2* v : {&t.a, &t.b, &t.middle}) *v = in.take<Vec2>();
  t.profile = in.take<Turned::Profile>();
  if (t.profile == Turned::Profile::Grid) {
    t.grid = std::make_shared<const PointGrid>(take_grid(in));
  }
  return t;
}

}  // namespace

void write_text(int descriptor, const std::string& text) {
  if (!platform::replace_content(descriptor, text)) fail(std::strerror(errno));
}

std::string read_text(int descriptor) {
  std::string text;
  if (!platform::read_content(descriptor, text)) fail(std::strerror(errno));
  return text;
}

void write_solids(int descriptor, const std::vector<Solid>& solids) {
  std::string out;
  put(out, kMagic);
  put(out, static_cast<std::uint64_t>(solids.size()));
  for (const Solid& s : solids) {
    put_all(out, s.positions);
    put_all(out, s.triangles);
    put_all(out, s.surface);
    put(out, static_cast<std::uint64_t>(s.surfaces.size()));
    for (const Turned& t : s.surfaces) put_surface(out, t);
  }
  write_text(descriptor, out);
}

std::vector<Solid> read_solids(int descriptor) {
  const std::string bytes = read_text(descriptor);
  Taker in(bytes);
  if (in.take<std::uint64_t>() != kMagic) fail("it is no result");
  std::vector<Solid> out;
  for (auto n = in.take<std::uint64_t>(); n > 0; --n) {
    Solid s;
    s.positions = in.take_all<Vec3>();
    s.triangles = in.take_all<std::array<std::uint32_t, 3>>();
    s.surface = in.take_all<std::int32_t>();
    for (auto rows = in.take<std::uint64_t>(); rows > 0; --rows) {
      s.surfaces.push_back(take_surface(in));
    }
    if (s.surface.size() != s.triangles.size()) fail("it does not fit together");
    for (const auto& t : s.triangles) {
      for (const std::uint32_t v : t) {
        if (v >= s.positions.size()) fail("it does not fit together");
      }
    }
    for (const std::int32_t v : s.surface) {
      if (v < -1 || v >= static_cast<std::int32_t>(s.surfaces.size()))
        fail("it does not fit together");
    }
    out.push_back(std::move(s));
  }
  return out;
}

}  // namespace burin::csg
