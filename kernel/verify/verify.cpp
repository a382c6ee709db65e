#include <burin/base/parallel.h>
#include <burin/planar/near_lines.h>
#include <burin/verify/referee.h>
#include <burin/verify/verify.h>
#include <burin/verify/wrong_areas.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin {
namespace {

// Paper mm between two places of a line that are tested, and the shortest stretch that counts.
constexpr double kStep = 0.125;
constexpr double kShortestStretch = 0.5;
constexpr int kFewest = 4;  // the same in places
// The tessellation's share of the drawing's tolerance. Finer than the sheet's own choice the lines
// themselves are not.
constexpr double kFiner = 0.25;
constexpr double kSheetTolerance = 0.05;  // paper mm
// Paper mm within which a line that is drawn stands for one that is left out: what tessellations do
// not tell apart, a fraction of any pen's width.
constexpr double kSameLine = kSheetTolerance;
// Lines a step of progress, and a task.
constexpr std::size_t kAtOnce = 1024, kGrain = 8;
constexpr std::size_t kListed = 100, kNamed = 20;
// A cosine: what tessellations of one mesh differ by in the light between facets.
constexpr double kFacetLight = 0.01;

/// What one line gave.
struct Tested {
  double length = 0;  // 0: too short
  std::vector<Contradiction> found;
};

struct Place {
  Vec3 model;
  Vec2 paper;
};

// Places every kStep mm of paper, from half of that on.
std::vector<Place> places_of(const Path& path, const Camera& camera, double& length) {
  std::vector<Place> places;
  const std::size_t n = path.points3.size();
  double next = 0.5 * kStep;
  length = 0;
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    const Vec3 a = path.points3[i], b = path.points3[(i + 1) % n];
    const double d = glm::distance(camera.to_paper(a), camera.to_paper(b));
    for (; next < length + d; next += kStep) {
      const Vec3 p = glm::mix(a, b, (next - length) / d);
      places.push_back({p, camera.to_paper(p)});
    }
    length += d;
  }
  return places;
}

bool is_feature(const Path& path) {
  return path.kind != LineClass::Stroke && path.kind != LineClass::Pattern;
}

// The lines of the shape that are drawn. Left out is none that runs along one of them: the sheet
// shows the same with it and without, whichever of both lies in front.
NearLines drawn_features(std::span<const Path> lines, const Camera& camera) {
  std::vector<Polyline> drawn;
  for (const Path& path : lines) {
    if (!path.visible || !is_feature(path)) continue;
    Polyline line;
    for (const Vec3 p : path.points3) line.push_back(camera.to_paper(p));
    if (path.closed && !line.empty()) line.push_back(line.front());
    drawn.push_back(std::move(line));
  }
  return {drawn, kSameLine};
}

Tested test_line(const Path& path, const Camera& camera, const Referee& referee,
                 const NearLines& drawn) {
  Tested tested;
  const std::vector<Place> places = places_of(path, camera, tested.length);
  if (tested.length < kShortestStretch || !std::isfinite(tested.length)) return {};
  using Fold = Referee::Fold;
  const Fold fold = path.kind != LineClass::Contour ? Fold::None
                    : path.source.edge >= 0         ? Fold::Sharp
                                                    : Fold::Smooth;
  int run = 0;
  Finding worst = Finding::Holds;
  const auto close = [&](std::size_t end) {
    if (run >= kFewest) {
      const Place& middle = places[end - static_cast<std::size_t>(run + 1) / 2];
      tested.found.push_back({.what = to_string(worst),
                              .kind = path.kind,
                              .source = path.source,
                              .length = run * kStep,
                              .at = middle.paper,
                              .model = middle.model});
    }
    run = 0;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Finding finding = referee.test(places[i].model, path.visible, fold);
    const bool shown = finding == Finding::Open && is_feature(path) && drawn.near(places[i].paper);
    // Trails of exploded views lie on nothing, hidden lines of threads within a part.
    const bool within =
        !path.visible && (path.kind == LineClass::Thread || path.kind == LineClass::ThreadEnd);
    const bool on_nothing = finding == Finding::Adrift && (path.kind == LineClass::Trail || within);
    if (finding == Finding::Holds || shown || on_nothing) {
      close(i);
    } else {
      ++run;
      worst = finding;
    }
  }
  close(places.size());
  return tested;
}

