// burin convert, and its files read again by other programs.

#include "models.h"

#include <burin_test/pictures.h>
#include <nlohmann/json.hpp>

#include <regex>

namespace burin::test {
namespace {

/// Two ticks 100 mm apart, a square of 100 mm and, far from both, a circle and a tapered stroke.
std::string ruler() {
  std::string circle;
  for (int i = 0; i < 180; ++i) {
    const double a = 2 * 3.14159265358979 * i / 180;
    circle += fmt::format("{}[{:.6f},{:.6f}]", i ? "," : "", 230 + 20 * std::cos(a),
                          100 + 20 * std::sin(a));
  }
  return R"({"format": "burin-drawing", "version": 1, "paper": {"width": 270, "height": 200},
    "layers": [
      {"name": "ticks", "paths": [{"points": [[50, 10], [50, 20]], "width": 0.5},
        {"points": [[150, 10], [150, 20]], "width": 0.5}]},
      {"name": "square", "paths": [{"points": [[50, 50], [150, 50], [150, 150], [50, 150]],
        "closed": true, "part": 2, "face": 5, "edge": 9, "kind": "crease"}]},
      {"name": "circle", "paths": [{"closed": true, "points": [)" +
         circle + R"(]}]},
      {"name": "stroke", "paths": [{"kind": "stroke", "points": [[210, 30], [230, 32], [250, 30]],
        "width": [0, 0.6, 0]}]}]})";
}

class Convert : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    folder_.write("r.json", ruler());
  }
  /// The two ticks of a picture of 254 dpi are 100.00 mm apart, at 50 and 150 mm.
  static void expect_scale(const Picture& p) {
    ASSERT_GE(p.width, 2700u);
    ASSERT_LE(p.width, 2701u);
    ASSERT_GE(p.height, 2000u);
    Picture ticks = p;
    ticks.pixels.erase(ticks.pixels.begin(),
                       ticks.pixels.begin() + static_cast<std::ptrdiff_t>(1750 * p.width));
    ticks.height -= 1750;
    const double left = centre_of_ink(ticks, 400, 600), right = centre_of_ink(ticks, 1400, 1600);
    EXPECT_NEAR(left, 500, 0.6);            // Ghostscript moves lines by half a pixel
    EXPECT_NEAR(right - left, 1000, 0.05);  // 0.005 mm
  }
};

TEST_F(Convert, GivesTheSameBytesForOurOwnFiles) {
  ASSERT_EQ(run("draw @/box.off -o @/a.json --hidden dashed --quiet --style shaded"), 0) << err_;
  ASSERT_EQ(run("convert @/a.json -o @/b.json --quiet"), 0) << err_;
  EXPECT_EQ(slurp(folder_ / "a.json"), slurp(folder_ / "b.json"));
}

TEST_F(Convert, WritesAllFormatsAtOnceAndToStandardOutput) {
  ASSERT_EQ(
      run("convert @/r.json -o @/r.svg -o @/r.pdf -o @/r.eps -o @/r.png -o @/r.dxf --verbose"), 0);
  EXPECT_NE(err_.find("burin: stage write"), std::string::npos);
  for (const char* f : {"svg", "pdf", "eps", "png", "dxf"}) {
    ASSERT_EQ(run(fmt::format("convert @/r.json -o - --format {}", f)), 0);
    EXPECT_EQ(out_, slurp(folder_ / (std::string("r.") + f))) << f;
    EXPECT_GT(out_.size(), 500u);
  }
  EXPECT_EQ(run("convert @/r.json -o - --format json --set json.points3=false"), 0);
  EXPECT_EQ(nlohmann::json::parse(out_)["layers"].size(), 4u);
}

TEST_F(Convert, ErrorsAreOneLineAndLeaveNothing) {
  folder_.write("broken.json", "{\"format\": \"burin-drawing\",\n\"version\": }");
  const auto fails = [&](const std::string& line, int status, const std::string& part) {
    const std::size_t before = folder_.count();
    EXPECT_EQ(run("convert " + line), status) << line;
    expect_error(part);
    EXPECT_EQ(folder_.count(), before);
  };
  fails("", 2, "no input");
  fails("@/r.json", 2, "no output");
  fails("@/r.json -o @/r.bmp", 2, ".json or .html");
  fails("@/r.json -o @/r.json", 2, "also an input");
  fails("@/r.json @/box.off -o @/a.svg", 2, "unexpected argument");
  fails("@/r.json -o @/a.svg --set line.outer=1", 2, "burin draw");
  fails("@/r.json -o @/a.png --set png.dpi=5", 2, "10 to 4800");
  fails("@/r.json -o @/a.png --set png.dpi=4800", 2, "png.dpi to");
  fails("@/r.json -o @/a.png --set dxf.spline=true", 2, "'dxf.splines'");
  fails("@/none.json -o @/a.svg", 3, "none.json: no such file");
  fails("@/broken.json -o @/a.svg", 3, "broken.json:2: broken JSON");
  fails("@/box.off -o @/a.svg", 3, "box.off: is a model (off), not a drawing");
  fails("@/r.json -o @/none/a.svg", 4, "does not exist");
  fails("@/r.json -o /dev/full --format pdf", 4, "/dev/full: the disk is full");
  fails("@/r.json -o /dev/full --format png", 4, "/dev/full: the disk is full");
}

TEST_F(Convert, PicturesHaveTheirTrueSize) {
  ASSERT_EQ(run("convert @/r.json -o @/r.svg -o @/r.pdf -o @/r.png -o @/r.eps --set png.dpi=254"),
            0);
  const Picture png = read_png(folder_ / "r.png");
  expect_scale(png);
  if (has_program("rsvg-convert")) {
    ASSERT_TRUE(shell(fmt::format("rsvg-convert -b white -d 254 -p 254 -o {0}/svg.png {0}/r.svg",
                                  folder_.path())));
    const Picture svg = read_png(folder_ / "svg.png");
    expect_scale(svg);
    EXPECT_LT(mean_difference(svg, png), 0.0001);
  }
  if (has_program("gs")) {
    ASSERT_TRUE(
        shell(fmt::format("gs -q -dNOPAUSE -dBATCH -dSAFER -sDEVICE=pnggray -r254 -dEPSCrop "
                          "-dGraphicsAlphaBits=4 -sOutputFile={0}/eps.png {0}/r.eps",
                          folder_.path())));
    expect_scale(read_png(folder_ / "eps.png"));
  }
  if (!has_program("pdftoppm") || !has_program("pdfinfo")) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  ASSERT_TRUE(shell(
      fmt::format("pdftoppm -r 254 -gray -png -singlefile {0}/r.pdf {0}/pdf", folder_.path())));
  const Picture pdf = read_png(folder_ / "pdf.png");
  expect_scale(pdf);
  EXPECT_LT(mean_difference(pdf, png), 0.001);
  ASSERT_TRUE(shell(fmt::format("pdfinfo -box {0}/r.pdf >{0}/info; pdffonts {0}/r.pdf >{0}/fonts",
                                folder_.path())));
  // 270 and 200 mm in points.
  EXPECT_TRUE(std::regex_search(slurp(folder_ / "info"),
                                std::regex("MediaBox: +0.00 +0.00 +765.35 +566.93\n")));
  const std::string fonts = slurp(folder_ / "fonts");
  EXPECT_EQ(std::count(fonts.begin(), fonts.end(), '\n'), 2) << fonts;  // the heads of a table
}

TEST_F(Convert, DrawingsLookTheSameAsPdfAndSvg) {
  if (!has_program("pdftoppm") || !has_program("rsvg-convert")) {
    GTEST_SKIP() << "poppler-utils or librsvg2-bin is not installed";
  }
  ASSERT_EQ(run("draw @/box.off -o @/b.svg -o @/b.pdf --style engraving --hidden dashed --paper A6 "
                "--quiet"),
            0);
  ASSERT_TRUE(
      shell(fmt::format("cd {} && pdftoppm -r 508 -gray -png -singlefile b.pdf pdf && "
                        "rsvg-convert -b white -d 508 -p 508 -o svg.png b.svg",
                        folder_.path())));
  const Picture svg = read_png(folder_ / "svg.png"), pdf = read_png(folder_ / "pdf.png");
  ASSERT_GT(svg.width, 2900u);
  EXPECT_NEAR(mean_ink(pdf), mean_ink(svg), 0.08 * mean_ink(svg));
  EXPECT_LT(mean_difference(svg, pdf), 0.02);
}

TEST_F(Convert, SolidsAreWhatOpenscadExportsNotWhatItsWindowShows) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  const auto height = [&](const std::string& program, const std::string& options) {
    folder_.write("p.scad", program);
    EXPECT_EQ(run("convert @/p.scad -o @/p.off --no-progress " + options), 0) << err_;
    EXPECT_EQ(run("info @/p.off --json"), 0) << err_;
    return nlohmann::json::parse(out_)["files"][0]["bounds"]["max"][2].get<double>();
  };
  const std::string seen = "cube([1, 1, $preview ? 2 : 5]);";
  EXPECT_EQ(height(seen, ""), 5);
  EXPECT_EQ(height(seen, "--csg openscad"), 5);
  EXPECT_EQ(height(seen, "-D $preview=true"), 2);
  EXPECT_EQ(height("$preview = true;\n" + seen, ""), 2);
  EXPECT_EQ(height("module m() { $preview = true; cube(1); }\n" + seen, ""), 5);
  // A drawing shows what the window shows, whoever makes the solids.
  for (const char* by : {"burin", "openscad"}) {
    folder_.write("p.scad", seen);
    ASSERT_EQ(run(std::string("info @/p.scad --json --csg ") + by), 0) << err_;
    EXPECT_EQ(nlohmann::json::parse(out_)["files"][0]["bounds"]["max"][2], 2) << by;
  }
}

