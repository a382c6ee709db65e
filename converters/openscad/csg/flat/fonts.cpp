#include "fonts.h"

#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include FT_TRUETYPE_IDS_H

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::csg {
namespace {

constexpr const char* kDefault = "Liberation Sans:style=Regular";

void add_folder(FcConfig* config, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return;
  FcConfigAppFontAddDir(config, reinterpret_cast<const FcChar8*>(folder.c_str()));
}

/// Symbol fonts have no Unicode; then the first map of these, OpenSCAD's order.
void choose_letters(FT_Face face) {
  if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0) return;
  struct Map {
    int platform, encoding;
  };
  constexpr Map kMaps[] = {{TT_PLATFORM_MICROSOFT, TT_MS_ID_UNICODE_CS},
                           {TT_PLATFORM_ISO, TT_ISO_ID_10646},
                           {TT_PLATFORM_APPLE_UNICODE, -1},
                           {TT_PLATFORM_MICROSOFT, TT_MS_ID_SYMBOL_CS},
                           {TT_PLATFORM_MACINTOSH, TT_MAC_ID_ROMAN},
                           {TT_PLATFORM_ISO, TT_ISO_ID_8859_1},
                           {TT_PLATFORM_ISO, TT_ISO_ID_7BIT_ASCII}};
  for (const Map& map : kMaps) {
    for (int i = 0; i < face->num_charmaps; ++i) {
      const FT_CharMap has = face->charmaps[i];
      if (has->platform_id != map.platform) continue;
      if (map.encoding >= 0 && has->encoding_id != map.encoding) continue;
      if (FT_Set_Charmap(face, has) == 0) return;
    }
  }
}

/// Patterns of fontconfig are freed whatever happens.
struct Pattern {
  explicit Pattern(FcPattern* of) : p(of) {}
  ~Pattern() {
    if (p) FcPatternDestroy(p);
  }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  FcPattern* p;
};

std::string_view text_of(const FcChar8* text) { return reinterpret_cast<const char*>(text); }

bool has_family(FcPattern* pattern, std::string_view family) {
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(pattern, FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    if (equal_but_for_case(text_of(name), family)) return true;
  }
  return false;
}

}  // namespace

Fonts::Fonts() : config_(FcInitLoadConfig()) {
  if (!config_) throw Error("the fonts of this machine cannot be read: fontconfig does not start");
  if (const char* home = std::getenv("HOME")) {
    add_folder(config_, std::filesystem::path(home) / ".fonts");
  }
  if (const char* folders = std::getenv("OPENSCAD_FONT_PATH")) {
    std::string_view rest = folders;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      add_folder(config_, std::filesystem::path(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  FcConfigBuildFonts(config_);
  if (FT_Init_FreeType(&library_) != 0) {
    FcConfigDestroy(config_);
    throw Error("the fonts of this machine cannot be read: FreeType does not start");
  }
}

Fonts::~Fonts() {
  FT_Done_FreeType(library_);  // with all its faces
  FcConfigDestroy(config_);
}

Fonts::Found Fonts::find(const std::string& name) {
  const std::size_t begin = name.find_first_not_of(" \t\r\n"),
                    end = name.find_last_not_of(" \t\r\n");
  const std::string wanted =
      begin == std::string::npos ? kDefault : name.substr(begin, end - begin + 1);
  const auto [found, is_new] = faces_.try_emplace(wanted);
  if (is_new) found->second = open(wanted);
  return found->second;
}

Fonts::Found Fonts::open(const std::string& name) {
  const Pattern pattern(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
  if (!pattern.p) return {};
  FcChar8* asked = nullptr;
  std::string family;
  if (FcPatternGetString(pattern.p, FC_FAMILY, 0, &asked) == FcResultMatch) family = text_of(asked);
  FcPatternAddBool(pattern.p, FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.p, FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config_, pattern.p, FcMatchPattern);
  FcDefaultSubstitute(pattern.p);
  FcResult result = FcResultNoMatch;
  const Pattern match(FcFontMatch(config_, pattern.p, &result));
  FcChar8* file = nullptr;
  int index = 0;
  if (!match.p || FcPatternGetString(match.p, FC_FILE, 0, &file) != FcResultMatch ||
      FcPatternGetInteger(match.p, FC_INDEX, 0, &index) != FcResultMatch) {
    return {};
  }
  Found found;
  if (FT_New_Face(library_, reinterpret_cast<const char*>(file), index, &found.face) != 0)
    return {};
  choose_letters(found.face);
  found.replaced = !family.empty() && !has_family(match.p, family);
  return found;
}

}  // namespace burin::csg
