/** @file
 * What a plug-in of Burin is made from: plain C99 that needs nothing else. kernel/docs/plugins.md
 * is the tutorial.
 *
 * A plug-in is a shared library with one exported symbol, `burin_plugin`, that gives a table of
 * factories. Each has the id of an interface ("burin.direction/1") and a name, under which styles,
 * files and programs ask for it. The structs of an interface never change; what grows gets a new
 * id, and a host leaves out the ids that it does not know.
 *
 * Holds for all functions: lengths in model mm and angles in radians where nothing else stands,
 * coordinates as x y z one after the other. Arrays and texts of a call belong to the host and live
 * until it returns; tables and their texts belong to the plug-in and live as long as the process. A
 * function returns BURIN_OK or another code and then writes its reason into `error`. Nothing may be
 * thrown, no signal handler set, no locale changed.
 */
#ifndef BURIN_PLUGIN_H
#define BURIN_PLUGIN_H

/* This is C. */
/* NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using) */
/* NOLINTBEGIN(readability-identifier-naming) */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_PLUGIN_ABI 1
#define BURIN_PLUGIN_EXPORT __attribute__((visibility("default")))

#define BURIN_DIRECTION_1 "burin.direction/1"
#define BURIN_LAW_1 "burin.law/1"
#define BURIN_STROKE_KIND_1 "burin.stroke-kind/1"
#define BURIN_FORM_1 "burin.form/1"
#define BURIN_READER_1 "burin.reader/1"
#define BURIN_WRITER_1 "burin.writer/1"
#define BURIN_WRITER_2 "burin.writer/2"
#define BURIN_SYMBOL_1 "burin.symbol/1"

enum burin_code {
  BURIN_OK = 0,
  BURIN_FAILED = 1,
  BURIN_BAD_OPTION = 2, /* options that contradict each other */
  BURIN_BAD_INPUT = 3,  /* a file that is broken */
  BURIN_NO_MEMORY = 4,
  BURIN_CANCELLED = 5 /* the host said so */
};

/** Of the host, zeroed before the call. One sentence without a full stop, UTF-8. */
typedef struct burin_error {
  int32_t line; /* of a file, from 1; 0: none */
  char message[396];
} burin_error;

/** A value of an option: `number` (a flag: 0 or 1; a word: its place in the list), `vector` or
 * `text`. */
typedef struct burin_value {
  double number;
  double vector[3];
  const char* text;
} burin_value;

enum burin_option_kind {
  BURIN_NUMBER = 0, /* low to high */
  BURIN_WHOLE = 1,  /* a whole number, 0 <= low to high < 2^53 */
  BURIN_FLAG = 2,
  BURIN_WORD = 3,
  BURIN_VECTOR = 4, /* any but zero */
  BURIN_TEXT = 5
};

/** A choice of the user. The host tests values before it hands them on, in the order of the
 * options. */
typedef struct burin_option {
  const char* name;    /* letters a-z, digits and _ ; begins with a letter */
  const char* meaning; /* one sentence without a full stop */
  int32_t kind;
  double low, high;
  const char* unit;         /* may be null */
  const char* const* words; /* of BURIN_WORD, null behind the last */
  burin_value fallback;     /* where the user says nothing */
} burin_option;

/** What is drawn from where. Unit vectors in model space. */
typedef struct burin_view {
  double to_viewer[3], right[3], up[3];
  double eye[3];       /* where the viewer stands, in perspective */
  int32_t perspective; /* 0 or 1 */
  double scale;        /* paper mm a model mm; in perspective: at the centre */
  double to_light[3];
  double axis[3];         /* the direction that the user gives all directions, hatch.direction */
  double low[3], high[3]; /* the box of all that is drawn */
} burin_view;

/** Places of surfaces. An array is one number a point, or three; all are as long. */
typedef struct burin_points {
  size_t count;
  const double* position; /* 3 */
  const double* normal;   /* 3: unit, to the outside */
  const double* k1;       /* principal curvatures, 1/mm, k1 >= k2, positive on a sphere */
  const double* k2;
  const double* d1; /* 3: their directions; zero where there are none */
  const double* d2; /* 3 */
  const double* du; /* 3: derivatives along the parameters; zero where a form has none */
  const double* dv; /* 3 */
  const int32_t* part;
} burin_points;

