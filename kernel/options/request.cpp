#include <burin/base/error.h>
#include <burin/options/request.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace burin {

std::string spelled(std::string name, Spelling spelling) {
  if (spelling == Spelling::Keywords) return name;
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string called(const std::string& name, Spelling spelling) {
  return (spelling == Spelling::Options ? "option " : "argument ") + spelled(name, spelling);
}

std::vector<std::string> asked_texts(const RequestOption& option, const Request& request) {
  const auto given = request.find(option.option.name);
  if (given != request.end()) return given->second;
  if (option.fallback.empty()) return {};
  return {option.fallback};
}

std::optional<OptionValue> asked_value(const RequestOption& option, const Request& request,
                                       const std::string& spelled) {
  const std::vector<std::string> texts = asked_texts(option, request);
  if (texts.empty()) return std::nullopt;
  auto value = parse_value(option.option, texts.back());
  if (!value) {
    throw UsageError(fmt::format("{} {} takes {}, not '{}'",
                                 spelled.starts_with("--") ? "option" : "argument", spelled,
                                 takes_text(option.option), texts.back()));
  }
  return value;
}

std::string request_to_json(const RequestOption& option) {
  auto json = nlohmann::ordered_json::parse(to_json(option.option));
  json["group"] = option.group;
  json["label"] = option.label;
  json["default"] = option.fallback;
  json["choices"] = option.choices;
  json["many"] = option.many;
  json["letter"] = option.letter == 0 ? std::string() : std::string(1, option.letter);
  json["negated"] = option.negated;
  json["python"] = option.python;
  return json.dump();
}

}  // namespace burin
