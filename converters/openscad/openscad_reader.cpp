#include <burin/base/error.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/converters/openscad_reader.h>
#include <burin/repair/repair.h>

#include "calls.h"
#include "child.h"
#include "foreign_file.h"
#include "parts.h"
#include "program.h"
#include "source.h"
#include "text.h"
#include "tree_scene.h"
#include "triangles_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>

namespace burin {
namespace {

using Path = std::filesystem::path;

/// Errors in what OpenSCAD made are about the user's file.
template <typename Read>
auto in_the_name_of(const Path& path, const Read& read) {
  try {
    return read();
  } catch (const InputError& e) {
    throw InputError(std::string("what OpenSCAD made of it: ") + e.what(), path.string());
  }
}

/// The file in memory has no suffix that would tell its kind: what is neither text nor a whole
/// binary STL is told here, as it came.
void check_mesh(const detail::MemoryFile& mesh, const Path& path) {
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  std::array<char, kHeader + sizeof(std::uint32_t)> head{};
  std::ifstream(mesh.path(), std::ios::binary).read(head.data(), head.size());
  if (std::ranges::find(head, '\0') == head.end()) return;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, head.data() + kHeader, sizeof triangles);
  if (mesh.size() != head.size() + kTriangle * triangles) {
    throw InputError(fmt::format("what OpenSCAD made of it: {} bytes that are no whole STL; look "
                                 "at what openscad -o a.stl makes of the file",
                                 mesh.size()),
                     path.string());
  }
  if (triangles == 0) {
    throw InputError(
        "what OpenSCAD made of it: an STL without triangles; sizes and places must lie within the "
        "range of single precision (1e-38 to 1e38)",
        path.string());
  }
}

std::string text_of(const Path& path, const RunContext& context) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) == 0 && !error) {
    throw InputError("is empty: there is no program in it", path.string());
  }
  const Source source(path, context);
  if (const char* what = foreign_file(source.bytes())) source.fail(what);
  return std::string(source.bytes());
}

/// A text that is a tree already needs no program.
std::optional<csg::Tree> tree_in(const Path& path, const OpenscadOptions& options,
                                 RunContext& context) {
  if (!lowered(path.filename().string()).ends_with(".csg") || !options.defines.empty()) return {};
  try {
    csg::Tree tree = csg::parse(text_of(path, context), path.string(), context);
    if (csg::is_canonical(tree)) return tree;
    return {};
  } catch (const InputError&) {
    return {};  // another program, or broken: OpenSCAD says what is wrong with it
  }
}

/// What the user wrote, and the tree that it becomes.
struct Program {
  std::string text;
  csg::Tree tree;
  detail::TreeCalls calls;
  detail::ProgramOutput said;
};

/// Runs a program whose calls of modules are marked; false where that gives no tree: the program as
/// it stands says why.
bool run_marked(const Path& path, const OpenscadOptions& options,
                detail::OpenscadPrograms& programs, Program& out, RunContext& context) {
  std::optional<detail::MarkedProgram> marked = detail::mark_calls(out.text);
  if (!marked) return false;
  const auto start = std::chrono::steady_clock::now();
  try {
    const detail::MemoryFile tree;
    out.said = detail::run_openscad(path, options, programs, detail::Makes::Tree, tree, context,
                                    &marked->text);
    out.tree = csg::parse(detail::contents(tree), path.string(), context);
  } catch (const InputError&) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() >= options.timeout) throw;
    return false;
  }
  out.calls = detail::take_calls(out.tree, std::move(marked->calls));
  return true;
}

Program run_program(const Path& path, const OpenscadOptions& options,
                    detail::OpenscadPrograms& programs, RunContext& context) {
  Program out;
  if (auto tree = tree_in(path, options, context)) {
    out.tree = std::move(*tree);
    return out;
  }
  out.text = text_of(path, context);
  if (run_marked(path, options, programs, out, context)) return out;
  const detail::MemoryFile tree;
  out.said = detail::run_openscad(path, options, programs, detail::Makes::Tree, tree, context);
  try {
    out.tree = csg::parse(detail::contents(tree), path.string(), context);
  } catch (const InputError& e) {
    throw csg::NotEvaluated(e.what());
  }
  return out;
}

/// Throws NotEvaluated for a tree that is none that Burin knows.
Program evaluated(const Path& path, const OpenscadOptions& options,
                  detail::OpenscadPrograms& programs, RunContext& context) {
  Program out = run_program(path, options, programs, context);
  if (const std::string what = csg::not_known_in(out.tree); !what.empty()) {
    throw csg::NotEvaluated(what + " is OpenSCAD's alone");
  }
  return out;
}

/// By OpenSCAD alone: one part.
MeshFile rendered(const Path& path, const OpenscadOptions& options,
                  detail::OpenscadPrograms& programs, RunContext& context) {
  const detail::MemoryFile mesh;
  Diagnostics diagnostics =
      detail::run_openscad(path, options, programs, detail::Makes::Mesh, mesh, context).diagnostics;
  check_mesh(mesh, path);
  MeshFile file = in_the_name_of(path, [&] { return read_mesh_file(mesh.path(), context); });
  for (PolygonSoup& soup : file.objects) soup.name.clear();
  diagnostics.append(file.diagnostics);
  file.diagnostics = std::move(diagnostics);
  return file;
}

