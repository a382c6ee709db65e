#include <burin/forms/implicit/implicit_form.h>

#include "readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace burin::detail {
namespace {

/// What an option is for, where it is not.
struct Purpose {
  std::string_view name, what;
};
constexpr std::string_view kVolumes = "volumes";
constexpr std::array kPurposes{
    Purpose{"bounds", "functions, volumes and trivariate splines"},
    Purpose{"mesher", "functions and volumes"},
    Purpose{"iso", "volumes and trivariate splines"},
    Purpose{"inside", "volumes and trivariate splines"},
    Purpose{"smooth", kVolumes},
    Purpose{"specks", kVolumes},
    Purpose{"volume_degree", kVolumes},
    Purpose{"interpolate", kVolumes},
    Purpose{"raw", "files of raw samples, whose format nothing else tells"},
    Purpose{"raw_skip", "files of raw samples"},
    Purpose{"define", "OpenSCAD files"},
    Purpose{"openscad_timeout", "OpenSCAD files"},
    Purpose{"object", "FreeCAD documents"},
    Purpose{"recompute", "FreeCAD documents"},
    Purpose{"freecad_timeout", "FreeCAD documents that are recomputed"},
    Purpose{"heal", "meshes and OpenSCAD files"},
};

/// Whether a reader that knows an option also met what it is about.
bool met(std::string_view name, const ReadOptions& options, const std::string& path,
         const Reader& reader, const Scene& scene) {
  if (std::find(reader.options.begin(), reader.options.end(), name) == reader.options.end()) {
    return false;
  }
  if (name == "freecad_timeout") return options.recompute;
  // The layout of raw samples goes for any file that nothing else tells of.
  if (name == "raw" || name == "raw_skip") {
    ReadOptions without = options;
    without.volume.raw.reset();
    const std::string suffix = std::filesystem::path(path).extension().string();
    return suffix == ".raw" || &reader_of(path, without) != &reader;
  }
  const bool is_spline_file =
      std::find(reader.options.begin(), reader.options.end(), "mesher") == reader.options.end();
  if (!is_spline_file || (name != "bounds" && name != "iso" && name != "inside")) return true;
  // Files of spline patches may have trivariate ones among them.
  return std::any_of(scene.parts.begin(), scene.parts.end(), [&](const Part& part) {
    return part.source == path && dynamic_cast<const ImplicitForm*>(part.form.get()) != nullptr;
  });
}

}  // namespace

void name_unused(const ReadOptions& options, const std::vector<std::string>& paths,
                 std::span<const Reader* const> readers, Scene& scene) {
  for (const ReadOptions::Given& given : options.given) {
    bool used = false;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      used = used || met(given.name, options, paths[i], *readers[i], scene);
    }
    if (used) continue;
    const auto purpose = std::ranges::find(kPurposes, given.name, &Purpose::name);
    const std::string where =
        paths.size() == 1 ? paths.front() : fmt::format("any of the {} inputs", paths.size());
    scene.diagnostics.add(Severity::Warning, "option.unused", 1,
                          fmt::format("{} has no effect on {}; it is for {}", given.spelled, where,
                                      purpose == kPurposes.end() ? "other files" : purpose->what));
  }
}

}  // namespace burin::detail
