#pragma once
// Fonts by the names that OpenSCAD's users give; for converters/openscad alone.

#include <ft2build.h>

#include FT_FREETYPE_H

#include <fontconfig/fontconfig.h>

#include <map>
#include <memory>
#include <string>

namespace burin::csg {

/// The fonts of this machine; faces are opened once.
class Fonts {
 public:
  /// Reads fontconfig's configuration, and the folders ~/.fonts and those of OPENSCAD_FONT_PATH.
  /// Throws Error where fontconfig or FreeType cannot begin.
  Fonts();
  ~Fonts();
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;

  struct Found {
    /// nullptr where this machine has no font at all.
    FT_Face face = nullptr;
    /// The family in the file is none of those asked for.
    bool replaced = false;
  };
  /// "Family:style=Bold", as fontconfig writes patterns; empty: Liberation Sans.
  Found find(const std::string& name);

 private:
  Found open(const std::string& name);

  FcConfig* config_ = nullptr;
  FT_Library library_ = nullptr;
  std::map<std::string, Found> faces_;
};

}  // namespace burin::csg
