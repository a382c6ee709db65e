// burin_fuzz [FILES AND OPTIONS OF LIBFUZZER]: the environment's BURIN_FUZZ names the target;
// "list" prints their names.
#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include "targets.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>

namespace {

using burin::fuzz::file;
using burin::fuzz::member;
using Target = std::function<void(std::string_view)>;

const std::map<std::string, Target>& targets() {
  static const std::map<std::string, Target> all_targets = [] {
    std::map<std::string, Target> all{
        {"3mf-model", [](auto bytes) { member(bytes, "3D/3dmodel.model", ".3mf"); }},
        {"fcstd-document", [](auto bytes) { member(bytes, "Document.xml", ".FCStd"); }},
        {"implicit", burin::fuzz::implicit},
        {"csg", burin::fuzz::csg},
        {"style", burin::fuzz::style},
        {"illustration", burin::fuzz::illustration},
        {"drawing", burin::fuzz::drawing},
        {"options", burin::fuzz::options},
        {"plugin", burin::fuzz::plugin}};
    for (const char* format :
         {"stl", "obj", "off", "ply", "3mf", "gltf", "glb", "itd", "bez", "nrrd", "mha", "inr",
          "nii", "vti", "FCStd", "step", "iges", "brep"}) {
      all[format] = [suffix = std::string(".") + format](auto bytes) { file(bytes, suffix); };
    }
    return all;
  }();
  return all_targets;
}

const Target& target() {
  static const Target& chosen = []() -> const Target& {
    const char* name = std::getenv("BURIN_FUZZ");
    const auto found = targets().find(name ? name : "");
    if (found != targets().end()) return found->second;
    if (!name || std::string_view(name) != "list") {
      std::fprintf(stderr, "burin_fuzz: BURIN_FUZZ has to name one of these targets:\n");
    }
    for (const auto& [known, body] : targets()) std::printf("%s\n", known.c_str());
    std::exit(name && std::string_view(name) == "list" ? 0 : 2);
  }();
  return chosen;
}

}  // namespace

// The names are libFuzzer's.
extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {  // NOLINT
  // What happens depends on the bytes alone.
  static const burin::ThreadLimit one_thread(1);
  target();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT
  try {
    target()({reinterpret_cast<const char*>(data), size});
  } catch (const burin::Error& e) {
    const std::string_view text = e.what();
    if (text.empty() || text.find('\n') != std::string_view::npos) {
      std::fprintf(stderr, "an error in no line or several: '%s'\n", e.what());
      std::abort();
    }
  }
  return 0;
}
