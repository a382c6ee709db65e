/* Plug-ins that are broken in one way each, by what is defined. */
#include <burin/plugin.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int32_t make(const burin_view* view, const burin_value* values, void** self,
                    burin_error* error) {
  (void)view;
  (void)values;
  (void)self;
  (void)error;
#ifdef BAD_MAKE
  strcpy(error->message, "no licence");
  return BURIN_FAILED;
#elif defined(BAD_CRASH_IN_MAKE)
  abort();
#else
  return BURIN_OK;
#endif
}

static int32_t directions(const void* self, const burin_points* points, double* first,
                          double* second, double* certainty, burin_error* error) {
  size_t i;
  (void)self;
  (void)second;
  (void)certainty;
  (void)error;
  for (i = 0; i < points->count; ++i) {
    /* Farther off than any place of the trial. */
    const int far = fabs(points->position[3 * i]) > 6;
    first[3 * i] = 1;
    (void)far;
#ifdef BAD_NAN_LATER
    if (far) first[3 * i] = NAN;
#elif defined(BAD_ERROR_LATER)
    if (far) {
      strcpy(error->message, "too far\noff");
      return BURIN_FAILED;
    }
#elif defined(BAD_NAN)
    first[3 * i] = NAN;
#elif defined(BAD_COUNT)
    first[3 * points->count] = 1;
#elif defined(BAD_LIE)
    first[3 * i + 1] = (double)points->count;
#endif
  }
  return BURIN_OK;
}

#ifdef BAD_ABI
#define ABI 2
#else
#define ABI BURIN_PLUGIN_ABI
#endif
#ifdef BAD_NAME
#define NAME "Not A Name"
#elif defined(BAD_TAKEN)
#define NAME "smoothed"
#elif defined(BAD_NAN_LATER)
#define NAME "nan-later"
#elif defined(BAD_ERROR_LATER)
#define NAME "error-later"
#else
#define NAME "bad"
#endif

static const burin_option options[] = {{"turn",
                                        "how far",
                                        BURIN_NUMBER,
                                        0,
                                        1,
                                        NULL,
                                        NULL,
#ifdef BAD_OPTION
                                        {2, {0, 0, 0}, NULL}
#else
                                        {0, {0, 0, 0}, NULL}
#endif
}};
static const burin_direction_1 functions = {0, make, NULL, directions};
static const burin_factory factories[] = {
    {BURIN_DIRECTION_1, NAME, "broken", 1, options, &functions},
    {"burin.direction/9", "newer", NULL, 0, NULL, NULL}};
static const burin_plugin_table table = {ABI, "bad", "1", 2, factories};

#ifdef BAD_SYMBOL
#define burin_plugin another_symbol
BURIN_PLUGIN_EXPORT const burin_plugin_table* burin_plugin(uint32_t abi);
#endif

const burin_plugin_table* burin_plugin(uint32_t abi) {
  (void)abi;
#ifdef BAD_CRASH
  *(volatile int*)0 = 1;
#elif defined(BAD_HANG)
  for (volatile int go = 1; go;) {
  }
#elif defined(BAD_EXIT)
  exit(0);
#elif defined(BAD_NULL)
  return NULL;
#endif
  return &table;
}
