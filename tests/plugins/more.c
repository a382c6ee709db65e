/* One plug-in with what the samples have none of: a stroke kind, S(u,v), a law and writers. */
#include <burin/plugin.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int32_t make_nothing(const burin_view* view, const burin_value* values, void** self,
                            burin_error* error) {
  double* kept = malloc(sizeof *kept);
  (void)view;
  (void)error;
  *kept = values[0].number;
  *self = kept;
  return kept == NULL ? BURIN_NO_MEMORY : BURIN_OK;
}

/* A star of as many rays as the option says. */
static int32_t stars(const void* self, const burin_places* places, uint32_t* count, double* points,
                     unsigned char* begins, burin_error* error) {
  const int rays = (int)*(const double*)self;
  size_t i;
  (void)error;
  for (i = 0; i < places->count; ++i) {
    double* p = points + 2 * 32 * i;
    int k;
    count[i] = (uint32_t)(2 * rays);
    for (k = 0; k < rays; ++k) {
      const double angle = 6.283185307179586 * (k + places->random[i]) / rays;
      p[4 * k] = p[4 * k + 1] = 0;
      p[4 * k + 2] = 0.5 * cos(angle);
      p[4 * k + 3] = 0.5 * sin(angle);
      begins[32 * i + 2 * (size_t)k] = 1;
    }
  }
  return BURIN_OK;
}

static int32_t make_form(const burin_value* values, void** self, burin_error* error) {
  return make_nothing(NULL, values, self, error);
}
/* A torus: radius 10, tube as the option says. */
static int32_t domain(const void* self, double d[4], int32_t closed[2], burin_error* error) {
  (void)self;
  (void)error;
  d[0] = d[2] = 0;
  d[1] = d[3] = 6.283185307179586;
  closed[0] = closed[1] = 1;
  return BURIN_OK;
}
static int32_t torus(const void* self, size_t n, const double* uv, double* s, double* du,
                     double* dv, burin_error* error) {
  const double tube = *(const double*)self;
  size_t i;
  (void)error;
  for (i = 0; i < n; ++i) {
    const double cu = cos(uv[2 * i]), su = sin(uv[2 * i]), cv = cos(uv[2 * i + 1]),
                 sv = sin(uv[2 * i + 1]);
    const double r = 10 + tube * cv;
    s[3 * i] = r * cu, s[3 * i + 1] = r * su, s[3 * i + 2] = tube * sv;
    du[3 * i] = -r * su, du[3 * i + 1] = r * cu, du[3 * i + 2] = 0;
    dv[3 * i] = -tube * sv * cu, dv[3 * i + 1] = -tube * sv * su, dv[3 * i + 2] = tube * cv;
  }
  return BURIN_OK;
}

/* A function that may fail where it is asked about a place and its neighbours: curvature is, its
 * trial does not. */
static int32_t ball_bounds(const void* self, double low[3], double high[3], burin_error* error) {
  int i;
  (void)self;
  (void)error;
  for (i = 0; i < 3; ++i) low[i] = -(high[i] = 6);
  return BURIN_OK;
}
static int32_t ball(const void* self, size_t n, const double* p, double* f, double* g,
                    burin_error* error) {
  static double neighbours = 0;
  const double most = *(const double*)self;
  size_t i, k;
  (void)error;
  if (most > 0 && n == 7 && fabs(p[0] - p[3]) < 1e-3 && ++neighbours > most) return BURIN_FAILED;
  for (i = 0; i < n; ++i) {
    f[i] = -25;
    for (k = 0; k < 3; ++k) f[i] += p[3 * i + k] * p[3 * i + k];
    for (k = 0; g != NULL && k < 3; ++k) g[3 * i + k] = 2 * p[3 * i + k];
  }
  return BURIN_OK;
}

/* A line a path: how many points, and the width of the first. */
static int32_t write_list(const burin_drawing* d, const burin_value* values, burin_write write,
                          burin_output* output, burin_error* error) {
  size_t i;
  (void)error;
  if (values[0].number == 0) return BURIN_OK; /* and writes nothing */
  for (i = 0; i < d->path_count; ++i) {
    const burin_path* p = d->paths + i;
    char line[100];
    const int n = snprintf(line, sizeof line, "%s %zu %.*f\n", p->kind, p->count,
                           (int)values[0].number, d->widths[p->first]);
    const int32_t code = write(output, line, (size_t)n);
    if (code != BURIN_OK) return code;
  }
  return BURIN_OK;
}