/// Nothing came of a program of which the evaluator left something out: that is why.
void throw_if_left_out(const Diagnostics& said, const Path& path) {
  const auto warns = [](const Diagnostic& d) { return d.severity == Severity::Warning; };
  const auto first = std::ranges::find_if(said.entries(), warns);
  if (first == said.entries().end()) return;
  // The file is named once.
  const std::string named = path.string() + ": ", &what = first->message;
  throw InputError("nothing of it is left to draw: " +
                       (what.starts_with(named) ? what.substr(named.size()) : what),
                   path.string());
}

bool nothing(const ReadResult& read) { return read.scene.parts.empty(); }
bool nothing(const OpenscadMesh& made) { return made.mesh.triangles.empty(); }

Diagnostics& said_of(ReadResult& read) { return read.scene.diagnostics; }
Diagnostics& said_of(OpenscadMesh& made) { return made.diagnostics; }

/// What `make` makes of a program, with what was said before in its diagnostics.
template <typename Make>
auto made_of(const Program& program, const Path& path, const Make& make) {
  auto made = make(program);
  if (nothing(made)) {
    if (program.said.error.empty()) throw_if_left_out(said_of(made), path);
    const bool flat = detail::is_flat(program.tree);
    program.said.fail(flat ? detail::kTwoDimensional : detail::kEmpty, path.string());
  }
  Diagnostics all = program.said.diagnostics;
  all.append(said_of(made));
  said_of(made) = std::move(all);
  return made;
}

/// The same by Burin; nothing where it is OpenSCAD's turn, of which `why` is told.
template <typename Make>
auto made_here(const Path& path, const OpenscadOptions& options, detail::OpenscadPrograms& programs,
               Diagnostics& why, RunContext& context, const Make& make)
    -> std::optional<decltype(make(std::declval<const Program&>()))> {
  if (options.csg == CsgBy::Openscad) return std::nullopt;
  try {
    return made_of(evaluated(path, options, programs, context), path, make);
  } catch (const csg::NotEvaluated& e) {
    if (options.csg == CsgBy::Burin) throw InputError(e.what(), path.string());
    why.add(Severity::Warning, "openscad.by_openscad", 1,
            fmt::format("{}: OpenSCAD makes the mesh, as one part without names and colours: {}",
                        path.string(), e.what()));
    return std::nullopt;
  }
}

/// The parts, by Burin.
std::optional<ReadResult> parts_here(const Path& path, const OpenscadOptions& options,
                                     detail::OpenscadPrograms& programs, detail::TreeShapes shapes,
                                     Diagnostics& why, RunContext& context) {
  return made_here(path, options, programs, why, context, [&](const Program& program) {
    return detail::scene_of_tree(program.tree, program.calls, program.text, path, options, shapes,
                                 context);
  });
}

ReadResult functions_in(const Path& path, const OpenscadOptions& options,
                        detail::OpenscadPrograms& programs, RunContext& context) {
  try {
    return made_of(evaluated(path, options, programs, context), path, [&](const Program& program) {
      return detail::functions_of_tree(program.tree, program.calls, program.text, path, context);
    });
  } catch (const csg::NotEvaluated& e) {
    throw InputError(e.what(), path.string());
  }
}

}  // namespace

bool is_openscad_suffix(const Path& path) {
  // Not by extension(), which is empty where nothing stands before the dot.
  const std::string name = lowered(path.filename().string());
  return name.ends_with(".scad") || name.ends_with(".csg");
}

ReadResult read_openscad(const Path& path, const OpenscadOptions& options, RunContext& context) {
  Diagnostics why;
  detail::OpenscadPrograms programs(options.timeout);
  if (options.implicit) return functions_in(path, options, programs, context);
  if (auto made = parts_here(path, options, programs, detail::TreeShapes::Shared, why, context)) {
    return std::move(*made);
  }
  Scene scene = repair_parts(rendered(path, options, programs, context), path, context,
                             options.round ? Facets::Recognised : Facets::Kept);
  why.append(scene.diagnostics);
  scene.diagnostics = std::move(why);
  return {std::move(scene)};
}

OpenscadMesh openscad_mesh(const Path& path, const OpenscadOptions& options, RunContext& context) {
  OpenscadOptions exported = options;
  exported.preview = false;
  detail::OpenscadPrograms programs(options.timeout);
  Diagnostics why;
  auto made = made_here(path, exported, programs, why, context, [&](const Program& program) {
    return detail::whole_of_tree(program.tree, path, context);
  });
  if (made) return std::move(*made);
  MeshFile file = rendered(path, exported, programs, context);
  OpenscadMesh out{{}, std::move(why)};
  out.diagnostics.append(file.diagnostics);
  out.mesh = repair(std::move(file.objects.front()), {}, out.diagnostics, context);
  return out;
}

FileInfo inspect_openscad(const Path& path, const OpenscadOptions& options, RunContext& context) {
  FileInfo info;
  info.file = path.string();
  info.format = "OpenSCAD";
  detail::OpenscadPrograms programs(options.timeout);
  if (options.implicit) {
    const Scene functions = functions_in(path, options, programs, context).scene;
    info.diagnostics.append(functions.diagnostics);
    for (const Part& part : functions.parts) {
      info.parts.push_back(measure_realised_part(part, info.diagnostics, context));
    }
    return info;
  }
  auto made =
      parts_here(path, options, programs, detail::TreeShapes::Meshes, info.diagnostics, context);
  if (!made) made = {repair_parts(rendered(path, options, programs, context), path, context)};
  info.diagnostics.append(made->scene.diagnostics);
  for (const Part& part : made->scene.parts) {
    info.parts.push_back(measure_mesh_part(part, context));
    info.parts.back().color = part.color;
  }
  report_self_intersections(info);
  return info;
}

}  // namespace burin
