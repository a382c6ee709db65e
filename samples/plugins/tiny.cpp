// A reader: files of lines "box NAME X0 Y0 Z0 X1 Y1 Z1", a part each; "#" begins a comment.
// burin draw shelf.tiny -o shelf.svg
#include <burin/plugin.h>

#include <cstdio>
#include <sstream>
#include <string>

namespace {

struct Tiny {
  double scale;
  const burin_scene_calls* calls;
  burin_scene* scene;
  burin_error* error;
};

int32_t refuse(const Tiny& t, int line, const char* what) {
  t.error->line = line;
  std::snprintf(t.error->message, sizeof t.error->message, "%s", what);
  return BURIN_BAD_INPUT;
}

// The six sides of a box, two triangles each, outside to the left of their edges.
int32_t give_box(const Tiny& t, const std::string& name, const double* a) {
  static const uint32_t corners[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  double points[24];
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) points[3 * i + k] = t.scale * a[(i >> k) & 1 ? 3 + k : k];
  }
  return t.calls->mesh(t.scene, name.c_str(), 8, points, 12, corners);
}

int32_t read_line(const Tiny& t, const std::string& line, int number) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::string word, name;
  double a[6];
  if (!(words >> word)) return BURIN_OK;
  if (word != "box") return refuse(t, number, "a line begins with box");
  words >> name;
  for (double& x : a) words >> x;
  if (!words) return refuse(t, number, "a box has a name and six numbers");
  for (int i = 0; i < 3; ++i) {
    if (!(a[i] < a[i + 3])) return refuse(t, number, "the first corner is not below the second");
  }
  return give_box(t, name, a);
}

int32_t read(const char*, const unsigned char* bytes, size_t size, const burin_value* values,
             const burin_scene_calls* calls, burin_scene* scene, burin_error* error) try {
  std::istringstream lines(std::string(bytes, bytes + size));
  const Tiny tiny{values[0].number, calls, scene, error};
  int32_t code = BURIN_OK;
  int number = 0;
  for (std::string line; code == BURIN_OK && std::getline(lines, line);) {
    code = read_line(tiny, line, ++number);
  }
  return code;
} catch (...) {
  return BURIN_NO_MEMORY;
}

const burin_option kOptions[] = {
    {"scale", "mm of a unit", BURIN_NUMBER, 1e-6, 1e6, "mm", nullptr, {1, {}, nullptr}}};
const burin_reader_1 kReader = {".tiny", nullptr, read};
const burin_factory kFactories[] = {{BURIN_READER_1, "tiny", "boxes", 1, kOptions, &kReader}};
const burin_plugin_table kTable = {BURIN_PLUGIN_ABI, "tiny", "1.0", 1, kFactories};

}  // namespace

const burin_plugin_table* burin_plugin(uint32_t abi) {
  return abi == BURIN_PLUGIN_ABI ? &kTable : nullptr;
}
