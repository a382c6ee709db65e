/* Symbols that are broken in one way each, by what is defined. */
#include <burin/plugin.h>

#include <string.h>

static int32_t draw(const burin_symbol_request* request, const burin_value* values,
                    const burin_symbol_calls* calls, burin_symbol* symbol, burin_symbol_box* box,
                    burin_error* error) {
  static const double corners[6] = {0, 0, 5, 0, 0, 5};
  static const size_t counts[1] = {3};
  const char* color = "";
  (void)values;
  (void)box;
#ifdef BAD_COLOR
  color = "blue";
#endif
  if (calls->fill(symbol, 1, counts, corners, color) != BURIN_OK) return BURIN_FAILED;
#ifndef BAD_SIZE
  box->width = box->height = 5;
#endif
#ifdef BAD_LATER
  /* Not in what a trial asks for. */
  if (strchr(request->text, '|') != NULL) {
    strcpy(error->message, "no bar please");
    return BURIN_FAILED;
  }
#endif
  (void)request;
  (void)error;
  return BURIN_OK;
}

#ifdef BAD_LATER
#define NAME "later"
#else
#define NAME "bad-symbol"
#endif
static const burin_symbol_1 functions = {draw};
static const burin_factory factories[] = {{BURIN_SYMBOL_1, NAME, "broken", 0, NULL, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "bad-symbol", "1", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) {
  return abi == BURIN_PLUGIN_ABI ? &table : NULL;
}