enum burin_needs {
  BURIN_NEEDS_CURVATURE = 1, /* k1 k2 d1 d2; without it they may be zero */
  BURIN_NEEDS_LIGHT = 2,     /* looks at burin_view.to_light */
  BURIN_ONE_THREAD = 4       /* the host never calls it twice at the same time; slower */
};

/** Which way strokes run. `make` is called once a drawing, the other function from many threads at
 * once with the same `self`, which it may not change; each thread gets the same answer for the same
 * point, however many points a call has. */
typedef struct burin_direction_1 {
  uint32_t needs; /* burin_needs */
  int32_t (*make)(const burin_view* view, const burin_value* values, void** self,
                  burin_error* error);
  void (*destroy)(
      void* self); /* once for each `make` that went well; may be null, as in all interfaces */
  /** Writes, one a point, `first`: the way of family 1 (3; any length, the host takes the part
   * along the surface; zero as it comes: there is none); `second`: of family 2 (3; zero as it
   * comes: at a right angle to the first); `certainty`: where strokes begin first, 0 to 1 (0.5 as
   * it comes). */
  int32_t (*directions)(const void* self, const burin_points* points, double* first, double* second,
                        double* certainty, burin_error* error);
} burin_direction_1;

/** How light a place is. As burin_direction_1. */
typedef struct burin_law_1 {
  uint32_t needs; /* burin_needs, without curvature */
  int32_t (*make)(const burin_view* view, const burin_value* values, void** self,
                  burin_error* error);
  void (*destroy)(void* self);
  /** Writes one reflectance a point: 0 full ink, 1 white paper; the host cuts what lies outside.
   * Normals are turned to the viewer. */
  int32_t (*reflectances)(const void* self, size_t count, const double* position,
                          const double* normal, double* reflectance, burin_error* error);
} burin_law_1;

/** Points of the picture that strokes stand on. */
typedef struct burin_places {
  size_t count;
  const double* position;  /* 3 */
  const double* normal;    /* 3: to the viewer */
  const double* direction; /* 3: unit, the way of family 1 */
  const double* ink;       /* the share of the paper that the tone asks for */
  const double* random;    /* in [0, 1), of the place */
} burin_places;

/** What stands on points in the place of strokes: a few lines a point. Host and surface do the
 * rest: which points, which way, the march over the surface, what is hidden, how wide the pen is.
 */
typedef struct burin_stroke_kind_1 {
  uint32_t needs; /* BURIN_ONE_THREAD or 0 */
  size_t most;    /* points of a mark, 2 to 1024 */
  int32_t (*make)(const burin_view* view, const burin_value* values, void** self,
                  burin_error* error);
  void (*destroy)(void* self);
  /** Writes one mark a place: `count`, how many points it has (0: nothing is drawn; at most
   * `most`); and from 2 * `most` * place on in `points`, as shares of hatch.length from the place:
   * along the direction, which is turned to run to the right on paper, and to its left; a mark is
   * about 1 large. `begins`, from `most` * place on: 1 where a point begins a new line, else 0. */
  int32_t (*marks)(const void* self, const burin_places* places, uint32_t* count, double* points,
                   unsigned char* begins, burin_error* error);
} burin_stroke_kind_1;

/** A surface: the zero set of a function, negative inside, where `values` is given; else S(u,v)
 * where `points` is. The kernel covers it, marches on it and cuts its contours. From many threads
 * at once, as burin_direction_1. */
