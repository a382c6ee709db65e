#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/converters/illustration.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/messages.h>
#include <burin/surface/placed_form.h>

#include <fmt/format.h>

#include <map>
#include <tuple>
#include <vector>

namespace burin {
namespace {

/// What an input says before it is placed and named.
using Key = std::tuple<std::string, std::string, Request>;

/// What was read, a placer a part.
struct Known {
  Scene scene;
  std::vector<Placer> placers;
};

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
    scene.parts.front().definition.clear();  // its name is this now
    return;
  }
  for (Part& part : scene.parts) part.assembly.insert(part.assembly.begin(), name);
}

}  // namespace

Scene read_scene(const IllustrationFile& illustration, RunContext& context) {
  Scene all;
  std::map<Key, Known> known;
  for (const IllustrationInput& input : illustration.inputs) {
    const Key key{input.file, input.function, input.read};
    auto found = known.find(key);
    if (found == known.end()) {
      found = known.emplace(key, Known{read_one(input, context), {}}).first;
      for (const Part& part : found->second.scene.parts) {
        found->second.placers.emplace_back(part.form);
      }
      all.diagnostics.append(found->second.scene.diagnostics);
    }
    Scene one = found->second.scene;
    name_parts(one, input.name);
    for (std::size_t i = 0; i < one.parts.size(); ++i) {
      one.parts[i].form = found->second.placers[i].at(input.place);
      for (Thread& thread : one.parts[i].threads) thread = placed(thread, input.place);
      one.parts[i].pmi.move(input.place);
      all.parts.push_back(std::move(one.parts[i]));
    }
  }
  return all;
}

}  // namespace burin
