#include <burin/base/error.h>
#include <burin/converters/request.h>
#include <burin/converters/unknown.h>

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

struct Elsewhere {
  std::vector<std::string> names;
  const char* say;
};

const std::vector<Elsewhere>& elsewhere() {
  static const std::vector<Elsewhere> rows = {
      {{"title", "caption", "heading", "drawing name", "name"},
       "a title is a key of illustration files, \"title\": \"...\" (burin illustrate writes one)"},
      {{"dims", "dimensioning", "measures", "sizes", "annotate dimensions", "pmi", "gdt",
        "tolerancing"},
       "`dimensions` overall writes width, depth and height; others are not drawn"},
      {{"frame", "drawing frame", "sheet frame", "template sheet", "border lines", "grid",
        "watermark", "logo"},
       "`title_block` takes a sheet's template, FILE.svg, with its frame"},
      {{"translate", "move", "place", "position", "transform", "matrix", "mirror", "scale part"},
       "a part is placed by a key of illustration files, \"place\" (burin illustrate writes one)"},
      {{"units", "unit", "inch", "inches", "mm", "metric", "imperial"},
       "models are read in mm, or in the unit that their file states; `scale` takes paper mm for a "
       "model mm"},
      {{"layers", "layer"},
       "each kind of line is a layer of its own; style keys feature.* leave kinds out"},
      {{"frames", "fps", "animate", "animation", "turntable", "gif", "video", "spin", "movie"},
       "Burin draws still pictures; draw one for each `view`"},
      {{"color", "colour", "colors", "colours", "palette", "color palette", "colour palette",
        "color scheme", "colour scheme", "paint"},
       "`style flat` draws parts in their colours; style key fill.color is one for all of them, "
       "line.color that of lines, and `highlight` colours single parts"},
      {{"shadows", "shadow", "cast shadows", "drop shadow", "ground shadow", "shading shadow"},
       "style key shadow.cast draws shadows of parts on parts, shadow.ground those on the ground; "
       "`style shaded` has both"},
      {{"antialias", "aa", "samples", "supersample", "msaa"},
       "lines are exact; the style key png.dpi sets the pixels of PNG files"},
      {{"texture", "textures", "uv", "material", "materials", "materials file", "mtl"},
       "lines take no materials; style keys hatch.image and hatch.motif draw pictures in strokes"},
      {{"input", "i", "in", "infile", "model", "file", "files", "mesh"},
       "models are named without an option"},
      {{"recursive", "r", "all", "folder", "directory", "batch"},
       "many models are drawn by burin batch"},
      {{"config file", "conf", "settings", "project", "scene file", "preset file", "json"},
       "choices are kept in an illustration file (burin illustrate) or a style file"},
      {{"force", "f", "overwrite", "y", "yes", "clobber", "replace"},
       "files are replaced without asking"},
      {{"gui", "window", "viewer", "open", "interactive", "preview", "show window"},
       "Burin has no window; burin watch draws again whenever a file changes"},
  };
  return rows;
}

std::string set_key(const StyleKey& key, Spelling spelling) {
  return spelling == Spelling::Options
             ? fmt::format("that is the style key {0}: --set {0}=VALUE", key.name)
             : fmt::format("that is the style key {0}: set={{\"{0}\": ...}}", key.name);
}

}  // namespace

std::vector<KnownWord> known_options(const std::vector<RequestOption>& options, Spelling spelling) {
  std::vector<KnownWord> known;
  for (const RequestOption& option : options) {
    const std::string name = spelled(option.option.name, spelling);
    known.push_back({name, option.also});
    if (spelling == Spelling::Options) known.back().say = "the nearest is " + name;
  }
  return known;
}

std::vector<KnownWord> known_style_keys(Spelling spelling) {
  std::vector<KnownWord> known;
  for (const StyleKey& key : style_keys(builtin_style("technical"))) {
    known.push_back({key.name, key.also, set_key(key, spelling)});
    known.back().also.push_back(key.name.substr(key.name.find('.') + 1));
  }
  return known;
}

std::vector<KnownWord> known_elsewhere(Spelling spelling) {
  std::vector<KnownWord> known;
  for (const Elsewhere& row : elsewhere()) {
    const std::vector<std::string> also(row.names.begin() + 1, row.names.end());
    known.push_back({row.names.front(), also, spelled_message(row.say, all_options(), spelling)});
  }
  return known;
}

std::string hint_for_option(const std::string& name, std::vector<KnownWord> own,
                            Spelling spelling) {
  for (const auto& more : {known_elsewhere(spelling), known_style_keys(spelling)}) {
    own.insert(own.end(), more.begin(), more.end());
  }
  return hint(name, own);
}

const RequestOption& option_asked(const std::string& name, const std::vector<KnownWord>& others,
                                  Spelling spelling) {
  for (const RequestOption& option : all_options()) {
    if (option.option.name == name) return option;
  }
  std::vector<KnownWord> own = known_options(all_options(), spelling);
  own.insert(own.end(), others.begin(), others.end());
  throw UsageError(
      fmt::format("unknown argument '{}'{}", name, hint_for_option(name, own, spelling)));
}

}  // namespace burin
