/// burin_judge [--spans] MODEL DRAWING.json NAME=LINES.json...: one row for each other program: how
/// much of each side's length has a partner, and who is right where they differ.
///
/// Every 0.25 mm of both sides is asked for a partner within 0.15 mm on the other. Where there is
/// none, rays decide. A line of the drawing that no ray confirms is an error of the drawing
/// ("extra"); a line of the other program that the rays confirm and that the drawing lacks is one,
/// too
/// ("missing"). Neighbouring samples make one span; a single sample (0.25 mm) is not counted.

#include <burin/base/error.h>
#include <burin/converters/cad_reader.h>
#include <burin/verify/referee.h>

#include "lines.h"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace burin::judge {
namespace {

constexpr double kStep = 0.25, kPartner = 0.15, kRing = 0.1;  // paper mm
constexpr double kTessellation = 0.004;                       // paper mm

nlohmann::json read_json(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw InputError("cannot be opened", path);
  return nlohmann::json::parse(in);
}

/// What the referee says of one side's samples without a partner.
struct Verdict {
  double length = 0, alone = 0;    // mm
  int confirmed = 0, refuted = 0;  // spans
  std::vector<std::string> spans;
};

Verdict judge(const std::vector<Polyline>& lines, const std::vector<Polyline>& others,
              const Referee& referee) {
  const NearLines near(others, kPartner);
  Verdict v;
  std::vector<Sample> span;
  int yes = 0;
  const auto close = [&] {
    if (span.size() > 1) {
      const bool confirmed = 2 * yes > static_cast<int>(span.size());
      ++(confirmed ? v.confirmed : v.refuted);
      v.spans.push_back(fmt::format("{} {:.2f},{:.2f} to {:.2f},{:.2f} ({} samples, {} confirmed)",
                                    confirmed ? "confirmed" : "refuted", span.front().paper.x,
                                    span.front().paper.y, span.back().paper.x, span.back().paper.y,
                                    span.size(), yes));
    }
    span.clear();
    yes = 0;
  };
  for (const Sample& s : sample(lines, kStep)) {
    v.length += kStep;
    if (near.near(s.paper)) continue;
    v.alone += kStep;
    const bool follows =
        !span.empty() && span.back().line == s.line && s.at - span.back().at < 1.5 * kStep;
    if (!follows) close();
    span.push_back(s);
    yes += referee.line_near(s.paper, kRing) ? 1 : 0;
  }
  close();
  return v;
}

double share(const Verdict& v) { return v.length > 0 ? 100 * (1 - v.alone / v.length) : 100; }

int run(const std::vector<std::string>& args) {
  const bool spans = !args.empty() && args[0] == "--spans";
  const std::size_t first = spans ? 1 : 0;
  if (args.size() < first + 3) {
    fmt::print(stderr, "usage: burin_judge [--spans] MODEL DRAWING.json NAME=LINES.json...\n");
    return 2;
  }
  RunContext context;
  const Scene scene = read_cad(args[first], context);
  const nlohmann::json drawing = read_json(args[first + 1]);
  const Camera camera = read_camera(drawing);
  const Referee referee(fine_surfaces(scene, kTessellation / camera.scale(), {}, {}, context),
                        camera, {}, context);
  // Seams, and edges that only divide one surface, are no lines of the shape. Each side may take
  // some of them for lines; neither has to draw what the other takes for one.
  const std::vector<Polyline> ours = drawing_lines(drawing, "seam");
  const std::vector<Polyline> with_seams = drawing_lines(drawing, "");
  for (std::size_t i = first + 2; i < args.size(); ++i) {
    const auto equals = args[i].find('=');
    const nlohmann::json other = read_json(args[i].substr(equals + 1));
    const Verdict mine = judge(ours, plane_lines(other, camera, ""), referee);
    const Verdict theirs = judge(plane_lines(other, camera, "seam"), with_seams, referee);
    fmt::print(
        "{} {:.0f} {:.2f} {:.0f} {:.2f} extra {} missing {} other_extra {} other_missing {} "
        "mesh {:.3f} hlr {:.3f}\n",
        args[i].substr(0, equals), mine.length, share(mine), theirs.length, share(theirs),
        mine.refuted, theirs.confirmed, theirs.refuted, mine.confirmed,
        other.at("mesh_s").get<double>(), other.at("hlr_s").get<double>());
    if (!spans) continue;
    for (const auto& s : mine.spans) fmt::print("  ours   {}\n", s);
    for (const auto& s : theirs.spans) fmt::print("  theirs {}\n", s);
  }
  return 0;
}

}  // namespace
}  // namespace burin::judge

int main(int argc, char** argv) {
  try {
    return burin::judge::run({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    fmt::print(stderr, "burin_judge: error: {}\n", e.what());
    return 3;
  }
}