TEST_F(Convert, OpenscadReadsDxfAtTrueScale) {
  if (!has_program("openscad")) GTEST_SKIP() << "openscad is not installed";
  ASSERT_EQ(run("convert @/r.json -o @/r.dxf"), 0);
  const auto import = [&](const std::string& layer) {
    // Arcs have as many corners there as $fn says.
    folder_.write("s.scad", "import(\"r.dxf\", layer=\"" + layer + "\", $fn=200);");
    EXPECT_TRUE(shell(fmt::format("cd {} && openscad -o s.svg s.scad", folder_.path())));
    return slurp(folder_ / "s.svg");
  };
  EXPECT_NE(import("square").find("width=\"100mm\" height=\"100mm\" viewBox=\"50 -150 100 100\""),
            std::string::npos);
  EXPECT_NE(import("circle").find("width=\"40mm\" height=\"40mm\" viewBox=\"210 -120 40 40\""),
            std::string::npos);
}

/// Reads r.dxf and prints kind, number of edges and box of each shape.
constexpr const char* kFreecadScript = R"py(
import os, sys, traceback
try:
    import FreeCAD, Import
    folder = os.environ["BURIN_FOLDER"]
    try:
        Import.readDXF(folder + "/line.dxf", FreeCAD.newDocument("line").Name)
    except RuntimeError:
        open(folder + "/refused", "w").close()
        os._exit(0)
    name = FreeCAD.newDocument("r").Name
    Import.readDXF(folder + "/r.dxf", name)
    with open(folder + "/shapes", "w") as out:
        for o in FreeCAD.getDocument(name).Objects:
            s = getattr(o, "Shape", None)
            if s is None: continue
            if not s.Edges: continue
            points = s.Edges[0].discretize(400)
            x = [p.x for p in points]
            y = [p.y for p in points]
            curve = s.Edges[0].Curve.TypeId
            out.write("%s %d %.4f %.4f %.4f %.4f %.4f\n" % (curve, len(s.Edges), s.Length,
                min(x), min(y), max(x), max(y)))
