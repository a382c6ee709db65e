#include "placement.h"

#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>

#include "border_lines.h"
#include "level_lines.h"
#include "level_phase.h"
#include "narrow_faces.h"
#include "pieces.h"
#include "remembered.h"
#include "shared_progress.h"
#include "wave_anchors.h"
#include "wave_density.h"
#include "wave_pairs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm along which lines may take the room that others leave, before one ends: more where the
// field is known than where it is an estimate that turns this way and that. Lines whose widths give
// little or nothing shade by beginning and ending.
constexpr double kLongExact = 60, kLongEstimated = 40, kLongOnePen = 8, kLongStiff = 4;
// Times as long where everybody knows how lines run; a pen of one width has its tone to hold there,
// too.
constexpr double kLongerRuled = 4;
// Shares of the gap: a seed nearer than this to an accepted line is that line, where strokes run as
// the field has it, and where they run along their level lines.
constexpr double kTaken = 0.55, kSame = 0.3;
constexpr int kPlaceHalvings = 2;  // of a line whose middle is taken, until it counts as drawn
// Where a stroke begins: this near its level line where it can be, and no farther off than that.
constexpr double kOnLine = 0.02, kNearLine = 0.3;
constexpr int kNewton = 4;
// Gaps beside a contour up to which shade is too narrow for strokes that end in the light.
constexpr double kStrip = 2;
// Steps of the progress: of a family, and of each of the four stages before its lines are traced.
constexpr std::size_t kPlaceSteps = 1000, kStage = 150;

void insert_visible(SampleGrid& grid, const TracedStroke& stroke, std::int32_t id) {
  for (const StrokeSample& s : stroke.samples) {
    if (s.visible) grid.insert(grid_sample(s, stroke.part, id));
  }
}

// The strokes of one smooth region.
class Placement {
 public:
  Placement(const Picture& picture, int family, const Box2& box)
      : picture_(picture),
        family_(family),
        tracer_(picture, family),
        out_{{}, SampleGrid(box.min, box.size(), picture.options.spacing_max)} {}