std::string name_of(const Scene& scene, std::int32_t part) {
  const auto i = static_cast<std::size_t>(part);
  if (part < 0 || i >= scene.parts.size()) return "of no part";
  const std::string& name = scene.parts[i].name;
  return name.empty() ? fmt::format("of part {}", part) : fmt::format("of part '{}'", name);
}

/// "a contour", "an intersection".
std::string with_article(const std::string& noun) {
  return (std::string_view("aeiou").find(noun.front()) == std::string_view::npos ? "a " : "an ") +
         noun;
}

std::string place_of(Vec2 paper, Vec3 model) {
  return fmt::format("at {:.1f},{:.1f} mm of the sheet (model {:.6g},{:.6g},{:.6g})", paper.x,
                     paper.y, model.x, model.y, model.z);
}

std::string sentence(const Contradiction& c, const Scene& scene) {
  const std::string where = place_of(c.at, c.model);
  const std::string line = fmt::format("{} {}", to_string(c.kind), name_of(scene, c.source.part));
  if (c.what == "loose_end") {
    return fmt::format("the outer outline ends, {}, {}", with_article(line), where);
  }
  if (c.what == "missing") {
    return fmt::format("{:.2f} mm of the outer outline {} are missing, {}", c.length,
                       name_of(scene, c.source.part), where);
  }
  const char* says = c.what == "covered" ? "drawn as visible, but something hides it"
                     : c.what == "open"  ? "drawn as hidden, but nothing hides it"
                                         : "drawn where there is no surface";
  return fmt::format("{:.2f} mm of {} are {}, {}", c.length, with_article(line), says, where);
}

std::string sentence(const WrongArea& wrong, const Scene& scene) {
  const auto& [finding, stated, seen, model] = wrong.answer;
  const std::string where = place_of(wrong.at, model);
  if (stated.part < 0) {  // bare sheet, or too few panes
    return fmt::format("{:.2f} mm2 lack the area {}, which is seen there, {}", wrong.size,
                       name_of(scene, seen.part), where);
  }
  const std::string whose = "areas " + name_of(scene, stated.part);
  if (finding == AreaFinding::WrongPart) {
    const std::string what = seen.part < 0 ? "nothing" : "something " + name_of(scene, seen.part);
    return fmt::format("{:.2f} mm2 of the {} are wrong, {} is seen there, {}", wrong.size, whose,
                       what, where);
  }
  const bool face = finding == AreaFinding::WrongFace;
  return fmt::format("{:.2f} mm2 of the {} have {} {}, but {} is seen there, {}", wrong.size, whose,
                     face ? "face" : "tone", face ? stated.face : stated.tone,
                     face ? seen.face : seen.tone, where);
}

void report(const Verification& v, const Scene& scene, Diagnostics& diagnostics) {
  std::size_t named = 0;
  for (const Contradiction& c : v.contradictions) {
    if (++named > kNamed) break;
    diagnostics.add(Severity::Warning, "verify." + c.what, 1, sentence(c, scene));
  }
  const auto all = static_cast<std::size_t>(v.count + v.loose_ends);
  if (all > kNamed) {
    diagnostics.add(Severity::Warning, "verify.more", static_cast<std::int64_t>(all - kNamed),
                    fmt::format("{} more places where rays contradict the drawing", all - kNamed));
  }
}

bool flagged(const VerifyOptions& options, std::size_t part, PartOpacity standing) {
  return (part < options.parts.size() ? options.parts[part] : PartOpacity::Solid) == standing;
}

