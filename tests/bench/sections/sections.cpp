// burin_sections FILE...: up to eight solids of each CAD file, cut by three planes (z in the
// middle, x at 37 %, an oblique one), a row each: whether the cut is closed, its area and loops,
// OCCT's, and seconds.
#include <burin/base/error.h>
#include <burin/converters/cad_reader.h>

#include <burin_test/occt_section.h>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>

namespace burin {
namespace {

constexpr std::size_t kMostSolids = 8;
/// Of the size of the part: chords.
constexpr double kDeflection = 2e-4;

std::vector<std::pair<const char*, CutPlane>> planes_of(const Box3& box) {
  const Vec3 c = box.center(), n = glm::normalize(Vec3(1, 2, 3));
  return {{"z", {{0, 0, 1}, c.z}},
          {"x", {{1, 0, 0}, box.min.x + 0.37 * (box.max.x - box.min.x)}},
          {"oblique", {n, glm::dot(n, c)}}};
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void cut(const std::string& name, const BrepModel& model, const Surface& whole,
         const std::shared_ptr<const Form>& held) {
  RunContext context;
  const Box3 box = model.bounds(Mat3(1));
  const double size = box.diagonal(), deflection = kDeflection * size;
  const bool closed_before = std::ranges::all_of(whole.proxy().topology.component_closed,
                                                 [](auto closed) { return closed != 0; });
  for (const auto& [axis, plane] : planes_of(box)) {
    Diagnostics said;
    const auto start = std::chrono::steady_clock::now();
    const auto surface = cut_form(held, plane, 0, name)
                             ->realise({.tolerance = deflection, .diagnostics = &said}, context);
    const double seconds = since(start);
    const test::CapMeasure cap = test::measure_cap(*surface);
    const bool open = std::ranges::any_of(
        said.entries(), [](const Diagnostic& d) { return d.code == "section.open"; });
    const test::OcctCap occt = test::occt_cap(model.shape(), plane, 4 * size + 10);
    const bool in_face = test::face_in_plane(whole.proxy(), plane, 1e-6 * size);
    const double off = std::abs(cap.area - occt.area);
    const bool agrees = off <= deflection * cap.perimeter + 1e-9 * size * size;
    const char* verdict = agrees ? "agrees" : in_face ? "in_face" : open ? "open" : "DIFFERS";
    if (!agrees && !in_face && !open) {
      // A hair to either side OCCT tells again; and points that are inside tell roughly.
      bool ours = false;
      for (const double aside : {-1e-4, 1e-4}) {
        const CutPlane beside{plane.normal, plane.offset + aside * size};
        const test::OcctCap again = test::occt_cap(model.shape(), beside, 4 * size + 10);
        fmt::print("# {} {}: OCCT {:.6g} mm2 {:.0e} of the size aside\n", name, axis, again.area,
                   aside);
        ours = ours || std::abs(again.area - cap.area) < 0.01 * cap.area;
      }
      const double inside = test::classified_area(model.shape(), plane, box);
      fmt::print("# {} {}: {:.6g} mm2 by points inside\n", name, axis, inside);
      ours = ours || std::abs(inside - cap.area) < 0.02 * inside;
      if (ours) verdict = "occt_wrong";
    }
    fmt::print("{} {} {} {} {} {} {:.6g} {:.6g} {} {} {:.3g} {:.3g} {:.5f} {:.5f}\n", name, axis,
               whole.proxy().mesh.triangles.size(), closed_before ? "closed" : "holes",
               open ? "open" : "closes", verdict, cap.area, occt.area, cap.loops, occt.loops,
               off / (deflection * std::max(cap.perimeter, 1e-12)), cap.off_surface / deflection,
               seconds, occt.seconds);
    std::fflush(stdout);
  }
}

void run(const std::filesystem::path& file) {
  RunContext context;
  const Scene scene = read_cad(file, context);
  std::set<const BrepModel*> done;
  for (const Part& part : scene.parts) {
    const auto* brep = dynamic_cast<const BrepForm*>(part.form.get());
    if (!brep || done.size() == kMostSolids || !done.insert(&brep->model()).second) continue;
    std::string name = fmt::format("{}#{}", file.filename().string(), done.size());
    std::ranges::replace(name, ' ', '_');
    try {
      const BrepForm form(std::shared_ptr<const BrepModel>(std::shared_ptr<void>(), &brep->model()),
                          {});
      const auto whole = form.realise({.tolerance = kDeflection * brep->model().size()}, context);
      cut(name, brep->model(), *whole, std::make_shared<test::HeldForm>(whole));
    } catch (const std::exception& e) {
      fmt::print("{} - - - - FAILED {}\n", name, e.what());
    }
  }
}

}  // namespace
}  // namespace burin

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    try {
      burin::run(argv[i]);
    } catch (const std::exception& e) {
      fmt::print("{} - - - - UNREAD {}\n", argv[i], e.what());
    }
  }
}
