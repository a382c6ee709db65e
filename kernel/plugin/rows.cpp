#include "rows.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

namespace burin::plugin {
namespace {

const char* word_of(PluginError::Row row) {
  constexpr std::array kWords{"direction", "law",    "stroke kind", "form",
                              "reader",    "writer", "symbol"};
  return kWords[static_cast<std::size_t>(row)];
}

const char* word_of(std::int32_t code) {
  switch (code) {
    case BURIN_BAD_OPTION:
      return "takes no such options";
    case BURIN_BAD_INPUT:
      return "cannot use its input";
    case BURIN_NO_MEMORY:
      return "has no memory left";
    default:
      return "fails";
  }
}

void set(double (&to)[3], Vec3 v) {
  for (int i = 0; i < 3; ++i) to[i] = v[i];
}

}  // namespace

void fail(PluginError::Row row, const Source& source, const std::string& what) {
  const std::string name = source.factory->name;
  throw PluginError(
      row, name,
      fmt::format("the {} '{}' of the plug-in {} {}", word_of(row), name, source.file, what));
}

std::string message_of(const burin_error& error) {
  std::string text(error.message, ::strnlen(error.message, sizeof error.message));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

void check(PluginError::Row row, const Source& source, std::int32_t code,
           const burin_error& error) {
  if (code == BURIN_OK) return;
  const std::string message = message_of(error);
  fail(row, source,
       fmt::format("{} (error {}){}{}", word_of(code), code, message.empty() ? "" : ": ", message));
}

burin_view view_of(const Camera& camera, const VisibleSurfaces& shown, Vec3 to_light, Vec3 axis) {
  burin_view view{};
  set(view.to_viewer, camera.direction());
  set(view.right, camera.right());
  set(view.up, camera.up());
  view.perspective = camera.perspective() ? 1 : 0;
  if (camera.perspective()) set(view.eye, camera.eye());
  view.scale = camera.scale();
  set(view.to_light, normalize_or(to_light, camera.direction()));
  set(view.axis, normalize_or(axis, Vec3(0, 0, 1)));
  const Box3 box = box_of(shown.surfaces);
  if (!box.empty()) {
    set(view.low, box.min);
    set(view.high, box.max);
  }
  return view;
}

}  // namespace burin::plugin
