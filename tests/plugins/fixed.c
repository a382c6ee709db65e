/* The direction "fixed" of Burin's own as a plug-in. */
#include <burin/plugin.h>

#include <stdlib.h>
#include <string.h>

static int32_t make(const burin_view* view, const burin_value* values, void** self,
                    burin_error* error) {
  (void)values;
  (void)error;
  *self = malloc(sizeof view->axis);
  if (*self == NULL) return BURIN_NO_MEMORY;
  memcpy(*self, view->axis, sizeof view->axis);
  return BURIN_OK;
}

static int32_t directions(const void* self, const burin_points* points, double* first,
                          double* second, double* certainty, burin_error* error) {
  size_t i;
  (void)second;
  (void)error;
  for (i = 0; i < points->count; ++i) {
    memcpy(first + 3 * i, self, 3 * sizeof *first);
    certainty[i] = 0;
  }
  return BURIN_OK;
}

static const burin_direction_1 functions = {0, make, free, directions};
static const burin_factory factories[] = {
    {BURIN_DIRECTION_1, "bench-fixed", "hatch.direction", 0, NULL, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "bench-fixed", "1", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) {
  return abi == BURIN_PLUGIN_ABI ? &table : NULL;
}
