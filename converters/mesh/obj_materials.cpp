#include "obj_materials.h"

#include "byte_order_mark.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace burin {
namespace {

namespace fs = std::filesystem;

class MaterialReader {
 public:
  MaterialReader(const Source& source, ObjMaterials& out)
      : source_(source), text_(source, byte_order_mark(source.bytes())), out_(out) {}

  void read() {
    for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
      source_.context().check();
      statement();
      text_.next_line();
    }
    end();
  }

 private:
  void statement() {
    const std::string word = lowered(text_.token());
    if (word == "newmtl") {
      end();
      name_ = text_.rest_of_line();
      color_.reset();
      opacity_ = 1;
      has_dissolve_ = false;
      pictured_ = false;
    } else if (word == "kd") {
      diffuse();
    } else if (word == "d" || word == "tr") {
      transparency(word == "d");
    } else if (word == "map_kd") {
      pictured_ = true;
    }
  }

  /// "d" is opacity and "Tr" what is missing of it; programs that write both mean "d": some of them
  /// take "Tr" for the same.
  void transparency(bool dissolve) {
    double value = 0;
    if (!last_number(value) || (!dissolve && has_dissolve_)) return;
    has_dissolve_ |= dissolve;
    opacity_ = dissolve ? value : 1 - value;
  }

  /// "Kd r g b"; "Kd r" is grey; spectra are no colour that could be told.
  void diffuse() {
    Rgba color{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i) {
      text_.skip_blanks();
      double value = 0;
      const std::string_view word = text_.token();
      if (word.empty() && i > 0) {
        color[i] = color[0];
      } else if (parse_double(word, value)) {
        color[i] = channel(value);
      } else {
        return;
      }
    }
    color_ = color;
  }

  /// "d 0.5", "d -halo 0.5".
  bool last_number(double& value) {
    const std::string_view line = text_.rest_of_line();
    const std::size_t blank = line.find_last_of(" \t");
    return parse_double(blank == line.npos ? line : line.substr(blank + 1), value);
  }

  void end() {
    if (name_.empty()) return;
    if (color_) (*color_)[3] = channel(opacity_);
    // The picture is what it looks like; the colour only tints it.
    out_.insert_or_assign(name_, pictured_ ? std::nullopt : color_);
  }

  const Source& source_;
  TextCursor text_;
  ObjMaterials& out_;
  std::string name_;
  std::optional<Rgba> color_;
  double opacity_ = 1;
  bool has_dissolve_ = false;
  bool pictured_ = false;
};

/// The file in the folder of the OBJ, also where its name was written with the folders of another
/// machine; empty where there is none.
fs::path found_beside(const fs::path& obj, std::string name) {
  std::ranges::replace(name, '\\', '/');
  std::error_code error;
  for (const fs::path& one : {fs::path(name), fs::path(name).filename()}) {
    fs::path path = obj.parent_path() / one;
    if (fs::is_regular_file(path, error)) return path;
  }
  return {};
}

}  // namespace

ObjMaterials read_obj_materials(std::span<const std::string> libraries, const Source& obj,
                                Diagnostics& diagnostics) {
  ObjMaterials out;
  for (const std::string& name : libraries) {
    const fs::path path = found_beside(obj.file(), name);
    try {
      if (path.empty()) throw InputError("is not there");
      const Source source(path, obj.context());
      MaterialReader(source, out).read();
    } catch (const InputError& e) {
      diagnostics.add(Severity::Info, "obj.no_materials", 1,
                      fmt::format("the material library {} {}; parts that use it have no colours",
                                  in_quotes(name), e.what()));
    }
  }
  return out;
}

}  // namespace burin
