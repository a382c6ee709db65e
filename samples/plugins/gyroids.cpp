// A family of forms: walls along triply periodic surfaces, cut out of a cube.
// burin draw form:gyroids -o gyroids.svg --gyroids-surface diamond --gyroids-period 12
#include <burin/plugin.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <new>
#include <utility>

namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kSlope = 1.5;  // of these functions where they are 0, on average

struct Gyroids {
  double half, scale, wall;
  int surface;
};

// Of the periodic function: its value and its gradient, in turns.
std::pair<double, std::array<double, 3>> periodic(int surface, double x, double y, double z) {
  const double cx = std::cos(x), cy = std::cos(y), cz = std::cos(z);
  const double sx = std::sin(x), sy = std::sin(y), sz = std::sin(z);
  if (surface == 0) {  // gyroid
    return {sx * cy + sy * cz + sz * cx, {cx * cy - sz * sx, cy * cz - sx * sy, cz * cx - sy * sz}};
  }
  if (surface == 1) return {cx + cy + cz, {-sx, -sy, -sz}};  // Schwarz P
  return {sx * sy * sz + sx * cy * cz + cx * sy * cz + cx * cy * sz,  // diamond
          {cx * sy * sz + cx * cy * cz - sx * sy * cz - sx * cy * sz,
           sx * cy * sz - sx * sy * cz + cx * cy * cz - cx * sy * sz,
           sx * sy * cz - sx * cy * sz - cx * sy * sz + cx * cy * cz}};
}

std::int32_t make(const burin_value* values, void** self, burin_error*) {
  auto* const g = new (std::nothrow) Gyroids;
  if (!g) return BURIN_NO_MEMORY;
  *g = {0.5 * values[1].number, kTurn / values[2].number, values[3].number, static_cast<int>(values[0].number)};
  *self = g;
  return BURIN_OK;
}

std::int32_t bounds(const void* self, double low[3], double high[3], burin_error*) {
  const double half = static_cast<const Gyroids*>(self)->half;
  for (int i = 0; i < 3; ++i) low[i] = -(high[i] = half);
  return BURIN_OK;
}

// Negative within half a wall of the surface: the square of the distance, about.
std::int32_t values(const void* self, std::size_t count, const double* position, double* value, double* gradient,
                    burin_error*) {
  const auto& g = *static_cast<const Gyroids*>(self);
  for (std::size_t i = 0; i < count; ++i) {
    const double* p = position + 3 * i;
    const auto [f, slope] = periodic(g.surface, g.scale * p[0], g.scale * p[1], g.scale * p[2]);
    const double mm = kSlope * g.scale;
    value[i] = f * f / (mm * mm) - 0.25 * g.wall * g.wall;
    for (std::size_t k = 0; gradient && k < 3; ++k) gradient[3 * i + k] = 2 * f * g.scale * slope[k] / (mm * mm);
  }
  return BURIN_OK;
}

const char* const kSurfaces[] = {"gyroid", "schwarz-p", "diamond", nullptr};
const burin_option kOptions[] = {
    {"surface", "which surface the walls follow", BURIN_WORD, 0, 0, nullptr, kSurfaces, {0, {}, nullptr}},
    {"size", "of the cube", BURIN_NUMBER, 1, 1000, "mm", nullptr, {30, {}, nullptr}},
    {"period", "of the surface", BURIN_NUMBER, 1, 1000, "mm", nullptr, {15, {}, nullptr}},
    {"wall", "thickness of the walls, about", BURIN_NUMBER, 0.1, 100, "mm", nullptr, {2, {}, nullptr}}};
const burin_form_1 kFunctions = {0,      make,    [](void* self) { delete static_cast<Gyroids*>(self); },
                                 bounds, values, nullptr, nullptr};
const burin_factory kFactories[] = {
    {BURIN_FORM_1, "gyroids", "walls along a periodic surface", 4, kOptions, &kFunctions}};
const burin_plugin_table kTable = {BURIN_PLUGIN_ABI, "gyroids", "1.0", 1, kFactories};

}  // namespace

const burin_plugin_table* burin_plugin(std::uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &kTable : nullptr; }