typedef struct burin_form_1 {
  uint32_t needs; /* BURIN_ONE_THREAD or 0 */
  int32_t (*make)(const burin_value* values, void** self, burin_error* error);
  void (*destroy)(void* self);
  /** The box that is drawn: min, max. Of functions; may be null for S(u,v). */
  int32_t (*bounds)(const void* self, double low[3], double high[3], burin_error* error);
  /** `value` one a point; `gradient` three, or null where it is not asked. */
  int32_t (*values)(const void* self, size_t count, const double* position, double* value,
                    double* gradient, burin_error* error);
  /** Where u and v run: u from domain[0] to domain[1], v from domain[2] to domain[3]; `closed[0]`,
   * `closed[1]`: 1 where the surface comes back to where it began. */
  int32_t (*domain)(const void* self, double domain[4], int32_t closed[2], burin_error* error);
  /** For `uv` (2 a point): S and its derivatives (3 each); the normal is du x dv. */
  int32_t (*points)(const void* self, size_t count, const double* uv, double* position, double* du,
                    double* dv, burin_error* error);
} burin_form_1;

/** What a reader fills, and how. All return BURIN_OK or what the reader has to return at once. */
typedef struct burin_scene burin_scene;
typedef struct burin_scene_calls {
  /** A part of triangles, outside to the left of their edges; copied. `corners`: three a triangle.
   */
  int32_t (*mesh)(burin_scene* scene, const char* name, size_t points, const double* position,
                  size_t triangles, const uint32_t* corners);
  /** Something that was mended or left out: 0 information, 1 warning. `code`: "tiny.no_name". */
  int32_t (*report)(burin_scene* scene, int32_t severity, const char* code, int64_t count,
                    const char* message);
  /** The share that is done, 0 to 1; now and then. */
  int32_t (*progress)(burin_scene* scene, double share);
} burin_scene_calls;

/** A family of files. One thread calls it. */
typedef struct burin_reader_1 {
  const char* suffixes; /* ".tiny .tny", lower case */
  /** Whether the first bytes (up to 4096) can only be such a file: 1, else 0. May be null: the
   * suffix decides. */
  int32_t (*knows)(const unsigned char* head, size_t size);
  int32_t (*read)(const char* path, const unsigned char* bytes, size_t size,
                  const burin_value* values, const burin_scene_calls* calls, burin_scene* scene,
                  burin_error* error);
} burin_reader_1;

/** A drawing as it is written: paper mm, the origin at the bottom left, y up. */
typedef struct burin_path {
  const char* layer;
  const char* kind; /* "contour", "crease", "stroke" ... */
  int32_t part;     /* its number; -1: none */
  int32_t visible, closed;
  size_t first, count; /* points */
} burin_path;
typedef struct burin_text {
  const char* text;
  double x, y, height; /* on the base line; of capital letters */
  int32_t anchor;      /* what stands at x: 0 the start, 1 the middle, 2 the end */
} burin_text;
typedef struct burin_drawing {
  double width, height;
  const char* title;
  const char *ink, *paper; /* "#rrggbb" */
  size_t part_count;
  const char* const* parts;
  size_t path_count;
  const burin_path* paths; /* in the order of drawing */
  size_t point_count;
  const double* points; /* 2 a point */
  const double* widths; /* 1 a point */
  size_t text_count;
  const burin_text* texts;
  const double* text_turns; /* 1 a text: degrees about its place, anticlockwise */
} burin_drawing;

/** What a writer writes to: BURIN_OK, or what the writer has to return at once. */
typedef struct burin_output burin_output;
typedef int32_t (*burin_write)(burin_output* output, const void* bytes, size_t size);

/** A format. One thread calls it. The same drawing has to give the same bytes. */
typedef struct burin_writer_1 {
  const char* suffix; /* "txt" */
  int32_t (*write)(const burin_drawing* drawing, const burin_value* values, burin_write write,
                   burin_output* output, burin_error* error);
} burin_writer_1;