except BaseException:
    traceback.print_exc()
    os._exit(1)
os._exit(0)
)py";

TEST_F(Convert, FreecadReadsDxfAtTrueScale) {
  if (!has_program("freecadcmd")) GTEST_SKIP() << "freecad is not installed";
  ASSERT_EQ(run("convert @/r.json -o @/r.dxf --set dxf.splines=true"), 0);
  folder_.write("script.py", kFreecadScript);
  folder_.write("line.dxf",
                "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n9\n21\n0\n0\nENDSEC\n0\n"
                "EOF\n");
  ASSERT_TRUE(shell(fmt::format(
      "mkdir {0}/home; BURIN_FOLDER={0} FREECAD_USER_HOME={0}/home freecadcmd {0}/script.py",
      folder_.path())));
  // So does FreeCAD 1.0.0 of Debian 13 without a window.
  if (std::filesystem::exists(folder_ / "refused")) {
    GTEST_SKIP() << "this FreeCAD cannot even read one line of a DXF";
  }
  const std::string shapes = slurp(folder_ / "shapes");
  const auto holds = [&](const std::string& line) {
    return shapes.find(line + "\n") != std::string::npos;
  };
  EXPECT_TRUE(holds("Part::GeomLine 1 10.0000 50.0000 10.0000 50.0000 20.0000")) << shapes;
  EXPECT_TRUE(holds("Part::GeomLine 1 10.0000 150.0000 10.0000 150.0000 20.0000")) << shapes;
  EXPECT_TRUE(holds("Part::GeomLine 1 100.0000 50.0000 50.0000 150.0000 50.0000")) << shapes;
  std::smatch circle;
  ASSERT_TRUE(std::regex_search(
      shapes, circle,
      std::regex("Part::GeomCircle 1 ([0-9.]+) ([0-9.]+) ([0-9.]+) ([0-9.]+) ([0-9.]+)")))
      << shapes;
  EXPECT_NEAR(std::stod(circle[1]), 2 * 3.14159265 * 20, 0.05);
  EXPECT_NEAR(std::stod(circle[4]) - std::stod(circle[2]), 40, 0.05);
}

