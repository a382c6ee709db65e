#include "document.h"

#include <burin/base/missing_file.h>

#include "byte_order_mark.h"
#include "foreign_file.h"
#include "text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

// tinygltf reads files by itself, fails where a buffer is of another length than it should be, and
// goes down into nested values without an end: the JSON is looked at first, and files are handed to
// it.
namespace burin::gltf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kDeepest = 100;  // values inside values
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

bool is_binary(const Source& source) { return source.bytes().starts_with("glTF"); }

/// The text of a file, which a binary one has in its first chunk.
std::string_view json_of(const Source& source) {
  const std::string_view bytes = source.bytes();
  if (!is_binary(source)) return bytes.substr(byte_order_mark(bytes));
  const auto truncated = [&] {
    source.fail_at_byte(bytes.size(), "the glTF ends too early; it is truncated, export it again");
  };
  if (bytes.size() < kHeader + kChunkHeader) truncated();
  if (const std::uint32_t version = number_at(bytes, 4); version != 2) {
    source.fail(fmt::format("is binary glTF of version {}; only version 2 is read", version));
  }
  const std::uint32_t claimed = number_at(bytes, 8), text = number_at(bytes, kHeader);
  if (claimed > bytes.size() || text > bytes.size() - kHeader - kChunkHeader) truncated();
  return bytes.substr(kHeader + kChunkHeader, text);
}

Json parsed(const Source& source) {
  bool too_deep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    source.context().check();
    too_deep = too_deep || depth > kDeepest;
    return depth <= kDeepest;
  };
  const std::string_view text = json_of(source);
  Json json = Json::parse(text.begin(), text.end(), watch, false);
  if (too_deep) source.fail("its values lie in each other more than 100 deep; it is damaged");
  if (!json.is_object()) {
    if (const char* what = foreign_file(source.bytes())) source.fail(what);
    source.fail("is no glTF, or its text is damaged or truncated; export it again");
  }
  return json;
}

/// What changes nothing of the shape, or is looked at.
bool is_read(const std::string& extension) {
  static constexpr std::array<std::string_view, 12> kRead{
      "KHR_mesh_quantization", "KHR_texture_transform",   "KHR_texture_basisu",
      "KHR_lights_punctual",   "KHR_node_visibility",     "KHR_xmp_json_ld",
      "KHR_animation_pointer", "EXT_mesh_gpu_instancing", "EXT_texture_webp",
      "EXT_texture_avif",      "MSFT_texture_dds",        "MSFT_lod"};
  return extension.starts_with("KHR_materials_") ||
         std::ranges::find(kRead, extension) != kRead.end();
}

void check_extensions(const Json& json, const Source& source) {
  const auto required = json.find("extensionsRequired");
  if (required == json.end() || !required->is_array()) return;
  for (const Json& one : *required) {
    if (!one.is_string() || is_read(one.get<std::string>())) continue;
    const auto name = one.get<std::string>();
    const bool packs = name.find("compression") != name.npos;
    source.fail(fmt::format(
        "needs the extension {} of glTF, which is not read; export it {}", in_quotes(name),
        packs ? "without compression of meshes" : "without that extension, or as OBJ, STL or 3MF"));
  }
}

void check_version(const Json& json, const Source& source) {
  const auto asset = json.find("asset");
  if (asset == json.end() || !asset->is_object()) {
    source.fail("has no 'asset', so that it is no glTF 2.0; export it again");
  }
  const auto version = asset->find("version");
  const std::string text =
      version != asset->end() && version->is_string() ? version->get<std::string>() : "";
  if (text.starts_with("2.")) return;
  source.fail(fmt::format("is glTF of version {}; only version 2 is read", in_quotes(text)));
}

/// Files that buffers name, and how much of each they want.
struct Beside {
  const Source& source;
  fs::path folder;
  std::map<std::string, std::size_t> lengths;
};

