// burin_areas MODEL VIEW [steps=N] [cast=1] [shadow=1] [faces=1] [paper=A4] [perspective=DEGREES]
// [style=NAME] [rays=N] [picture=FILE.svg] draws a model with areas of flat tone and tests these by
// random rays, `rays` a mm2 of paper: a row of numbers. cast=1: with shadows of parts on parts;
// shadow=1: with the shadow on the ground.
#include <burin/base/error.h>
#include <burin/converters/read.h>
#include <burin/feature/isophotes.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/session.h>
#include <burin/tone/catalogue.h>
#include <burin/verify/areas.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <exception>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

double now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Task {
  std::string model, view;
  std::map<std::string, std::string> values{
      {"steps", "0"}, {"faces", "0"},  {"paper", "A4"}, {"perspective", "0"}, {"style", "outline"},
      {"rays", "4"},  {"picture", ""}, {"cast", "0"},   {"shadow", "0"}};
  double number(const char* key) const { return std::stod(values.at(key)); }
};

/// Realised once more, as finely as the drawing.
FineSurfaces surfaces_of(const Scene& scene, const Camera& camera, const Style& style,
                         RunContext& context) {
  const RealiseOptions how{.tolerance = 0.05 / camera.scale(),
                           .crease_angle = style.feature.crease_angle,
                           .curvature = false,
                           .view = &camera};
  FineSurfaces surfaces;
  for (const Part& part : scene.parts) {
    try {
      surfaces.push_back(part.form->realise(how, context));
    } catch (const Error&) {
      surfaces.push_back(nullptr);
    }
  }
  return surfaces;
}

void paint(const Drawing& drawing, std::size_t steps, const std::string& file,
           const std::vector<Vec2>& wrong) {
  static constexpr std::array<std::array<int, 3>, 8> kColors = {{{142, 202, 230},
                                                                 {255, 183, 3},
                                                                 {144, 190, 109},
                                                                 {242, 132, 130},
                                                                 {205, 180, 219},
                                                                 {132, 165, 157},
                                                                 {229, 152, 155},
                                                                 {152, 193, 217}}};
  std::ofstream out(file);
  out << fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0}mm' height='{1}mm' "
      "viewBox='0 0 {0} {1}'><rect width='100%' height='100%' fill='#fff'/>"
      "<g transform='matrix(1 0 0 -1 0 {1})'>\n",
      drawing.paper_width, drawing.paper_height);
  for (const Area& area : drawing.areas) {
    const auto& c =
        kColors[static_cast<std::size_t>(area.part * 5 + area.face + 1) % kColors.size()];
    const double light = steps < 2 ? 1 : 0.4 + 0.7 * area.tone / static_cast<double>(steps - 1);
    const auto mixed = [&](int x) {
      return std::min(255,
                      static_cast<int>(light <= 1 ? x * light : x + (255 - x) * (light - 1) * 4));
    };
    out << fmt::format("<path fill-rule='evenodd' fill='#{:02x}{:02x}{:02x}' d='", mixed(c[0]),
                       mixed(c[1]), mixed(c[2]));
    for (const auto& ring : area.rings) {
      char move = 'M';
      for (const Vec2 p : ring)
        out << fmt::format("{}{:.4f} {:.4f}", std::exchange(move, 'L'), p.x, p.y);
      out << 'Z';
    }
    out << "'/>\n";
  }
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible) continue;
      out << fmt::format(
          "<path fill='none' stroke='#000' stroke-linecap='round' stroke-width='{}' d='",
          path.width[0]);
      char move = 'M';
      for (const Vec2 p : path.points)
        out << fmt::format("{}{} {}", std::exchange(move, 'L'), p.x, p.y);
      out << (path.closed ? "Z'/>\n" : "'/>\n");
    }
  }
  for (const Vec2 p : wrong)
    out << fmt::format("<circle cx='{}' cy='{}' r='0.3' fill='#f0f'/>\n", p.x, p.y);
  out << "</g></svg>\n";
}