/// The referees of a scene: one for the solid parts, one for each transparent part with them.
class Referees {
 public:
  Referees(const Scene& scene, const Camera& camera, const VerifyOptions& options,
           Diagnostics& diagnostics, RunContext& context)
      : by_part_(scene.parts.size()) {
    const double own = kSheetTolerance / camera.scale();
    std::vector<bool> wanted;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
      wanted.push_back(!flagged(options, i, PartOpacity::Absent));
    }
    const double fine = kFiner * std::min(options.tolerance, own);
    const FineSurfaces all = fine_surfaces(scene, fine, wanted, options.crease_angles, context);
    const double paper = camera.scale() * std::max(options.tolerance, own);
    const RefereeOptions how{
        .radius = 2 * paper, .slack = paper + kFiner * kSheetTolerance, .ranks = options.ranks};
    FineSurfaces solid = all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (flagged(options, i, PartOpacity::Transparent)) solid[i] = nullptr;
      if (wanted[i] && !all[i]) {
        diagnostics.add(Severity::Warning, "verify.not_tested", 1,
                        fmt::format("lines {} are not verified: it cannot be tessellated finely",
                                    name_of(scene, static_cast<std::int32_t>(i))));
      }
    }
    solid_ = std::make_shared<Referee>(solid, camera, how, context);
    all_ = solid == all ? solid_ : std::make_shared<Referee>(all, camera, how, context);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i]) continue;
      if (!flagged(options, i, PartOpacity::Transparent)) {
        by_part_[i] = solid_;
        continue;
      }
      FineSurfaces with = solid;
      with[i] = all[i];
      by_part_[i] = std::make_shared<Referee>(std::move(with), camera, how, context);
    }
  }

  /// Of all parts that are drawn.
  const Referee& all() const { return *all_; }
  /// Of those that cannot be looked through.
  const Referee& solid() const { return *solid_; }
  /// Meshes that cannot be looked through, as coarse as `tolerance`.
  Referee coarse_meshes(const Scene& scene, double tolerance,
                        const std::vector<double>& crease_angles, RunContext& context) const {
    std::vector<bool> wanted;
    for (const auto& fine : solid_->surfaces()) wanted.push_back(fine && !fine->exact());
    return Referee(fine_surfaces(scene, tolerance, wanted, crease_angles, context),
                   solid_->camera(), solid_->options(), context);
  }
  /// Of the solid parts without those of a flag; null: none of them has it.
  std::unique_ptr<const Referee> without(const std::vector<bool>& parts,
                                         RunContext& context) const {
    FineSurfaces rest = solid_->surfaces();
    for (std::size_t i = 0; i < rest.size() && i < parts.size(); ++i) {
      if (parts[i]) rest[i] = nullptr;
    }
    if (rest == solid_->surfaces()) return nullptr;
    return std::make_unique<Referee>(std::move(rest), solid_->camera(), solid_->options(), context);
  }
  /// Null where the part has no fine surface.
  const Referee* of(std::int32_t part) const {
    const auto i = static_cast<std::size_t>(part);
    return part >= 0 && i < by_part_.size() ? by_part_[i].get() : nullptr;
  }

 private:
  std::shared_ptr<Referee> solid_, all_;
  std::vector<std::shared_ptr<Referee>> by_part_;
};

std::vector<Tested> test_lines(std::span<const Path> lines, const Camera& camera,
                               const Referees& referees, RunContext& context) {
  std::vector<Tested> tested(lines.size());
  const NearLines drawn = drawn_features(lines, camera);
  for (std::size_t from = 0; from < lines.size(); from += kAtOnce) {
    context.progress(static_cast<double>(from) / static_cast<double>(lines.size()));
    parallel_for(
        std::min(kAtOnce, lines.size() - from), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = from + begin; i < from + end; ++i) {
            const Referee* referee = referees.of(lines[i].source.part);
            if (referee) tested[i] = test_line(lines[i], camera, *referee, drawn);
          }
        },
        &context);
  }
  return tested;
}

void add_loose_ends(const Drawing& drawing, Verification& verification) {
  for (const LooseEnd& end : loose_ends(drawing)) {
    if (static_cast<std::size_t>(verification.loose_ends++) >= kListed) continue;
    verification.contradictions.push_back(
        {.what = "loose_end", .source = end.source, .at = end.at, .model = end.model});
  }
}