/// Whether all that a DXF draws lies within 0.02 mm of a drawing file, and the other way round; how
/// many entities there are of each kind.
constexpr const char* kCompareScript = R"py(
import collections, ezdxf, json, math, sys
drawing = json.load(open(sys.argv[1]))
ours = []
for layer in drawing["layers"]:
    for p in layer["paths"]:
        ours.append(p["points"] + (p["points"][:1] if p.get("closed") else []))
theirs, kinds = [], collections.Counter()
for e in ezdxf.readfile(sys.argv[2]).modelspace():
    kinds[e.dxftype()] += 1
    if e.dxftype() == "LINE":
        theirs.append([e.dxf.start, e.dxf.end])
    elif e.dxftype() == "LWPOLYLINE":
        points = [(x, y) for x, y in e.get_points("xy")]
        theirs.append(points + (points[:1] if e.closed else []))
    elif e.dxftype() in ("CIRCLE", "ARC"):
        begin, end = (0, 360) if e.dxftype() == "CIRCLE" else (e.dxf.start_angle, e.dxf.end_angle)
        turn = math.radians((end - begin) % 360 or 360)
        c, r = e.dxf.center, e.dxf.radius
        at = [math.radians(begin) + turn * k / 500 for k in range(501)]
        theirs.append([(c[0] + r * math.cos(t), c[1] + r * math.sin(t)) for t in at])
    else:
        theirs.append(list(e.flattening(0.001)))
theirs = [[(p[0], p[1]) for p in line] for line in theirs]
def dense(line):
    for a, b in zip(line, line[1:]):
        n = max(1, math.ceil(math.dist(a, b) / 0.2))
        for k in range(n + 1):
            yield a[0] + (b[0] - a[0]) * k / n, a[1] + (b[1] - a[1]) * k / n
def farthest(of, to):
    cells = collections.defaultdict(list)
    for line in to:
        for a, b in zip(line, line[1:]):
            for x, y in dense([a, b]):
                for i in (-1, 0, 1):
                    for j in (-1, 0, 1):
                        here = cells[round(x) + i, round(y) + j]
                        if not here or here[-1] != (a, b): here.append((a, b))
    worst = 0
    for line in of:
        for p in dense(line):
            best = 9
            for a, b in cells[round(p[0]), round(p[1])]:
                d = b[0] - a[0], b[1] - a[1]
                dd = d[0] ** 2 + d[1] ** 2
                t = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / dd if dd else 0
                t = min(1, max(0, t))
                best = min(best, math.dist(p, (a[0] + t * d[0], a[1] + t * d[1])))
            worst = max(worst, best)
    return worst
off = farthest(ours, theirs), farthest(theirs, ours)
open(sys.argv[3], "w").write("%.4f %.4f mm, %s" % (*off, dict(kinds)))
sys.exit(max(off) > 0.0201 or any(kinds[k] < 1 for k in sys.argv[4:]))
)py";

TEST_F(Convert, DxfDrawsWhatTheDrawingHasWithArcs) {
  if (!shell("/usr/bin/python3 -c \"import ezdxf\""))
    GTEST_SKIP() << "python3-ezdxf is not installed";
  folder_.write("compare.py", kCompareScript);
  for (const auto& [sample, view, kinds] :
       {std::tuple("gear_pump", "front", "CIRCLE ARC"), {"coupling", "iso", "ELLIPSE LINE"}}) {
    ASSERT_EQ(run(fmt::format("draw {}/samples/{}.step --view {} --style outline --quiet "
                              "-o @/c.json -o @/c.dxf",
                              BURIN_SOURCE_DIR, sample, view)),
              0);
    EXPECT_TRUE(
        shell(fmt::format("/usr/bin/python3 {0}/compare.py {0}/c.json {0}/c.dxf {0}/said {1}",
                          folder_.path(), kinds)))
        << sample << " " << view << ": " << slurp(folder_ / "said");
  }
}

/// A reader that finds what strict ones refuse.
TEST_F(Convert, EzdxfFindsNoErrorInDxf) {
  if (!shell("/usr/bin/python3 -c \"import ezdxf\""))
    GTEST_SKIP() << "python3-ezdxf is not installed";
  ASSERT_EQ(run("draw @/box.off -o @/r.dxf --style engraving --hidden dashed --quiet --set "
                "dxf.splines=true"),
            0);
  folder_.write("audit.py",
                "import ezdxf, sys\nd = ezdxf.readfile(sys.argv[1])\na = d.audit()\n"
                "sys.exit(len(a.errors) + len(a.fixes) + (len(d.modelspace()) < 100))\n");
  EXPECT_TRUE(shell(fmt::format("/usr/bin/python3 {0}/audit.py {0}/r.dxf", folder_.path())));
}

}  // namespace
}  // namespace burin::test