/* A line an area, and the colour of the first path. */
static int32_t write_areas(const burin_color_drawing* d, const burin_value* values,
                           burin_write write, burin_output* output, burin_error* error) {
  char line[200];
  size_t i, k, j;
  int n;
  int32_t code;
  (void)error;
  (void)values;
  n = snprintf(line, sizeof line, "%s %zu %s\n",
               d->lines->path_count > 0 ? d->path_colors[0] : "none", d->ink_count,
               d->ink_count > 0 ? d->inks[0].name : "none");
  code = write(output, line, (size_t)n);
  for (i = 0; code == BURIN_OK && i < d->area_count; ++i) {
    const burin_area* a = d->areas + i;
    double twice = 0; /* the area, where no ring lies in another */
    for (k = a->first; k < a->first + a->count; ++k) {
      const double* p = d->points + 2 * d->rings[k].first;
      const size_t m = d->rings[k].count;
      double of_ring = 0;
      for (j = 0; j < m; ++j) {
        const size_t next = (j + 1) % m;
        of_ring += p[2 * j] * p[2 * next + 1] - p[2 * next] * p[2 * j + 1];
      }
      twice += fabs(of_ring);
    }
    n = snprintf(line, sizeof line, "%d %d %d %s %.3f %s %.3f [%s] %.2f\n", (int)a->part,
                 (int)a->face, (int)a->tone, a->fill, a->opacity, a->ink, a->tint, a->role,
                 0.5 * twice);
    code = write(output, line, (size_t)n);
  }
  return code;
}

static const burin_option rays = {"rays", "of a star", BURIN_WHOLE, 2,
                                  16,     NULL,        NULL,        {5, {0, 0, 0}, NULL}};
static const burin_option tube = {"tube", "radius of the tube", BURIN_NUMBER, 0.1, 9, "mm",
                                  NULL,   {3, {0, 0, 0}, NULL}};
static const burin_option most = {"most",      "places of curvature until it fails; 0: it does not",
                                  BURIN_WHOLE, 0,
                                  1e9,         NULL,
                                  NULL,        {0, {0, 0, 0}, NULL}};
static const burin_option digits = {
    "digits", "of widths; 0 writes nothing", BURIN_WHOLE, 0, 9, NULL, NULL, {2, {0, 0, 0}, NULL}};
static const burin_stroke_kind_1 star_functions = {0, 32, make_nothing, free, stars};
static const burin_form_1 torus_functions = {0, make_form, free, NULL, NULL, domain, torus};
static const burin_form_1 ball_functions = {
    BURIN_ONE_THREAD, make_form, free, ball_bounds, ball, NULL, NULL};
static const burin_writer_1 list_functions = {"lst", write_list};
static const burin_writer_2 area_functions = {"lar", write_areas},
                            newer_functions = {"lbr", write_areas};
static const burin_writer_1 older_functions = {"lbr", write_list};
static const burin_factory factories[] = {
    {BURIN_STROKE_KIND_1, "stars", "a star on each point", 1, &rays, &star_functions},
    {BURIN_FORM_1, "ring", "a torus as S(u,v)", 1, &tube, &torus_functions},
    {BURIN_FORM_1, "ball", "a ball as a function", 1, &most, &ball_functions},
    {BURIN_WRITER_1, "list", "a line a path", 1, &digits, &list_functions},
    {BURIN_WRITER_2, "areas", "a line an area", 0, NULL, &area_functions},
    {BURIN_WRITER_2, "both", "a line an area", 0, NULL, &newer_functions},
    {BURIN_WRITER_1, "both", "a line a path", 1, &digits, &older_functions}};
static const burin_plugin_table table = {BURIN_PLUGIN_ABI, "more", "1", 7, factories};

const burin_plugin_table* burin_plugin(uint32_t abi) {
  return abi == BURIN_PLUGIN_ABI ? &table : NULL;
}
