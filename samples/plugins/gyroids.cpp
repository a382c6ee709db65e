// A family of forms: walls along triply periodic surfaces, cut out of a cube.
// burin draw form:gyroids -o gyroids.svg --gyroids-surface diamond --gyroids-period 12
#include <burin/plugin.h>

#include <cmath>
#include <new>

namespace {

constexpr double kTurn = 6.283185307179586, kSlope = 1.5;  // of these functions at 0, on average

struct Gyroids {
  int surface;
  double half, scale, wall;
};

// A periodic function at angles x y z: its value, and its gradient in g.
double periodic(int surface, double x, double y, double z, double* g) {
  const double a = std::cos(x), b = std::cos(y), c = std::cos(z);
  const double s = std::sin(x), t = std::sin(y), u = std::sin(z);
  if (surface == 0) {  // gyroid
    g[0] = a * b - u * s, g[1] = b * c - s * t, g[2] = c * a - t * u;
    return s * b + t * c + u * a;
  }
  if (surface == 1) {  // Schwarz P
    g[0] = -s, g[1] = -t, g[2] = -u;
    return a + b + c;
  }
  g[0] = a * t * u + a * b * c - s * t * c - s * b * u;  // diamond
  g[1] = s * b * u - s * t * c + a * b * c - a * t * u;
  g[2] = s * t * c - s * b * u - a * t * u + a * b * c;
  return s * t * u + s * b * c + a * t * c + a * b * u;
}

int32_t make(const burin_value* v, void** self, burin_error*) {
  auto* const g = new (std::nothrow) Gyroids;
  if (!g) return BURIN_NO_MEMORY;
  *g = {static_cast<int>(v[0].number), v[1].number / 2, kTurn / v[2].number, v[3].number};
  *self = g;
  return BURIN_OK;
}

int32_t bounds(const void* self, double* low, double* high, burin_error*) {
  for (int i = 0; i < 3; ++i) low[i] = -(high[i] = static_cast<const Gyroids*>(self)->half);
  return BURIN_OK;
}

// Negative within half a wall of the surface: the square of the distance, about, less that.
int32_t values(const void* self, size_t n, const double* p, double* f, double* g, burin_error*) {
  const Gyroids& s = *static_cast<const Gyroids*>(self);
  const double mm = kSlope * s.scale;
  for (size_t i = 0; i < 3 * n; i += 3) {
    double slope[3];
    const double v =
        periodic(s.surface, s.scale * p[i], s.scale * p[i + 1], s.scale * p[i + 2], slope);
    f[i / 3] = v * v / (mm * mm) - 0.25 * s.wall * s.wall;
    for (size_t k = 0; g && k < 3; ++k) g[i + k] = 2 * v * s.scale * slope[k] / (mm * mm);
  }
  return BURIN_OK;
}

void destroy(void* self) { delete static_cast<Gyroids*>(self); }

const char* const kSurfaces[] = {"gyroid", "schwarz-p", "diamond", nullptr};
const burin_option kOptions[] = {
    {"surface", "what the walls follow", BURIN_WORD, 0, 0, nullptr, kSurfaces, {}},
    {"size", "of the cube", BURIN_NUMBER, 1, 1000, "mm", nullptr, {30, {}, nullptr}},
    {"period", "of the surface", BURIN_NUMBER, 1, 1000, "mm", nullptr, {15, {}, nullptr}},
    {"wall", "its thickness, about", BURIN_NUMBER, 0.1, 100, "mm", nullptr, {2, {}, nullptr}}};
const burin_form_1 kForm = {0, make, destroy, bounds, values, nullptr, nullptr};
const burin_factory kOffers[] = {{BURIN_FORM_1, "gyroids", "periodic walls", 4, kOptions, &kForm}};
const burin_plugin_table kTable = {BURIN_PLUGIN_ABI, "gyroids", "1.0", 1, kOffers};

}  // namespace

const burin_plugin_table* burin_plugin(uint32_t abi) {
  return abi == BURIN_PLUGIN_ABI ? &kTable : nullptr;
}