/// The sheet as far as lines and areas reach, and a mm around them.
Box2 used_sheet(const Drawing& drawing, std::span<const Path> lines, std::span<const Area> areas,
                const Box2& shown) {
  constexpr double kAround = 1;
  Box2 box;
  for (const Path& path : lines) {
    if (!path.visible) continue;
    for (const Vec2& p : path.points) box.add(p);
  }
  for (const Area& area : areas) {
    for (const std::vector<Vec2>& ring : area.rings) {
      for (const Vec2& p : ring) box.add(p);
    }
  }
  if (box.empty()) return box;
  box = {glm::max(box.min - kAround, Vec2(0)),
         glm::min(box.max + kAround, Vec2(drawing.paper_width, drawing.paper_height))};
  return shown.empty() ? box : Box2{glm::max(box.min, shown.min), glm::min(box.max, shown.max)};
}

void test_areas(const Drawing& drawing, std::span<const Path> lines, const Scene& scene,
                const VerifyOptions& options, const Referees& referees, Diagnostics& diagnostics,
                RunContext& context, Verification& out) {
  AreaRule rule = *options.areas;
  rule.facet_light = kFacetLight;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    rule.glass.push_back(flagged(options, i, PartOpacity::Transparent));
  }
  const Referee coarse =
      referees.coarse_meshes(scene, options.tolerance, options.crease_angles, context);
  const auto casting = rule.shadows ? referees.without(rule.unshaded, context) : nullptr;
  const AreaWitnesses witnesses{referees.solid(), referees.all(),
                                [&](std::int32_t part) { return referees.of(part); }, &coarse,
                                casting.get()};
  const AreaJudge judge(rule, witnesses, context);
  const AreaFindings found = wrong_areas(
      judge, used_sheet(drawing, lines, rule.areas, options.shown), drawing.seed, context);
  out.area = found.tested;
  out.wrong_patches = static_cast<std::int64_t>(found.wrong.size());
  for (std::size_t i = 0; i < found.wrong.size(); ++i) {
    const WrongArea& wrong = found.wrong[i];
    out.wrong_area += wrong.size;
    if (i >= kListed) continue;
    const std::string what = to_string(wrong.answer.finding);
    out.contradictions.push_back(
        {.what = what,
         .source = {wrong.answer.stated.part, wrong.answer.stated.face, -1},
         .size = wrong.size,
         .at = wrong.at,
         .model = wrong.answer.model});
    if (i >= kNamed) continue;
    diagnostics.add(Severity::Warning, "verify." + what, 1, sentence(wrong, scene));
  }
  if (found.wrong.size() > kNamed) {
    const std::size_t more = found.wrong.size() - kNamed;
    diagnostics.add(Severity::Warning, "verify.more", static_cast<std::int64_t>(more),
                    fmt::format("{} more patches where rays contradict the areas", more));
  }
}

}  // namespace

Verification verify(const Drawing& drawing, std::span<const Path> lines, const Scene& scene,
                    const Camera& camera, const VerifyOptions& options, Diagnostics& diagnostics,
                    RunContext& context) {
  const Referees referees(scene, camera, options, diagnostics, context);
  context.begin_stage(RunStage::Verify);
  Verification out;
  const auto add = [&](const std::vector<Contradiction>& found) {
    for (const Contradiction& c : found) {
      ++out.count;
      out.contradicted += c.length;
      out.contradictions.push_back(c);
    }
  };
  for (const Tested& t : test_lines(lines, camera, referees, context)) {
    out.spans += t.length > 0 ? 1 : 0;
    out.length += t.length;
    add(t.found);
  }
  if (options.outline) add(missing_outline(drawing, referees.all(), camera, context));
  std::ranges::stable_sort(out.contradictions, std::ranges::greater{}, &Contradiction::length);
  if (out.contradictions.size() > kListed) out.contradictions.resize(kListed);
  if (options.outline) add_loose_ends(drawing, out);
  report(out, scene, diagnostics);
  if (options.areas)
    test_areas(drawing, lines, scene, options, referees, diagnostics, context, out);
  context.end_stage();
  return out;
}

}  // namespace burin