int hex(char c) {
  if (is_digit(c)) return c - '0';
  c = static_cast<char>(c | 0x20);
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/// "my%20data.bin": "my data.bin".
std::string unescaped(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape =
        uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
    out += escape ? static_cast<char>(16 * hex(uri[i + 1]) + hex(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return out;
}

Beside files_of(const Json& json, const Source& source) {
  Beside beside{source, fs::path(source.file()).parent_path(), {}};
  const auto buffers = json.find("buffers");
  if (buffers == json.end() || !buffers->is_array()) return beside;
  for (const Json& buffer : *buffers) {
    if (!buffer.is_object()) continue;
    const auto uri = buffer.find("uri");
    const auto length = buffer.find("byteLength");
    if (uri == buffer.end() || !uri->is_string()) continue;
    const auto text = uri->get<std::string>();
    if (text.starts_with("data:")) continue;
    if (length != buffer.end() && length->is_number_unsigned()) {
      beside.lengths[unescaped(text)] = length->get<std::size_t>();
    }
  }
  return beside;
}

/// The name that tinygltf joined to the folder that it was given, "".
std::string named(std::string path) {
  while (path.starts_with("./")) path.erase(0, 2);
  return path;
}

bool exists(const std::string& path, void* data) {
  return static_cast<const Beside*>(data)->lengths.contains(named(path));
}
std::string as_it_is(const std::string& path, void* /*data*/) { return path; }

/// A file of buffers; where it cannot be read, said of the glTF that needs it.
Source file_beside(const Beside& beside, const std::string& name) {
  try {
    return {beside.folder / name, beside.source.context()};
  } catch (const MissingFile&) {
    beside.source.fail(fmt::format(
        "needs the file {}, which is not there; put it beside, or export the model as .glb",
        clean_name(name)));
  }
}

/// Throws through tinygltf, which holds nothing that would be lost.
bool read_whole(std::vector<unsigned char>* out, std::string* /*error*/, const std::string& path,
                void* data) {
  const auto& beside = *static_cast<const Beside*>(data);
  const Source file = file_beside(beside, named(path));
  const std::size_t wanted = beside.lengths.at(named(path));
  if (wanted > file.bytes().size()) {
    file.fail(fmt::format("holds {} bytes, {} needs {}; it is truncated, export the model again",
                          file.bytes().size(), beside.source.file(), wanted));
  }
  const auto* begin = reinterpret_cast<const unsigned char*>(file.bytes().data());
  out->assign(begin, begin + wanted);
  return true;
}

bool write_nothing(std::string* /*error*/, const std::string& /*path*/,
                   const std::vector<unsigned char>& /*bytes*/, void* /*data*/) {
  return false;
}

/// Since 2.9 tinygltf also asks for sizes, to refuse what is above 2 GB; no file is too large here.
template <class Callbacks>
void allow_all_sizes(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](std::size_t* size, auto&&...) {
      *size = 0;
      return true;
    };
  }
}

tinygltf::FsCallbacks callbacks_for(Beside& beside) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = exists;
  callbacks.ExpandFilePath = as_it_is;
  callbacks.ReadWholeFile = read_whole;
  callbacks.WriteWholeFile = write_nothing;
  callbacks.user_data = &beside;
  allow_all_sizes(callbacks);
  return callbacks;
}

/// Pictures are not looked at.
bool no_image(tinygltf::Image* /*image*/, int /*index*/, std::string* /*error*/,
              std::string* /*warning*/, int /*width*/, int /*height*/,
              const unsigned char* /*bytes*/, int /*size*/, void* /*data*/) {
  return true;
}

/// The first line of what tinygltf says.
std::string first_line(const std::string& text) {
  return clean_name(std::string_view(text).substr(0, text.find('\n')));
}

}  // namespace

tinygltf::Model load(const Source& source) {
  const Json json = parsed(source);
  check_version(json, source);
  check_extensions(json, source);
  if (source.bytes().size() > std::numeric_limits<unsigned>::max()) {
    source.fail("is larger than 4 GB, which glTF does not allow");
  }
  Beside beside = files_of(json, source);
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(no_image, nullptr);
  reader.SetFsCallbacks(callbacks_for(beside));
  tinygltf::Model model;
  std::string error, warning;
  bool good = false;
  try {
    if (is_binary(source)) {
      good = reader.LoadBinaryFromMemory(
          &model, &error, &warning, reinterpret_cast<const unsigned char*>(source.bytes().data()),
          static_cast<unsigned>(source.bytes().size()), "");
    } else {
      const std::string_view text = json_of(source);
      good = reader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                        static_cast<unsigned>(text.size()), "");
    }
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!good) {
    source.fail(fmt::format("is a damaged glTF ({}); export it again",
                            error.empty() ? "it cannot be parsed" : first_line(error)));
  }
  return model;
}

}  // namespace burin::gltf
