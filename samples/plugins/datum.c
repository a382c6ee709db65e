/* A symbol for notes: the letter of a datum in a frame (ISO 5459), and behind a bar what is said of it.
 * In an illustration: {"at": "base", "text": "A|flat 0.05", "symbol": "datum", "datum_bold": true} */
#include <burin/plugin.h>

#include <string.h>

/* What stands before or behind the bar, as far as it has room. */
static void piece(const char* text, int behind, char* to, size_t size) {
  const char* bar = strchr(text, '|');
  const char* from = !behind ? text : bar == NULL ? "" : bar + 1;
  size_t length = !behind && bar != NULL ? (size_t)(bar - text) : strcspn(from, "\n");
  if (length >= size) length = size - 1;
  memcpy(to, from, length);
  to[length] = '\0';
}

static int32_t draw(const burin_symbol_request* request, const burin_value* values, const burin_symbol_calls* calls,
                    burin_symbol* symbol, burin_symbol_box* box, burin_error* error) {
  const double h = request->height, line = request->line * (values[0].number != 0 ? 2 : 1);
  char words[256];
  double x = 0;
  int i;
  (void)error;
  box->height = 2 * h;
  box->shoulder = h;
  for (i = 0; i < 2; ++i) {
    double width, corners[8];
    piece(request->text, i, words, sizeof words);
    if (i == 1 && words[0] == '\0') break;
    width = calls->width(words, h) + h;
    if (width < 2 * h) width = 2 * h;
    corners[0] = corners[6] = x;
    corners[2] = corners[4] = x + width;
    corners[1] = corners[3] = 0;
    corners[5] = corners[7] = box->height;
    if (calls->line(symbol, 4, corners, line, 1) != BURIN_OK) return BURIN_FAILED;
    if (calls->text(symbol, x + 0.5 * width, 0.5 * h, h, 1, words) != BURIN_OK) return BURIN_FAILED;
    x += width;
  }
  box->width = x;
  return BURIN_OK;
}

static const burin_option options[] = {
    {"bold", "whether its frame is twice as wide", BURIN_FLAG, 0, 0, NULL, NULL, {0, {0, 0, 0}, NULL}}};
static const burin_symbol_1 functions = {draw};
static const burin_factory factories[] = {
    {BURIN_SYMBOL_1, "datum", "the letter of a datum (ISO 5459)", 1, options, &functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "datum", "1.0", 1, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &table : NULL; }
