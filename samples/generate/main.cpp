// burin_samples models FOLDER: writes the sample models.
// burin_samples splines FOLDER: those of them that are spline patches.
// burin_samples volumes FOLDER: those that are volumes.
// burin_samples large FOLDER: writes the meshes of the benchmarks, of 100,000 and of 1,000,000
// triangles.
#include "lantern.h"
#include "models.h"
#include "splines.h"
#include "volumes.h"
#include "write_mesh.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>

namespace {

using burin::samples::Solid;

void save(const std::vector<Solid>& solids, const std::filesystem::path& path) {
  burin::samples::write(solids, path);
  std::size_t triangles = 0;
  for (const Solid& s : solids) triangles += s.mesh.triangles.size();
  fmt::print("{:<28} {:>9} bytes {:>8} triangles {:>3} parts\n", path.filename().string(),
             std::filesystem::file_size(path), triangles, solids.size());
}

void write_models(const std::filesystem::path& folder) {
  using namespace burin::samples;
  save(spindle(), folder / "spindle.stl");
  save(bracket(), folder / "bracket.off");
  save(gear(), folder / "gear.ply");
  save(bolt(), folder / "bolt.3mf");
  save(bearing_stand(), folder / "bearing_stand.obj");
  save(spring(), folder / "spring.stl");
  save(knot(400, 44), folder / "knot.ply");
  save(vase(), folder / "vase.ply");
  save(blob(1.2), folder / "blob.off");
  save(teapot(), folder / "teapot.ply");
  save(gyroid(), folder / "gyroid.ply");
  save(moai(0.98, 0.06), folder / "moai_scan.ply");
  write_lantern(folder / "lantern.glb");
}

void save(const std::vector<burin::samples::SplineObject>& objects,
          const std::filesystem::path& path) {
  burin::samples::write_irit(objects, path);
  std::size_t patches = 0;
  for (const auto& object : objects) patches += object.surfaces.size();
  fmt::print("{:<28} {:>9} bytes {:>8} patches   {:>3} parts\n", path.filename().string(),
             std::filesystem::file_size(path), patches, objects.size());
}

void write_splines(const std::filesystem::path& folder) {
  save(burin::samples::horn(), folder / "horn.itd");
  save(burin::samples::spline_teapot(), folder / "teapot.itd");
  save(burin::samples::two_discs(), folder / "two_discs.itd");
  save(burin::samples::aeroplane(), folder / "aeroplane.itd");
  save(burin::samples::star(), folder / "star.itd");
  save(burin::samples::tableware(), folder / "tableware.itd");
  std::filesystem::create_directories(folder / "chess");
  for (const auto& [name, objects] : burin::samples::chess_pieces()) {
    save(objects, folder / "chess" / (name + ".itd"));
  }
  burin::samples::write_chess(folder / "chess.burin.json");
}

void write_volumes(const std::filesystem::path& folder) {
  const auto save = [](const burin::samples::SampleVolume& volume,
                       const std::filesystem::path& path) {
    burin::samples::write_nrrd(volume, path);
    fmt::print("{:<28} {:>9} bytes\n", path.filename().string(), std::filesystem::file_size(path));
  };
  save(burin::samples::tube_joints(), folder / "tube_joints.nrrd");
  save(burin::samples::head(), folder / "head.nrrd");
}

void write_large(const std::filesystem::path& folder) {
  using namespace burin::samples;
  save(knot(790, 63), folder / "knot_100k.stl");
  save(knot(2500, 200), folder / "knot_1m.stl");
  save(moai(0.9045, 0), folder / "moai_100k.stl");
  save(moai(0.2857, 0), folder / "moai_1m.stl");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc == 3 ? argv[1] : "";
  try {
    if (what == "models") {
      write_models(argv[2]);
      write_splines(argv[2]);
      write_volumes(argv[2]);
    } else if (what == "splines") {
      write_splines(argv[2]);
    } else if (what == "volumes") {
      write_volumes(argv[2]);
    } else if (what == "large") {
      write_large(argv[2]);
    } else {
      std::fputs("usage: burin_samples models|splines|volumes|large FOLDER\n", stderr);
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "burin_samples: error: {}\n", error.what());
    return 1;
  }
  return 0;
}
