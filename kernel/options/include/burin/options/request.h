#pragma once
/// Options as a user gives them: by name, as text. A row each, from which the command line, Python
/// and their manuals are made.

#include <burin/options/meant.h>
#include <burin/options/option.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct RequestOption {
  Option option;
  /// The heading under which help lists it.
  std::string group;
  /// What help writes after the name: "NAME|X,Y,Z"; switches have none.
  std::string label = {};
  /// The text that holds where nothing is given; empty: nothing does.
  std::string fallback = {};
  /// Names that free text may be beside what else it takes, for lists to choose from.
  std::vector<std::string> choices = {};
  /// May be given several times, a value each time.
  bool many = false;
  /// A short name of one letter on the command line; 0: none.
  char letter = 0;
  /// Free text: what programs in Python may give, as a type; empty: text.
  std::string python = {};
  /// Switches: what their "no-" form means; empty: there is none.
  std::string negated = {};
  /// What people look for who know it by another name: "bom", "balloons".
  std::vector<std::string> also = {};
};

/// One option as it was given.
struct Asked {
  /// One, or those of an option that may be given several times.
  const std::vector<std::string>& texts;
  /// That of the last text.
  OptionValue value;
  /// As errors call it: "--volume-degree" or "volume_degree".
  std::string spelled;

  /// The last one.
  const std::string& text() const { return texts.back(); }
};

/// What an option about T does to it.
template <class T>
struct RequestRow {
  RequestOption about;
  std::function<void(T&, const Asked&)> set;

  const std::string& name() const { return about.option.name; }
};

/// Values by the names of their options, with underscores; no empty lists.
using Request = std::map<std::string, std::vector<std::string>>;

/// What was given for an option; empty where nothing was.
const std::vector<std::string>& given_texts(const Request& request, const std::string& name);

/// How errors name an option: "--crease-angle" or "crease_angle".
enum class Spelling { Options, Keywords };

std::string spelled(std::string name, Spelling spelling);
/// "option --crease-angle", "argument crease_angle".
std::string called(const std::string& name, Spelling spelling);

/// The message as a front end spells it. Library code marks an option as `bounds` or
/// `iso 0.5`, in grave accents: here "--bounds", "--iso 0.5", or "bounds", "iso=0.5". Other words
/// in grave accents stay as they are.
std::string spelled_message(std::string_view message, const std::vector<RequestOption>& options,
                            Spelling spelling);

/// Throws UsageError: "option --width takes 1 to 10, not '11'"; a keyword is an argument.
[[noreturn]] void refuse_value(const std::string& spelled, std::string_view takes,
                               std::string_view text);

/// What was given for an option, else what holds without; nothing where that is nothing. Throws
/// UsageError that names the option and says what it takes.
std::optional<OptionValue> asked_value(const RequestOption& option, const Request& request,
                                       const std::string& spelled);

/// The texts that hold for an option.
std::vector<std::string> asked_texts(const RequestOption& option, const Request& request);

/// Sets what the request, and else the rows, say, in the order of the rows. Names that no row has
/// are not looked at. Throws UsageError, and what the rows throw.
template <class T>
void apply(const std::vector<RequestRow<T>>& rows, const Request& request, Spelling spelling,
           T& to) {
  for (const RequestRow<T>& row : rows) {
    const std::string name = spelled(row.name(), spelling);
    const std::vector<std::string> texts = asked_texts(row.about, request);
    const auto value = asked_value(row.about, request, name);
    if (value) row.set(to, {texts, *value, name});
  }
}

/// What rows say of their options.
template <class T>
std::vector<RequestOption> described(const std::vector<RequestRow<T>>& rows) {
  std::vector<RequestOption> options;
  for (const RequestRow<T>& row : rows) options.push_back(row.about);
  return options;
}

/// The option of that name. Throws UsageError that says which of these or of `others` is meant.
const RequestOption& find_option(const std::vector<RequestOption>& options, const std::string& name,
                                 const std::vector<KnownWord>& others = {});

/// As `to_json` of an option, with "group", "label", "default", "choices", "many", "letter",
/// "negated" and "python".
std::string request_to_json(const RequestOption& option);

}  // namespace burin