  Family place(std::vector<Piece> pieces, const RunContext& context) {
    // Long lines first; what one of them leaves of its piece comes back.
    const auto shorter = [&](std::size_t a, std::size_t b) {
      return pieces[a].length != pieces[b].length ? pieces[a].length < pieces[b].length : a > b;
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(shorter)> queue(shorter);
    for (std::size_t i = 0; i < pieces.size(); ++i) queue.push(i);
    for (std::size_t taken = 0; !queue.empty(); ++taken) {
      if (taken % 8 == 0) context.check();
      const std::size_t i = queue.top();
      queue.pop();
      for (Piece& rest : draw(pieces[i])) {
        pieces.push_back(std::move(rest));
        queue.push(pieces.size() - 1);
      }
    }
    for (const Tip& tip : tips_) close(tip);
    return std::move(out_);
  }

 private:
  // An end of a stroke inside the surface.
  struct Tip {
    std::size_t stroke = 0;
    bool begin = false;
    double gap = 0;
    FadingRange fading;
  };

  // Draws a tip on into the wedge between its neighbours, now that all of them are there.
  void close(const Tip& tip) {
    TracedStroke& stroke = out_.strokes[tip.stroke];
    const auto number = static_cast<std::int32_t>(tip.stroke);
    const auto turn_round = [](StrokeSample& s) {
      s.tangent = -s.tangent;
      s.direction = -s.direction;
    };
    StrokeSample last = tip.begin ? stroke.samples.front() : stroke.samples.back();
    if (tip.begin) turn_round(last);
    std::vector<StrokeSample> more =
        tracer_.wedge(stroke, last, tip.gap, tip.fading.least, out_.grid, number);
    for (StrokeSample& s : more) {
      s.weight = tip.fading.weight(picture_.share(s.darkness, family_));
      if (tip.begin) turn_round(s);
      out_.grid.insert(grid_sample(s, stroke.part, number));
    }
    if (tip.begin) std::ranges::reverse(more);
    stroke.samples.insert(tip.begin ? stroke.samples.begin() : stroke.samples.end(), more.begin(),
                          more.end());
  }

  // Draws a piece, or as much of it as one stroke follows; what is left.
  std::vector<Piece> draw(const Piece& piece) {
    const LevelLine& line = piece.line;
    const std::size_t middle = line.points.size() / 2;
    StrokeSample seed;
    if (!find_seed(piece, middle, seed)) return left_of(piece, middle, middle);
    const double gap = line.gaps[middle];
    const bool known = picture_.surface(piece.part).exact() || !seed.bent;
    const double taken = (known ? kTaken : kSame) * gap;
    if (out_.grid.nearest(grid_sample(seed, piece.part, -1), taken) < taken) {
      // That line, or lines that draw together just there: its other parts may be missing.
      if (piece.halvings == kPlaceHalvings) return {};
      std::vector<Piece> halves = left_of(piece, middle, middle);
      for (Piece& half : halves) half.halvings = piece.halvings + 1;
      return halves;
    }
    TracedStroke stroke = tracer_.trace(piece.part, seed,
                                        {.reach = 0.5 * picture_.options.length_max,
                                         .least_ink = piece.fading.least,
                                         .line = &line,
                                         .point = middle,
                                         .neighbours = &out_.grid});
    std::vector<Piece> left;
    if (!stroke.closed) {
      left = left_of(piece, nearest(line, 0, middle, stroke.samples.front().paper),
                     nearest(line, middle, line.points.size() - 1, stroke.samples.back().paper));
    }
    if (!acceptable(stroke, gap)) return left;
    for (StrokeSample& s : stroke.samples) {
      s.weight = piece.fading.weight(picture_.share(s.darkness, family_));
    }
    const std::size_t number = out_.strokes.size();
    if (stroke.begin_reason == StrokeEnd::Tip) {
      tips_.push_back({number, true, line.gaps.front(), piece.fading});
    }
    if (stroke.end_reason == StrokeEnd::Tip) {
      tips_.push_back({number, false, line.gaps.back(), piece.fading});
    }
    insert_visible(out_.grid, stroke, static_cast<std::int32_t>(number));
    out_.strokes.push_back(std::move(stroke));
    return left;
  }

  bool find_seed(const Piece& piece, std::size_t middle, StrokeSample& seed) const {
    const std::vector<Vec2>& p = piece.line.points;
    const auto hit = picture_.probe(p[middle]);
    if (!hit || hit->part != piece.part) return false;
    const Surface& surface = picture_.surface(piece.part);
    if (surface.proxy().face_region[hit->point.face] != piece.region) return false;
    const Vec2 along = p[std::min(middle + 1, p.size() - 1)] - p[middle > 0 ? middle - 1 : 0];
    // The point lies off the line as far as the triangles lie off the surface.
    SurfacePoint point = surface.lift(hit->point);
    for (int i = 0; i < kNewton; ++i) {
      const Vec2 off = p[middle] - picture_.camera.to_paper(point.position);
      if (glm::length(off) < kOnLine * piece.line.gaps[middle]) break;
      const auto moved = moved_on_paper(surface, point, off);
      if (!moved) break;
      point = *moved;
    }
    return tracer_.seed_along(piece.part, point, along, seed) &&
           glm::distance(seed.paper, p[middle]) < kNearLine * piece.line.gaps[middle] &&
           picture_.seen(piece.part, seed.face, seed.paper, seed.depth);
  }

  // A surface point moved so that it shows about that far from where it was.
  std::optional<SurfacePoint> moved_on_paper(const Surface& surface, const SurfacePoint& point,
                                             Vec2 by) const {
    const Vec3 normal = surface.frame(point).normal, u = any_orthogonal(normal),
               v = glm::cross(normal, u);
    const Camera& camera = picture_.camera;
    const Vec2 a = camera.velocity(point.position, u), b = camera.velocity(point.position, v);
    const double area = cross2(a, b), scale = camera.scale_at(point.position);
    constexpr double kLeastFacing = 0.02;
    if (std::abs(area) < kLeastFacing * scale * scale) return std::nullopt;
    const Vec3 step = cross2(by, b) / area * u + cross2(a, by) / area * v;
    const MarchStep there = surface.march(point, step, glm::length(step));
    return there.stop == MarchStop::Completed ? std::optional(there.end) : std::nullopt;
  }

  // The point of a line, of those from `first` to `last`, that is nearest to a place.
  static std::size_t nearest(const LevelLine& line, std::size_t first, std::size_t last,
                             Vec2 paper) {
    std::size_t best = first;
    for (std::size_t i = first; i <= last; ++i) {
      if (glm::distance(line.points[i], paper) < glm::distance(line.points[best], paper)) best = i;
    }
    return best;
  }

  // Whether a stroke from a contour into the light stays beside it all the way: where a lit surface
  // has a narrow strip of shade along its contour, such ones would be hairs on the outline.
  bool hugs_contour(const TracedStroke& s) const {
    const bool begins = s.begin_reason == StrokeEnd::Away && s.end_reason == StrokeEnd::Light,
               ends = s.end_reason == StrokeEnd::Away && s.begin_reason == StrokeEnd::Light;
    if (!begins && !ends) return false;
    const StrokeSample& edge = begins ? s.samples.front() : s.samples.back();
    const Vec2 outwards = picture_.camera.velocity(edge.point.position, edge.normal);
    const double beside = kStrip * picture_.options.spacing_min * glm::length(outwards);
    return std::ranges::all_of(s.samples, [&](const StrokeSample& p) {
      return std::abs(glm::dot(outwards, p.paper - edge.paper)) < beside;
    });
  }

  // From edge to edge a stroke may be shorter than the style's shortest, down to the spacing:
  // narrow faces would stay white.
  bool acceptable(const TracedStroke& s, double gap) const {
    const double length = s.length();
    if (s.samples.size() < 3 || hugs_contour(s)) return false;
    if (length >= picture_.options.length_min) return true;
    const auto bounded = [](StrokeEnd e) {
      return e == StrokeEnd::Edge || e == StrokeEnd::Away || e == StrokeEnd::Hidden;
    };
    return bounded(s.begin_reason) && bounded(s.end_reason) &&
           length >= std::min(gap, picture_.options.spacing_min);
  }

  const Picture& picture_;
  int family_;
  Tracer tracer_;
  std::vector<Tip> tips_;
  Family out_;
};

// The level lines of a family, whatever ink there is. Four of the stages that are done before lines
// are traced.
std::vector<CellLine> cell_lines(const Picture& picture, const ViewRaster& raster, WaveGraph graph,
                                 int family, const RunContext& context, SharedProgress& done) {
  WavePhase phase;
  if (picture.level_step > 0) {
    phase = level_phase(picture, raster, graph, context);
    done.add(2 * kStage);
  } else {
    const bool exact = std::ranges::all_of(picture.surfaces, &Surface::exact);
    const bool one_pen = picture.one_pen();
    const double length = one_pen             ? kLongOnePen
                          : !picture.swells() ? kLongStiff
                          : exact             ? kLongExact
                                              : kLongEstimated;
    make_integrable(raster, graph, picture.options.spacing_min, length, one_pen ? 1 : kLongerRuled,
                    context);
    done.add(kStage);
    const std::vector<WaveAnchor> anchors = wave_anchors(picture, raster, graph, family, context);
    phase = solve_phase(graph, anchors, context);
    if (picture.swells() || one_pen) cancel_pairs(raster, graph, anchors, phase, context);
    done.add(kStage);
  }
  std::vector<LevelLine> found = level_lines(raster, graph, phase, context);
  // Lines of a field that has levels stay on them.
  const auto has_level = [&](const LevelLine& line) {
    const RasterCell& cell = raster.cells[graph.nodes[line.node].cell];
    const Surface& surface = picture.surface(cell.part);
    const SurfacePoint point = surface.lift(cell.place());
    return picture.level(cell.part, point, surface.frame(point)).has_value();
  };
  if (found.empty() || !has_level(found.front())) {
    join_along_borders(raster, graph, found, context);
  }
  std::vector<CellLine> lines;
  for (LevelLine& line : found) {
    const std::uint32_t cell = graph.nodes[line.node].cell;
    lines.push_back({std::move(line), cell});
  }
  done.add(kStage);
  return lines;
}

// The field with its second family turned off the first by an angle on the surface, always the same
// way round as seen from outside.
Field crossed(const Field& field, double degrees) {
  if (degrees >= 90) return field;
  const double angle = glm::radians(degrees);
  Field out = field;
  out.cross = [cross = field.cross, c = std::cos(angle),
               s = std::sin(angle)](const FieldQuery& query) -> std::optional<Cross> {
    std::optional<Cross> found = cross(query);
    if (found) {
      found->second = c * found->first + s * glm::cross(query.frame.normal, found->first);
    }
    return found;
  };
  return out;
}

Family place_family(const Picture& picture, const ViewRaster& raster,
                    const std::vector<CellLine>& lines, int family, const RunContext& context,
                    SharedProgress& done) {
  std::vector<Region> regions = regions_of(picture, raster, lines, family);
  // The longest first: none is left over when the other cores have nothing more to do.
  std::vector<std::size_t> order(regions.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, std::greater(),
                           [&](std::size_t i) { return regions[i].pieces.size(); });
  std::vector<std::optional<Family>> placed(regions.size());
  double pieces = 0;
  for (const Region& r : regions) pieces += static_cast<double>(r.pieces.size());
  parallel_for(
      order.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          Region& region = regions[order[k]];
          const auto count = static_cast<double>(region.pieces.size());
          placed[order[k]] =
              Placement(picture, family, region.box).place(std::move(region.pieces), context);
          done.add(static_cast<std::size_t>((kPlaceSteps - 4 * kStage) * count / pieces));
        }
      },
      &context);
  Family out{{},
             SampleGrid(raster.origin, raster.pitch * Vec2(raster.nx, raster.ny),
                        picture.options.spacing_max)};
  for (std::optional<Family>& one : placed) {
    for (TracedStroke& stroke : one->strokes) {
      insert_visible(out.grid, stroke, static_cast<std::int32_t>(out.strokes.size()));
      out.strokes.push_back(std::move(stroke));
    }
  }
  return out;
}