/** A region in one colour, below the lines. It goes on under regions that follow. */
typedef struct burin_area {
  int32_t part, face;  /* their numbers; -1: none; all faces that are seen */
  int32_t tone;        /* 0: the darkest; -1: none */
  const char* fill;    /* "#rrggbb"; "": nothing is painted */
  double opacity;      /* 0 to 1 */
  const char* ink;     /* the name of a spot ink; "": none */
  double tint;         /* the share of that ink, 0 to 1 */
  const char* role;    /* "legend": a square of it; "": what is seen of the part */
  size_t first, count; /* rings; inside is what an odd number of them holds */
} burin_area;
typedef struct burin_ring {
  size_t first, count; /* points; the last one joins the first */
} burin_ring;
typedef struct burin_ink {
  const char* name;
  const char* color; /* "#rrggbb", of all of it */
} burin_ink;
typedef struct burin_color_drawing {
  const burin_drawing* lines;
  const char* const* path_colors; /* "#rrggbb", one a path of `lines` */
  size_t area_count;
  const burin_area* areas; /* in the order of painting */
  size_t ring_count;
  const burin_ring* rings;
  size_t point_count;
  const double* points; /* of the rings: 2 a point */
  size_t ink_count;
  const burin_ink* inks;
} burin_color_drawing;

/** A format with colours. As burin_writer_1, in whose place it comes where a plug-in has both of
 * one suffix. */
typedef struct burin_writer_2 {
  const char* suffix;
  int32_t (*write)(const burin_color_drawing* drawing, const burin_value* values, burin_write write,
                   burin_output* output, burin_error* error);
} burin_writer_2;

/** What a symbol is drawn for. */
typedef struct burin_symbol_request {
  const char* text; /* of the note; lines are parted by "\n" */
  double height;    /* paper mm of capital letters */
  double line;      /* paper mm: the width of lines */
} burin_symbol_request;

/** What a symbol is made of: paper mm from its lower left corner, y up. All return BURIN_OK or what
 * the symbol has to return at once, but `width`. */
typedef struct burin_symbol burin_symbol;
typedef struct burin_symbol_calls {
  /** `points`: 2 a point, 2 to 10,000 of them. `closed`: 1 where the last one joins the first. */
  int32_t (*line)(burin_symbol* symbol, size_t count, const double* points, double width,
                  int32_t closed);
  /** Inside is what an odd number of rings holds; `counts`: points of each, 3 to 10,000 in all.
   * `color`: "#rrggbb"; "": that of lines. Later fills lie over earlier ones. */
  int32_t (*fill)(burin_symbol* symbol, size_t rings, const size_t* counts, const double* points,
                  const char* color);
  /** A line of text; `x`, `y`, `anchor` as of burin_text. */
  int32_t (*text)(burin_symbol* symbol, double x, double y, double height, int32_t anchor,
                  const char* text);
  /** How wide a line of text is, paper mm. */
  double (*width)(const char* text, double height);
} burin_symbol_calls;

/** Where it ends: its width and height, and where its leader meets its left or right side, above
 * the lower edge; `underlined`: 1 where the leader goes on below it, from side to side. */
typedef struct burin_symbol_box {
  double width, height, shoulder;
  int32_t underlined;
} burin_symbol_box;

/** What stands at the end of the leader of a note. One thread calls it, once a note. */
typedef struct burin_symbol_1 {
  int32_t (*draw)(const burin_symbol_request* request, const burin_value* values,
                  const burin_symbol_calls* calls, burin_symbol* symbol, burin_symbol_box* box,
                  burin_error* error);
} burin_symbol_1;

typedef struct burin_factory {
  const char* id;      /* BURIN_DIRECTION_1 ... */
  const char* name;    /* letters a-z, digits and - ; begins with a letter */
  const char* meaning; /* a few words */
  size_t option_count;
  const burin_option* options;
  const void* functions; /* the struct of the interface */
} burin_factory;

typedef struct burin_plugin_table {
  uint32_t abi;     /* BURIN_PLUGIN_ABI */
  const char* name; /* as of a factory */
  const char* version;
  size_t factory_count;
  const burin_factory* factories;
} burin_plugin_table;

/** The one symbol. `abi`: that of the host. Called once, before anything else. */
BURIN_PLUGIN_EXPORT const burin_plugin_table* burin_plugin(uint32_t abi);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(readability-identifier-naming) */
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
#endif
