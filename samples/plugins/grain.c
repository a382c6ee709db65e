/* A law of tone for dots: light falls in a few steps, and grain breaks their borders up.
 * burin draw vase.ply -o vase.svg --style stipple --set tone.law=grain --set tone.grain.steps=3 */
#include <burin/plugin.h>

#include <math.h>
#include <stdlib.h>

struct grain {
  double light[3];
  double steps, amount, size;
};

static int32_t make(const burin_view* view, const burin_value* values, void** self, burin_error* error) {
  struct grain* g = malloc(sizeof *g);
  int i;
  (void)error;
  if (g == NULL) return BURIN_NO_MEMORY;
  for (i = 0; i < 3; ++i) g->light[i] = view->to_light[i];
  g->steps = values[0].number;
  g->amount = values[1].number;
  g->size = values[2].number / view->scale; /* paper mm to model mm */
  *self = g;
  return BURIN_OK;
}

/* A number in [0,1) of a cell of space: the same wherever and whenever it is asked. */
static double chance(double x, double y, double z) {
  const int64_t c[3] = {(int64_t)x, (int64_t)y, (int64_t)z};
  uint64_t h = 0x9E3779B97F4A7C15u;
  int i;
  for (i = 0; i < 3; ++i) {
    h = (h ^ (uint64_t)c[i]) * 0xBF58476D1CE4E5B9u;
    h ^= h >> 29;
  }
  return (double)(h >> 11) / 9007199254740992.0;
}

static int32_t reflectances(const void* self, size_t count, const double* position, const double* normal,
                            double* reflectance, burin_error* error) {
  const struct grain* g = self;
  size_t i;
  (void)error;
  for (i = 0; i < count; ++i) {
    const double* p = position + 3 * i;
    const double* n = normal + 3 * i;
    const double lit = fmax(0, n[0] * g->light[0] + n[1] * g->light[1] + n[2] * g->light[2]);
    const double r = chance(floor(p[0] / g->size), floor(p[1] / g->size), floor(p[2] / g->size)) - 0.5;
    const double level = floor(g->steps * lit + g->amount * r + 0.5) / g->steps;
    reflectance[i] = 0.1 + 0.9 * fmin(1, fmax(0, level));
  }
  return BURIN_OK;
}

static const burin_option options[] = {
    {"steps", "levels of light beside the darkest", BURIN_WHOLE, 1, 16, NULL, NULL, {4, {0, 0, 0}, NULL}},
    {"amount", "how far grain moves the border of two levels, in levels", BURIN_NUMBER, 0, 2, NULL, NULL, {0.8, {0, 0, 0}, NULL}},
    {"size", "of a grain on paper", BURIN_NUMBER, 0.1, 10, "mm", NULL, {0.6, {0, 0, 0}, NULL}}};
static const burin_law_1 functions = {BURIN_NEEDS_LIGHT, make, free, reflectances};
static const burin_factory factories[] = {
    {BURIN_LAW_1, "grain", "steps of light with grain, for dots", 3, options, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "grain", "1.0", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &table : NULL; }
