#pragma once
// Parts of a tree, evaluated and made forms; internal to the module.

#include <burin/base/run_context.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/read_result.h>

#include "calls.h"
#include "tree.h"

#include <filesystem>
#include <string>

namespace burin::detail {

/// Whether parts are forms that are shared and drawn round, or meshes of their own.
enum class TreeShapes : std::uint8_t { Shared, Meshes };

/// Evaluates the parts of a tree in a child process and makes a scene of them. `program`: the text
/// that the tree came from; `calls`: what is known of its modules. Parts of which nothing is left
/// are left out. Throws NotEvaluated where OpenSCAD might do better, InputError where the model is
/// at fault.
ReadResult scene_of_tree(const csg::Tree& tree, const TreeCalls& calls, std::string_view program,
                         const std::filesystem::path& path, const OpenscadOptions& options,
                         TreeShapes shapes, RunContext& context);

/// The parts as implicit functions. Throws InputError for what has none.
ReadResult functions_of_tree(const csg::Tree& tree, const TreeCalls& calls,
                             std::string_view program, const std::filesystem::path& path,
                             RunContext& context);

/// All that a tree makes, united. Throws as `scene_of_tree`.
OpenscadMesh whole_of_tree(const csg::Tree& tree, const std::filesystem::path& path,
                           RunContext& context);

}  // namespace burin::detail
