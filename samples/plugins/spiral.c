/* A direction: strokes wind about an axis through the middle of the model and climb as they go.
 * burin draw vase.ply -o vase.svg --set hatch.field=spiral --set hatch.spiral.climb=20 */
#include <burin/plugin.h>

#include <math.h>
#include <stdlib.h>

struct spiral {
  double axis[3], middle[3];
  double climb; /* tangent of the angle */
};

static int32_t make(const burin_view* view, const burin_value* values, void** self, burin_error* error) {
  struct spiral* s = malloc(sizeof *s);
  int i;
  (void)error;
  if (s == NULL) return BURIN_NO_MEMORY;
  for (i = 0; i < 3; ++i) {
    s->axis[i] = view->axis[i];
    s->middle[i] = 0.5 * (view->low[i] + view->high[i]);
  }
  s->climb = tan(values[0].number * 3.14159265358979323846 / 180);
  *self = s;
  return BURIN_OK;
}

static int32_t directions(const void* self, const burin_points* points, double* first, double* second,
                          double* certainty, burin_error* error) {
  const struct spiral* s = self;
  size_t i;
  (void)second; /* at a right angle to the first, as it comes */
  (void)error;
  for (i = 0; i < points->count; ++i) {
    const double* p = points->position + 3 * i;
    const double* a = s->axis;
    const double r[3] = {p[0] - s->middle[0], p[1] - s->middle[1], p[2] - s->middle[2]};
    const double around[3] = {a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
    const double size = sqrt(around[0] * around[0] + around[1] * around[1] + around[2] * around[2]);
    int k;
    for (k = 0; k < 3; ++k) first[3 * i + k] = around[k] + s->climb * size * a[k];
    certainty[i] = 1;
  }
  return BURIN_OK;
}

static const burin_option options[] = {
    {"climb", "how steeply strokes climb along the axis", BURIN_NUMBER, -89, 89, "degrees", NULL, {15, {0, 0, 0}, NULL}}};
static const burin_direction_1 functions = {0, make, free, directions};
static const burin_factory factories[] = {
    {BURIN_DIRECTION_1, "spiral", "spirals about hatch.direction", 1, options, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "spiral", "1.0", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &table : NULL; }
