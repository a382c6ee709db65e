#pragma once
// What commands that draw read.

#include <burin/base/input_files.h>
#include <burin/converters/illustration.h>

#include "arguments.h"

#include <optional>
#include <string>
#include <vector>

namespace burin::cli {

/// The illustration that is to be drawn; nothing where models are.
std::optional<IllustrationFile> illustration_of(const std::vector<std::string>& inputs);

/// All files that a run reads. `read`: what was opened for the plan, such as style files and
/// pictures.
std::vector<std::string> sources_of(const DrawArguments& a,
                                    const std::optional<IllustrationFile>& illustration,
                                    const InputFiles& read);

/// What the words ask, over what the illustration says. Throws UsageError, InputError.
DrawPlan plan_of(const DrawArguments& arguments,
                 const std::optional<IllustrationFile>& illustration);
/// Makes the plan anew where the files that were read say something of the drawing.
void follow_files(const Scene& scene, const DrawArguments& arguments, DrawPlan& plan);

}  // namespace burin::cli
