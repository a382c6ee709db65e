#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/base/nearest.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/request.h>
#include <burin/converters/values.h>
#include <burin/forms/mesh/mesh_form.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace burin {
namespace {

constexpr double kLarge = 1e12;  // past any sheet, scale or tolerance that means something

/// "crease_angle" as the user knows it.
std::string spelled(std::string name, Spelling spelling) {
  if (spelling == Spelling::Keywords) return name;
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

/// "option --crease-angle", "argument crease_angle".
std::string called(const char* name, Spelling spelling) {
  return (spelling == Spelling::Options ? "option " : "argument ") + spelled(name, spelling);
}

/// Errors have no line: the text is made by a program.
Style style_of_text(const std::string& text) {
  try {
    return parse_style(text, "style");
  } catch (const UsageError& e) {
    const std::string message = e.what();
    const std::size_t place = message.find(": ");
    throw UsageError(place == std::string::npos ? message : message.substr(place + 2));
  }
}

Style named_style(const DrawRequest& r) {
  return r.style_text.empty() ? load_style(r.style) : style_of_text(r.style_text);
}

Style make_style(Style style, const DrawRequest& r, Spelling spelling) {
  if (!r.light.empty()) style.tone.light = direction_option(spelled("light", spelling), r.light);
  for (const std::string& assignment : r.set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
      throw UsageError(fmt::format("option --set takes KEY=VALUE, not '{}'", assignment));
    }
    set_style_key(style, assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  check_style(style);
  return style;
}

bool fits_drawing(const DrawRequest& r) { return equal_but_for_case(r.paper, "fit"); }

SheetOptions make_sheet(const DrawRequest& r, const Paper& paper, Spelling spelling) {
  SheetOptions sheet;
  sheet.fits = fits_drawing(r);
  const Vec2 room = sheet.fits ? Vec2(kLargestSheet) : Vec2(paper.width, paper.height);
  sheet.margin = margin_option(spelled("margin", spelling), r.margin, room).value_or(sheet.margin);
  return sheet;
}

ViewOptions make_view(const DrawRequest& r, Spelling spelling) {
  const auto number = [&](const char* name, const std::string& text, double low, double high,
                          const char* what) {
    return number_option(spelled(name, spelling), text, low, high, what);
  };
  ViewOptions view;
  const NamedView named = named_view(r.view);
  view.direction = named.direction;
  view.up = r.up.empty() ? named.up : direction_option(spelled("up", spelling), r.up);
  if (!fits_drawing(r)) view.paper = Paper::named(r.paper);
  view.perspective = number("perspective", r.perspective, 1, 120, "1 to 120 degrees");
  view.scale = scale_option(spelled("scale", spelling), r.scale, 1 / kLarge, kLarge);
  view.center = point_option(spelled("center", spelling), r.center);
  return view;
}

/// An option about reading. A new one is a row here and a line in make_read_options.
struct ReadRow {
  const char* name;
  std::string ReadRequest::*text;
};
constexpr std::array kReadRows{
    ReadRow{"bounds", &ReadRequest::bounds},
    ReadRow{"mesher", &ReadRequest::mesher},
    ReadRow{"iso", &ReadRequest::iso},
    ReadRow{"inside", &ReadRequest::inside},
    ReadRow{"volume_degree", &ReadRequest::volume_degree},
    ReadRow{"smooth", &ReadRequest::smooth},
    ReadRow{"specks", &ReadRequest::specks},
    ReadRow{"interpolate", &ReadRequest::interpolate},
    ReadRow{"raw", &ReadRequest::raw},
    ReadRow{"raw_skip", &ReadRequest::raw_skip},
    ReadRow{"openscad_timeout", &ReadRequest::openscad_timeout},
    ReadRow{"recompute", &ReadRequest::recompute},
    ReadRow{"freecad_timeout", &ReadRequest::freecad_timeout},
    ReadRow{"heal", &ReadRequest::heal},
};

std::vector<ReadOptions::Given> given_options(const ReadRequest& request, Spelling spelling) {
  std::vector<ReadOptions::Given> given;
  const auto add = [&](const char* name) {
    // The switch that turns it off is an option of its own.
    const bool off = spelling == Spelling::Options && std::string_view(name) == "heal" &&
                     request.heal == "false";
    given.push_back({name, called(off ? "no_heal" : name, spelling)});
  };
  for (const ReadRow& row : kReadRows) {
    if (!(request.*row.text).empty()) add(row.name);
  }
  if (!request.define.empty()) add("define");
  if (!request.object.empty()) add("object");
  return given;
}

/// "true" or "false", also as Python spells them.
bool flag_option(const std::string& option, std::string word) {
  if (word == "True" || word == "False") word.front() += 'a' - 'A';
  return word_option(option, word, {"false", "true"}) == 1;
}

VolumeReadOptions make_volume_options(const ReadRequest& r, Spelling spelling) {
  constexpr double kWidest = 100;  // samples
  constexpr double kLargestSpeck = 0.99;
  VolumeReadOptions out;
  out.level = number_option(spelled("iso", spelling), r.iso, std::numeric_limits<double>::lowest(),
                            std::numeric_limits<double>::max(), "a number");
  if (!r.inside.empty()) {
    out.inside_above = word_option(spelled("inside", spelling), r.inside, {"above", "below"}) == 0;
  }
  if (!r.volume_degree.empty()) {
    out.degree = static_cast<int>(
        whole_option(spelled("volume_degree", spelling), r.volume_degree, 2, 3, "2 or 3"));
  }
  out.smoothing = number_option(spelled("smooth", spelling), r.smooth, 0, kWidest,
                                "a standard deviation of 0 to 100 samples")
                      .value_or(0);
  out.smallest_part = number_option(spelled("specks", spelling), r.specks, 0, kLargestSpeck,
                                    "a share from 0 to 0.99 of the largest component's size")
                          .value_or(out.smallest_part);
  if (!r.interpolate.empty()) {
    out.interpolate = flag_option(spelled("interpolate", spelling), r.interpolate);
  }
  if (!r.raw.empty()) out.raw = parse_raw_layout(r.raw);
  if (!r.raw_skip.empty()) {
    const auto skip = whole_option(spelled("raw_skip", spelling), r.raw_skip, 0,
                                   std::uint64_t{1} << 50, "a number of bytes");
    if (!out.raw)
      throw UsageError(spelled("raw_skip", spelling) + " goes with " + spelled("raw", spelling));
    out.raw->skip = static_cast<std::int64_t>(skip);
  }
  return out;
}

/// What the plan asks for that some drawings or styles have no use for.
void note_unused(const DrawRequest& r, Spelling spelling, const Style& named, DrawPlan& plan) {
  if (!r.light.empty() && plan.style.tone.light != named.tone.light) {
    plan.about_strokes.push_back(called("light", spelling));
  }
  for (const std::string& assignment : r.set) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (key != "hatch.enabled" && (key.starts_with("hatch.") || key.starts_with("tone."))) {
      plan.about_strokes.push_back("style key " + key);
    }
  }
  if (!r.tolerance.empty()) plan.about_exact.push_back(called("tolerance", spelling));
  const auto note = [&](const std::string& text) {
    plan.notes.add(Severity::Warning, "option.unused", 1, text);
  };
  if (plan.illustrate.hidden == HiddenLines::Dashed && plan.style.halo.hidden) {
    note(fmt::format("{} has no effect: style '{}' draws hidden lines in full (halo.hidden)",
                     called("hidden", spelling), plan.style.name));
  }
  if (!r.up.empty()) {
    constexpr double kAlong = 1e-6;  // radians, as Camera has it
    const Vec3 up = glm::normalize(plan.view.up), to = glm::normalize(plan.view.direction);
    if (glm::length(glm::cross(up, to)) <= kAlong) {
      note(called("up", spelling) + " has no effect: it lies along the view");
    }
  }
}

bool has_strokes(const DrawPlan& plan) {
  return plan.style.hatch.enabled ||
         std::any_of(plan.illustrate.looks.begin(), plan.illustrate.looks.end(),
                     [](const PartLook& look) { return look.style && look.style->hatch.enabled; });
}

bool all_facets(const Scene& scene) {
  return std::all_of(scene.parts.begin(), scene.parts.end(), [](const Part& part) {
    return dynamic_cast<const MeshForm*>(part.form.get()) != nullptr;
  });
}

}  // namespace

Style load_style(const std::string& name) {
  const auto builtin = builtin_styles();
  if (std::any_of(builtin.begin(), builtin.end(),
                  [&](const StyleInfo& s) { return s.name == name; })) {
    return builtin_style(name);
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) {
    const bool path = name.find('/') != std::string::npos || name.ends_with(".json");
    if (path) throw MissingFile("there is no such style file; check the path", name);
    return builtin_style(name);
  }
  std::ifstream in(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) throw InputError("the style file cannot be read", name);
  return parse_style(text, name);
}

ReadOptions make_read_options(const ReadRequest& request, Spelling spelling) {
  constexpr double kWeek = 604'800;
  ReadOptions read;
  read.given = given_options(request, spelling);
  read.bounds = box_option(spelled("bounds", spelling), request.bounds);
  if (!request.mesher.empty()) {
    constexpr std::array kMeshers{Mesher::Auto, Mesher::Nets, Mesher::Delaunay};
    read.mesher = kMeshers[word_option(spelled("mesher", spelling), request.mesher,
                                       {"auto", "nets", "delaunay"})];
  }
  check_openscad_defines(request.define);
  read.defines = request.define;
  read.openscad_timeout = number_option(spelled("openscad_timeout", spelling),
                                        request.openscad_timeout, 0.001, kWeek, "seconds over 0")
                              .value_or(read.openscad_timeout);
  read.objects = request.object;
  if (!request.recompute.empty()) {
    read.recompute = flag_option(spelled("recompute", spelling), request.recompute);
  }
  read.freecad_timeout = number_option(spelled("freecad_timeout", spelling),
                                       request.freecad_timeout, 0.001, kWeek, "seconds over 0")
                             .value_or(read.freecad_timeout);
  read.volume = make_volume_options(request, spelling);
  if (!request.mesher.empty()) read.volume.mesher = read.mesher;
  if (!request.heal.empty()) {
    read.heal = flag_option(spelled("heal", spelling), request.heal);
  }
  return read;
}

void set_read_option(ReadRequest& request, const std::string& name, const std::string& value,
                     const std::vector<std::string>& others) {
  std::vector<std::string> names = {"define", "object"};
  if (name == "define" || name == "object") {
    (name == "define" ? request.define : request.object).push_back(value);
    return;
  }
  for (const ReadRow& row : kReadRows) {
    if (name == row.name) {
      request.*row.text = value;
      return;
    }
    names.emplace_back(row.name);
  }
  names.insert(names.end(), others.begin(), others.end());
  throw UsageError(
      fmt::format("unknown argument '{}'; the nearest is '{}'", name, nearest(name, names)));
}

Drawing draw(const Scene& scene, const Camera& camera, const DrawPlan& plan, RunContext& context) {
  Drawing drawing = illustrate(scene, camera, plan.style, plan.illustrate, context);
  drawing.diagnostics.append(plan.notes);
  const auto unused = [&](const std::vector<std::string>& choices, const std::string& why) {
    for (const std::string& choice : choices) {
      drawing.diagnostics.add(Severity::Warning, "option.unused", 1,
                              fmt::format("{} has no effect: {}", choice, why));
    }
  };
  if (!has_strokes(plan)) {
    unused(plan.about_strokes,
           fmt::format("style '{}' draws no strokes (hatch.enabled=true does)", plan.style.name));
  }
  if (all_facets(scene)) unused(plan.about_exact, "all parts are meshes, drawn as they are");
  return drawing;
}

Camera make_camera(const Scene& scene, const DrawPlan& plan) {
  const auto extent = [&](const Mat3& axes) { return scene.bounds(axes); };
  return Camera::fit(extent, settle(extent, plan.view, plan.sheet));
}

DrawPlan make_plan(const DrawRequest& request, Spelling spelling) {
  DrawPlan plan;
  const Style named = named_style(request);
  plan.style = make_style(named, request, spelling);
  plan.view = make_view(request, spelling);
  plan.sheet = make_sheet(request, plan.view.paper, spelling);
  plan.illustrate.tolerance = number_option(spelled("tolerance", spelling), request.tolerance,
                                            1 / kLarge, kLarge, "a number of mm over 0");
  plan.read = make_read_options(request.read, spelling);
  plan.illustrate.seed =
      whole_option(spelled("seed", spelling), request.seed, 0,
                   std::numeric_limits<std::uint64_t>::max(), "a whole number from 0");
  plan.illustrate.hidden =
      word_option(spelled("hidden", spelling), request.hidden, {"none", "dashed"}) == 0
          ? HiddenLines::None
          : HiddenLines::Dashed;
  if (!request.verify.empty()) {
    plan.illustrate.verify = flag_option(spelled("verify", spelling), request.verify);
  }
  note_unused(request, spelling, named, plan);
  if (!request.threads.empty()) {
    plan.threads = static_cast<int>(
        whole_option(spelled("threads", spelling), request.threads, 1, 4096, "1 to 4096"));
  }
  return plan;
}

}  // namespace burin
