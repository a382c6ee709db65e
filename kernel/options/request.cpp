#include <burin/base/error.h>
#include <burin/options/meant.h>
#include <burin/options/request.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace burin {

std::string spelled(std::string name, Spelling spelling) {
  if (spelling == Spelling::Keywords) return name;
  // Keywords of Python have one at their end: "as_" is --as.
  if (name.ends_with('_')) name.pop_back();
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string called(const std::string& name, Spelling spelling) {
  return (spelling == Spelling::Options ? "option " : "argument ") + spelled(name, spelling);
}

std::string spelled_message(std::string_view message, const std::vector<RequestOption>& options,
                            Spelling spelling) {
  constexpr char kMark = '`';
  std::string out;
  while (true) {
    const std::size_t from = message.find(kMark);
    const std::size_t to = from == message.npos ? from : message.find(kMark, from + 1);
    if (to == message.npos) return out.append(message);
    const std::string_view choice = message.substr(from + 1, to - from - 1);
    const std::size_t blank = choice.find(' ');
    const std::string_view name = choice.substr(0, blank);
    const bool known = std::any_of(options.begin(), options.end(),
                                   [&](const RequestOption& o) { return o.option.name == name; });
    if (!known) {
      // The second accent may be the first of another pair.
      out += message.substr(0, to);
      message.remove_prefix(to);
      continue;
    }
    out.append(message.substr(0, from)).append(spelled(std::string(name), spelling));
    if (blank != choice.npos) {
      out += spelling == Spelling::Options ? ' ' : '=';
      out += choice.substr(blank + 1);
    }
    message.remove_prefix(to + 1);
  }
}

const std::vector<std::string>& given_texts(const Request& request, const std::string& name) {
  static const std::vector<std::string> none;
  const auto given = request.find(name);
  return given == request.end() ? none : given->second;
}

void refuse_value(const std::string& spelled, std::string_view takes, std::string_view text) {
  throw UsageError(fmt::format("{} {} takes {}, not '{}'",
                               spelled.starts_with("--") ? "option" : "argument", spelled, takes,
                               text));
}

const RequestOption& find_option(const std::vector<RequestOption>& options, const std::string& name,
                                 const std::vector<KnownWord>& others) {
  std::vector<KnownWord> known = others;
  for (const RequestOption& option : options) {
    if (option.option.name == name) return option;
    known.push_back({option.option.name, option.also});
  }
  throw UsageError(fmt::format("unknown argument '{}'{}", name, hint(name, known)));
}

std::vector<std::string> asked_texts(const RequestOption& option, const Request& request) {
  const std::vector<std::string>& given = given_texts(request, option.option.name);
  if (!given.empty()) return given;
  if (option.fallback.empty()) return {};
  return {option.fallback};
}

std::optional<OptionValue> asked_value(const RequestOption& option, const Request& request,
                                       const std::string& spelled) {
  const std::vector<std::string> texts = asked_texts(option, request);
  if (texts.empty()) return std::nullopt;
  auto value = parse_value(option.option, texts.back());
  if (!value) refuse_value(spelled, takes_text(option.option), texts.back());
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
