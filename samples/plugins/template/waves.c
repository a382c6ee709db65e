/* A law of tone to begin with: stripes of light across an axis.
 * burin draw vase.ply -o vase.svg --set tone.law=waves --set tone.waves.length=8 */
#include <burin/plugin.h>

#include <math.h>
#include <stdlib.h>

static int32_t make(const burin_view* view, const burin_value* values, void** self, burin_error* error) {
  double* length = malloc(sizeof *length);
  (void)view;
  (void)error;
  if (length == NULL) return BURIN_NO_MEMORY;
  *length = values[0].number;
  *self = length;
  return BURIN_OK;
}

static int32_t reflectances(const void* self, size_t count, const double* position, const double* normal,
                            double* reflectance, burin_error* error) {
  const double length = *(const double*)self;
  size_t i;
  (void)normal;
  (void)error;
  for (i = 0; i < count; ++i) reflectance[i] = 0.5 + 0.4 * sin(6.283185307179586 * position[3 * i + 2] / length);
  return BURIN_OK;
}

static const burin_option options[] = {
    {"length", "from stripe to stripe", BURIN_NUMBER, 0.1, 1000, "mm", NULL, {10, {0, 0, 0}, NULL}}};
static const burin_law_1 functions = {0, make, free, reflectances};
static const burin_factory factories[] = {
    {BURIN_LAW_1, "waves", "stripes of light across z", 1, options, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "waves", "1.0", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &table : NULL; }
