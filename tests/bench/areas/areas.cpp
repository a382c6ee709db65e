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
#include <burin/visibility/occluder.h>

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

/// Paper mm: nearer to a border a place may count to either side.
constexpr double kBeside = 0.12;

double now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Sides of all areas, by rows of the sheet.
class Sides {
 public:
  explicit Sides(const Drawing& drawing) {
    for (std::size_t a = 0; a < drawing.areas.size(); ++a) {
      for (const auto& ring : drawing.areas[a].rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          add({ring[i], ring[(i + 1) % ring.size()], a});
        }
      }
    }
  }

  /// Those that hold a place.
  std::vector<std::size_t> at(Vec2 p) const {
    std::map<std::size_t, int> crossed;
    each(p.y, [&](const Side& s) {
      if ((s.a.y > p.y) == (s.b.y > p.y)) return;
      if (s.a.x + (s.b.x - s.a.x) * (p.y - s.a.y) / (s.b.y - s.a.y) > p.x) ++crossed[s.area];
    });
    std::vector<std::size_t> out;
    for (const auto& [area, n] : crossed) {
      if (n % 2 == 1) out.push_back(area);
    }
    return out;
  }

  bool near(Vec2 p) const {
    bool found = false;
    each(p.y, [&](const Side& s) {
      const Vec2 d = s.b - s.a;
      const double l = glm::dot(d, d),
                   t = l > 0 ? std::clamp(glm::dot(p - s.a, d) / l, 0.0, 1.0) : 0;
      found = found || glm::distance(p, s.a + t * d) <= kBeside;
    });
    return found;
  }

 private:
  struct Side {
    Vec2 a, b;
    std::size_t area;
  };
  static constexpr double kRow = 0.25;

  static long row(double y) { return std::lround(std::floor(y / kRow)); }
  void add(const Side& s) {
    for (long r = row(std::min(s.a.y, s.b.y) - kBeside); r <= row(std::max(s.a.y, s.b.y) + kBeside);
         ++r) {
      rows_[r].push_back(s);
    }
  }
  template <class F>
  void each(double y, F&& f) const {
    const auto it = rows_.find(row(y));
    if (it == rows_.end()) return;
    for (const Side& s : it->second) f(s);
  }

  std::map<long, std::vector<Side>> rows_;
};

struct Task {
  std::string model, view;
  std::map<std::string, std::string> values{
      {"steps", "0"}, {"faces", "0"},  {"paper", "A4"}, {"perspective", "0"}, {"style", "outline"},
      {"rays", "4"},  {"picture", ""}, {"cast", "0"},   {"shadow", "0"}};
  double number(const char* key) const { return std::stod(values.at(key)); }
};

/// Realised once more, and what a ray meets of it.
class Truth {
 public:
  Truth(const Scene& scene, const Camera& camera, const Style& style, bool faces,
        RunContext& context)
      : camera_(camera), faces_(faces), cast_(style.shadow.cast) {
    light_.light = glm::normalize(tone::to_light(camera, style.tone));
    light_.levels = even_levels(static_cast<std::size_t>(std::max(style.fill.steps, 1)));
    if (cast_ && light_.levels.empty()) light_.levels = {0.2};  // as in drawings
    const RealiseOptions how{.tolerance = 0.05 / camera.scale(),
                             .crease_angle = style.feature.crease_angle,
                             .curvature = false,
                             .view = &camera};
    for (const Part& part : scene.parts) {
      try {
        surfaces_.push_back(part.form->realise(how, context));
        proxies_.push_back(&surfaces_.back()->proxy());
      } catch (const Error&) {
        surfaces_.push_back(nullptr);
        proxies_.push_back(&nothing_);
      }
    }
    occluder_ = std::make_unique<Occluder>(proxies_, context);
  }

  /// Part, face, step; -1 where there is nothing.
  std::array<std::int32_t, 3> at(Vec2 p) const {
    ViewRay ray = camera_.ray(p);
    const double back = 2 * occluder_->diagonal();
    if (!camera_.perspective()) ray.origin -= back * ray.direction;
    const auto hit = occluder_->first_hit(ray.origin, ray.direction, 0,
                                          2 * back + camera_.distance_to_viewer(camera_.center()));
    if (!hit) return {-1, -1, -1};
    const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(hit->where.part)];
    const Surface* surface = surfaces_[static_cast<std::size_t>(hit->where.part)].get();
    Vec3 n = surface->exact() ? surface->frame(surface->lift({hit->where.face, hit->bary})).normal
                              : proxy.normal(hit->where.face, hit->bary);
    if (!proxy.closed(hit->where.face) && glm::dot(n, ray.direction) > 0) n = -n;
    std::int32_t step = step_of(light_, n);
    if (cast_ && step > 0 && shaded(ray.origin + hit->distance * ray.direction, n)) step = 0;
    return {hit->where.part, faces_ ? proxy.face_source(hit->where.face) : -1, step};
  }

 private:
  bool shaded(Vec3 p, Vec3 n) const {
    const double off = 0.02 / camera_.scale();
    return occluder_->occluded(p + off * n, light_.light, 0, 2 * occluder_->diagonal());
  }

  const Camera& camera_;
  bool faces_, cast_;
  Isophotes light_;
  ProxyMesh nothing_;
  std::vector<std::shared_ptr<const Surface>> surfaces_;
  std::vector<const ProxyMesh*> proxies_;
  std::unique_ptr<Occluder> occluder_;
};

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

  const Truth truth(scene, camera, style, faces, context);
  const Sides sides(drawing);
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
    const auto seen = truth.at(p);
    const auto in = sides.at(p);
    shape += seen[0] >= 0 ? share : 0;
    std::array<std::int32_t, 3> told{-1, -1, -1};
    if (!in.empty()) {
      // Darker steps lie over lighter ones.
      const Area& area = drawing.areas[in.back()];
      told = {area.part, faces ? area.face : -1, std::max(area.tone, 0)};
    }
    const auto other = [&](std::size_t a) {
      return drawing.areas[a].part != drawing.areas[in.back()].part ||
             (faces && drawing.areas[a].face != drawing.areas[in.back()].face);
    };
    if (told == seen && std::ranges::none_of(in, other)) continue;
    wrong += share;
    if (sides.near(p)) continue;
    open += share;
    part_open += told[0] != seen[0] ? share : 0;
    places.push_back(p);
  }
  std::string name = asked.model.substr(asked.model.find_last_of('/') + 1);
  std::ranges::replace(name, ' ', '_');
  fmt::print(
      "{}\t{}\t{}\t{:.0f}\t{}\t{}\t{}\t{:.2f}\t{:.2f}\t{:.2f}\t{:.3f}\t{:.3f}\t{:.3f}\t{:.3f}\t",
      name, asked.view, scene.parts.size(), shape, drawing.areas.size(), rings, corners, wrong,
      open, part_open, of_lines, of_areas, of_color, of_light);
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 6); ++i) {
    const auto seen = truth.at(places[i]);
    const auto in = sides.at(places[i]);
    fmt::print("{:.2f},{:.2f}:{}/{}/{}!{} ", places[i].x, places[i].y, seen[0], seen[1], seen[2],
               in.empty() ? std::string("-")
                          : fmt::format("{}/{}/{}x{}", drawing.areas[in.back()].part,
                                        drawing.areas[in.back()].face,
                                        drawing.areas[in.back()].tone, in.size()));
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
