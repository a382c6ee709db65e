#pragma once
/// What is meant by names that no option has: other options, style keys, keys of illustration
/// files, and what is not drawn at all.

#include <burin/options/meant.h>
#include <burin/options/request.h>

#include <string>
#include <vector>

namespace burin {

/// Options as a front end spells them.
std::vector<KnownWord> known_options(const std::vector<RequestOption>& options, Spelling spelling);

/// Style keys, each with how a front end sets it.
std::vector<KnownWord> known_style_keys(Spelling spelling);

/// What people ask for that is no option: where it is instead, or that it is not there.
std::vector<KnownWord> known_elsewhere(Spelling spelling);

/// "; the nearest is ..." of `own`, else of what is elsewhere; empty where nothing is near.
std::string hint_for_option(const std::string& name, std::vector<KnownWord> own, Spelling spelling);

/// The option of a drawing, or one of `others`, by its name. Throws UsageError that says what is
/// meant.
const RequestOption& option_asked(const std::string& name, const std::vector<KnownWord>& others,
                                  Spelling spelling);

}  // namespace burin
