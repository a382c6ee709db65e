#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/converters/illustration.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/messages.h>
#include <burin/surface/placed_form.h>

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace burin {
namespace {

/// What an input says before it is placed and named.
using Key = std::tuple<std::string, std::string, Request>;

Scene read_one(const IllustrationInput& input, RunContext& context) {
  const ReadOptions options = make_read_options(input.read, Spelling::Keywords);
  if (input.function.empty()) {
    try {
      check_inputs({input.file});
    } catch (const InputError& e) {
      throw InputError(fmt::format("'{}': {}", input.file, e.what()), input.source, input.line);
    }
    return read_scene({input.file}, options, context);
  }
  try {
    return read_implicit_text(input.function, input.source, {options.bounds, {options.mesher}},
                              context);
  } catch (const InputError& e) {
    // Its lines are those of the formula, which is one in the file.
    throw InputError(e.what(), input.source, input.line);
  }
}

/// One part takes the name; several are below it in the assembly.
void name_parts(Scene& scene, const std::string& name) {
  if (name.empty()) return;
  if (scene.parts.size() == 1) {
    scene.parts.front().name = name;
    return;
  }
  for (Part& part : scene.parts) part.assembly.insert(part.assembly.begin(), name);
}

}  // namespace

Scene read_scene(const Illustration& illustration, RunContext& context) {
  Scene all;
  std::map<Key, Scene> known;
  for (const IllustrationInput& input : illustration.inputs) {
    const Key key{input.file, input.function, input.read};
    auto found = known.find(key);
    if (found == known.end()) {
      found = known.emplace(key, read_one(input, context)).first;
      all.diagnostics.append(found->second.diagnostics);
    }
    Scene one = found->second;
    name_parts(one, input.name);
    for (Part& part : one.parts) {
      part.form = placed(part.form, input.place);
      all.parts.push_back(std::move(part));
    }
  }
  return all;
}

}  // namespace burin