void run(const Task& asked) {
  RunContext context;
  const Scene scene = read_scene({asked.model}, {}, context);
  const NamedView view = named_view(asked.view);
  ViewOptions of_view{.direction = view.direction, .up = view.up};
  of_view.paper = Paper::named(asked.values.at("paper"));
  if (asked.number("perspective") > 0) of_view.perspective = asked.number("perspective");
  const Camera camera =
      Camera::fit([&](const Mat3& axes) { return drawn_bounds(scene, {}, axes); }, of_view);
  Style style = builtin_style(asked.values.at("style"));
  const auto steps = static_cast<std::size_t>(asked.number("steps"));
  const bool faces = asked.number("faces") > 0;
  illustrate(scene, camera, style, {}, context);  // forms keep what they make once
  Session session;
  const auto timed = [&](const IllustrateOptions& options, Drawing& drawing) {
    const double start = now();
    drawing = session.draw(scene, camera, style, options, context);
    return now() - start;
  };
  Drawing drawing;
  const double of_lines = timed({}, drawing);
  const double of_same = timed({}, drawing);
  style.fill.color = "part";
  style.fill.steps = static_cast<int>(steps);
  style.shadow.cast = asked.number("cast") > 0;
  style.shadow.ground = asked.number("shadow") > 0;
  const double of_areas = timed({.face_areas = faces}, drawing) - of_same;
  Drawing again;
  const Style asked_style = style;
  style.fill.color = "#aa3300";
  const double of_color = timed({.face_areas = faces}, again) - of_same;
  style.tone.light.x += 0.1;
  const double of_light = timed({.face_areas = faces}, again) - of_same;
  style = asked_style;

  const Referee referee(surfaces_of(scene, camera, style, context), camera, {}, context);
  Isophotes light{tone::to_light(camera, style.tone), even_levels(std::max<std::size_t>(steps, 1))};
  if (style.shadow.cast && light.levels.empty()) light.levels = {tone::kUnlit};
  AreaRule rule{drawing.areas, std::vector<Isophotes>(scene.parts.size(), light)};
  rule.pen = style.line.crease;
  if (style.shadow.cast) rule.shadows = light.light;
  const AreaWitnesses witnesses{referee, referee};
  const AreaJudge judge(rule, witnesses, context);
  Box2 box;
  std::size_t rings = 0, corners = 0;
  for (const Area& area : drawing.areas) {
    rings += area.rings.size();
    for (const auto& ring : area.rings) {
      corners += ring.size();
      for (const Vec2 p : ring) box.add(p);
    }
  }
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2 p : path.points) box.add(p);
    }
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
  const Vec2 size = box.size();
  const double share = 1 / asked.number("rays");
  double shape = 0, wrong = 0, open = 0, part_open = 0;
  std::vector<Vec2> places;
  for (std::size_t i = 0, n = static_cast<std::size_t>(size.x * size.y / share); i < n; ++i) {
    const Vec2 p(x(random), y(random));
    shape += referee.see(p) ? share : 0;
    const AreaAnswer answer = judge.at(p);
    if (answer.finding == AreaFinding::Holds) continue;
    wrong += share;
    if (judge.beside_border(p)) continue;
    open += share;
    part_open += answer.finding == AreaFinding::WrongPart ? share : 0;
    places.push_back(p);
  }
  std::string name = asked.model.substr(asked.model.find_last_of('/') + 1);
  std::ranges::replace(name, ' ', '_');
  fmt::print(
      "{}\t{}\t{}\t{:.0f}\t{}\t{}\t{}\t{:.2f}\t{:.2f}\t{:.2f}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\t",
      name, asked.view, scene.parts.size(), shape, drawing.areas.size(), rings, corners, wrong,
      open, part_open, of_lines, of_areas, of_color, of_light);
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 6); ++i) {
    const auto& [finding, stated, seen, model] = judge.at(places[i]);
    fmt::print("{:.2f},{:.2f}:{}/{}/{}!{}/{}/{} ", places[i].x, places[i].y, seen.part, seen.face,
               seen.tone, stated.part, stated.face, stated.tone);
  }
  fmt::print("\n");
  if (!asked.values.at("picture").empty())
    paint(drawing, steps < 2 && style.shadow.cast ? 2 : steps, asked.values.at("picture"), places);
}

}  // namespace
}  // namespace burin

int main(int argc, char** argv) try {
  if (argc < 3) throw burin::UsageError("usage: burin_areas MODEL VIEW [key=value]...");
  burin::Task asked{argv[1], argv[2]};
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    const auto at = word.find('=');
    if (at == std::string::npos || !asked.values.contains(word.substr(0, at))) {
      throw burin::UsageError("no such key: " + word);
    }
    asked.values[word.substr(0, at)] = word.substr(at + 1);
  }
  burin::run(asked);
} catch (const std::exception& e) {
  fmt::print(stderr, "burin_areas: {}: {}\n", argc > 1 ? argv[1] : "", e.what());
  return 1;
}
