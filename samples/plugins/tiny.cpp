// A reader: files of lines "box NAME X0 Y0 Z0 X1 Y1 Z1", a part each; "#" begins a comment.
// burin draw shelf.tiny -o shelf.svg
#include <burin/plugin.h>

#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>

namespace {

std::int32_t refuse(burin_error* error, int line, const char* what) {
  error->line = line;
  std::snprintf(error->message, sizeof error->message, "%s", what);
  return BURIN_BAD_INPUT;
}

// The six sides of a box, two triangles each, outside to the left of their edges.
std::int32_t give_box(const std::string& name, const double* a, const burin_scene_calls* calls, burin_scene* scene) {
  static const std::uint32_t corners[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                            2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  double points[24];
  for (int i = 0; i < 8; ++i) {
    points[3 * i] = a[i & 1 ? 3 : 0];
    points[3 * i + 1] = a[i & 2 ? 4 : 1];
    points[3 * i + 2] = a[i & 4 ? 5 : 2];
  }
  return calls->mesh(scene, name.c_str(), 8, points, 12, corners);
}

std::int32_t read_lines(const std::string& text, double scale, const burin_scene_calls* calls, burin_scene* scene,
                        burin_error* error) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word, name;
    double a[6];
    if (!(words >> word)) continue;
    if (word != "box") return refuse(error, number, "a line begins with box");
    words >> name;
    for (double& x : a) {
      words >> x;
      x *= scale;
    }
    if (!words) return refuse(error, number, "a box has a name and six numbers");
    for (int i = 0; i < 3; ++i) {
      if (!(a[i] < a[i + 3])) return refuse(error, number, "the first corner of a box is not below the second");
    }
    const std::int32_t code = give_box(name, a, calls, scene);
    if (code != BURIN_OK) return code;
  }
  return BURIN_OK;
}

std::int32_t read(const char*, const unsigned char* bytes, std::size_t size, const burin_value* values,
                  const burin_scene_calls* calls, burin_scene* scene, burin_error* error) {
  try {
    return read_lines(std::string(bytes, bytes + size), values[0].number, calls, scene, error);
  } catch (...) {
    return BURIN_NO_MEMORY;
  }
}

const burin_option kOptions[] = {
    {"scale", "mm of a unit of the file", BURIN_NUMBER, 1e-6, 1e6, "mm", nullptr, {1, {}, nullptr}}};
const burin_reader_1 kFunctions = {".tiny", nullptr, read};
const burin_factory kFactories[] = {{BURIN_READER_1, "tiny", "boxes in lines of text", 1, kOptions, &kFunctions}};
const burin_plugin_table kTable = {BURIN_PLUGIN_ABI, "tiny", "1.0", 1, kFactories};

}  // namespace

const burin_plugin_table* burin_plugin(std::uint32_t abi) { return abi == BURIN_PLUGIN_ABI ? &kTable : nullptr; }