// Whether the lines of the first family stand where they do whatever the tone is.
bool ignores_light(const Picture& picture) {
  return picture.swells() && picture.laws->density.plain() && !(picture.level_step > 0);
}

}  // namespace

std::vector<Family> place_families(const Picture& picture, const ViewRaster& raster, int families,
                                   const RunContext& context,
                                   const std::function<void(double)>& progress) {
  std::vector<Family> out(static_cast<std::size_t>(families),
                          Family{{}, SampleGrid({0, 0}, {0, 0}, 1)});
  SharedProgress done(static_cast<double>(families * kPlaceSteps), progress);
  Remembered mine;
  Remembered& memory = picture.memory && ignores_light(picture) ? *picture.memory : mine;
  // Narrow faces are found on the graph of the field as it is.
  if (!memory.graph) memory.graph = wave_graph(picture, raster, 1, context);
  FaceSet narrow;
  if (picture.field.free) narrow = narrow_faces(picture, raster, *memory.graph, context);
  const bool turns = !narrow.empty(), known = memory.first && memory.first->narrow == narrow;
  const Field field = turns ? turned(picture, narrow) : picture.field;
  const Picture first = picture.following(field);
  std::optional<WaveGraph> graph;  // where the lines of the first family are not known
  if (!known) {
    memory.first.reset();
    if (turns) {
      if (&memory == &mine) memory.graph.reset();  // not two of them at once
      graph = wave_graph(first, raster, 1, context);
    } else if (&memory == &mine) {
      graph = std::move(memory.graph);
    } else {
      graph = *memory.graph;
    }
  }
  FirstLines made{std::move(narrow), {}};
  done.add(kStage);
  const Field cross = crossed(field, picture.options.cross_angle);
  const Picture second = picture.following(cross);
  const auto place = [&](int family) {
    if (family == 2) {
      done.add(kStage);
      const auto lines =
          cell_lines(second, raster, wave_graph(second, raster, 2, context), 2, context, done);
      out[1] = place_family(second, raster, lines, 2, context, done);
      return;
    }
    if (graph) {
      made.lines = cell_lines(first, raster, *std::move(graph), 1, context, done);
    } else {
      done.add(3 * kStage);
    }
    out[0] =
        place_family(first, raster, known ? memory.first->lines : made.lines, 1, context, done);
  };
  if (families == 1) {
    place(1);
  } else {
    parallel_invoke([&] { place(1); }, [&] { place(2); });
  }
  if (!known) memory.first = std::move(made);
  return out;
}

}  // namespace burin::detail
