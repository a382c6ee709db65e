#include <burin/plugin/sources.h>

#include "declared.h"
#include "rows.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <sstream>

// What a plug-in fills; it knows the name alone.
struct burin_scene {
  burin::plugin::ReadMeshes read;
  burin::RunContext* context = nullptr;
  std::string fault;

  /// What a call gives: the reader has to stop once something is wrong.
  std::int32_t state() const {
    if (context->cancelled()) return BURIN_CANCELLED;
    return fault.empty() ? BURIN_OK : BURIN_FAILED;
  }
};

namespace burin::plugin {
namespace {

constexpr std::size_t kLongestName = 1000;

std::string text_of(const char* text) {
  std::string out(text == nullptr ? "" : std::string(text, ::strnlen(text, kLongestName)));
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return out;
}

/// What is wrong with the arrays of a part; empty: nothing.
std::string mesh_fault(std::size_t points, const double* position, std::size_t triangles,
                       const std::uint32_t* corners) {
  constexpr std::size_t kMost = 0xFFFFFFFE;
  if (points > kMost || triangles > kMost) return "gives more than 4294967294 points or triangles";
  if ((points > 0 && position == nullptr) || (triangles > 0 && corners == nullptr)) {
    return "gives no array where there are points or triangles";
  }
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    if (corners[i] >= points) {
      return fmt::format("gives a triangle with the corner {} where there are {} points",
                         corners[i], points);
    }
  }
  return {};
}

std::int32_t take_mesh(burin_scene* scene, const char* name, std::size_t points,
                       const double* position, std::size_t triangles,
                       const std::uint32_t* corners) noexcept try {
  if (scene->state() != BURIN_OK) return scene->state();
  scene->fault = mesh_fault(points, position, triangles, corners);
  if (!scene->fault.empty()) return BURIN_FAILED;
  PolygonSoup soup;
  soup.name = text_of(name);
  soup.positions.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    soup.positions[i] = {position[3 * i], position[3 * i + 1], position[3 * i + 2]};
  }
  soup.indices.assign(corners, corners + 3 * triangles);
  for (std::size_t t = 1; t <= triangles; ++t) soup.offsets.push_back(3 * t);
  scene->read.objects.push_back(std::move(soup));
  return scene->state();
} catch (const std::bad_alloc&) {
  scene->fault = "does not fit into the memory of this machine";
  return BURIN_NO_MEMORY;
}

std::int32_t take_word(burin_scene* scene, std::int32_t severity, const char* code,
                       std::int64_t count, const char* message) noexcept try {
  constexpr std::size_t kMost = 1000;
  if (scene->read.diagnostics.entries().size() < kMost) {
    scene->read.diagnostics.add(severity == 0 ? Severity::Info : Severity::Warning,
                                "plugin." + text_of(code), count, text_of(message));
  }
  return scene->state();
} catch (const std::bad_alloc&) {
  return BURIN_NO_MEMORY;
}

std::int32_t take_progress(burin_scene* scene, double share) noexcept {
  if (std::isfinite(share)) scene->context->progress(std::min(1.0, std::max(0.0, share)));
  return scene->state();
}

constexpr burin_scene_calls kCalls{take_mesh, take_word, take_progress};

ReadMeshes read(const Source& source, const std::filesystem::path& path, std::string_view bytes,
                const std::vector<OptionValue>& values, RunContext& context) {
  burin_scene scene;
  scene.context = &context;
  burin_error error{};
  const auto& reader = source.functions<burin_reader_1>();
  const Values given(values);
  const std::int32_t code =
      reader.read(path.c_str(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                  given.data(), &kCalls, &scene, &error);
  context.check();
  const std::string message = message_of(error), name = source.factory->name;
  if (!scene.fault.empty()) {
    throw InputError(
        fmt::format("the reader '{}' of the plug-in {} {}", name, source.file, scene.fault),
        path.string());
  }
  if (code != BURIN_OK) {
    throw InputError(message.empty() ? fmt::format("the reader '{}' of the plug-in {} cannot read "
                                                   "it (error {})",
                                                   name, source.file, code)
                                     : message,
                     path.string(), std::max(0, error.line));
  }
  return std::move(scene.read);
}

}  // namespace

void add_reader(const Source& source) {
  const auto& functions = source.functions<burin_reader_1>();
  ReaderKind kind{.name = source.factory->name, .meaning = source.factory->meaning};
  std::istringstream words(functions.suffixes);
  for (std::string word; words >> word;) kind.suffixes.push_back(word);
  if (functions.knows != nullptr) {
    kind.knows = [knows = functions.knows](std::string_view head) {
      return knows(reinterpret_cast<const unsigned char*>(head.data()), head.size()) == 1;
    };
  }
  kind.read = [source](const std::filesystem::path& path, std::string_view bytes,
                       const std::vector<OptionValue>& values,
                       RunContext& context) { return read(source, path, bytes, values, context); };
  kind.options = declared(*source.factory);
  add(std::move(kind));
}

}  // namespace burin::plugin
