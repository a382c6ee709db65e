#include "table_check.h"

#include <array>
#include <cmath>
#include <cstring>

namespace burin::plugin {
namespace {

constexpr std::array<std::string_view, 8> kKnown{
    BURIN_DIRECTION_1, BURIN_LAW_1,    BURIN_STROKE_KIND_1, BURIN_FORM_1,
    BURIN_READER_1,    BURIN_WRITER_1, BURIN_WRITER_2,      BURIN_SYMBOL_1};
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53

bool is_text(const char* text) {
  return text != nullptr && ::strnlen(text, kLongestText + 1) <= kLongestText;
}

bool is_word(const char* text, char joint) {
  if (!is_text(text) || !(text[0] >= 'a' && text[0] <= 'z')) return false;
  for (const char* c = text; *c != '\0'; ++c) {
    const bool plain = (*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9');
    if (!plain && *c != joint) return false;
  }
  return true;
}

/// A sentence for people: no line breaks, no other control characters.
bool is_sentence(const char* text) {
  if (!is_text(text) || text[0] == '\0') return false;
  for (const char* c = text; *c != '\0'; ++c) {
    if (static_cast<unsigned char>(*c) < ' ') return false;
  }
  return true;
}

std::string words_fault(const burin_option& o) {
  if (o.words == nullptr || o.words[0] == nullptr) return "has no words";
  std::size_t count = 0;
  for (; o.words[count] != nullptr; ++count) {
    if (count == kMostWords) return "has more than 64 words";
    if (!is_sentence(o.words[count]) || std::strpbrk(o.words[count], ", ") != nullptr) {
      return "has a word that is empty or has a blank or a comma in it";
    }
  }
  const double at = o.fallback.number;
  if (!(at >= 0 && at < static_cast<double>(count)) || at != std::floor(at)) {
    return "falls back to a word that it does not have";
  }
  return {};
}

std::string number_fault(const burin_option& o) {
  if (!std::isfinite(o.low) || !std::isfinite(o.high) || !(o.low <= o.high)) {
    return "has no range: low is not below high, or one is no number";
  }
  if (!(o.fallback.number >= o.low && o.fallback.number <= o.high)) {
    return "falls back to a number outside its range";
  }
  if (o.kind != BURIN_WHOLE) return {};
  for (const double n : {o.low, o.high, o.fallback.number}) {
    if (n != std::floor(n) || n < 0 || n > kLargestWhole) {
      return "is to be whole and has a number that is not, or below 0";
    }
  }
  return {};
}

std::string value_fault(const burin_option& o) {
  switch (o.kind) {
    case BURIN_NUMBER:
    case BURIN_WHOLE:
      return number_fault(o);
    case BURIN_FLAG:
      return o.fallback.number == 0 || o.fallback.number == 1 ? ""
                                                              : "falls back to neither 0 nor 1";
    case BURIN_WORD:
      return words_fault(o);
    case BURIN_VECTOR: {
      const double* v = o.fallback.vector;
      const double size = std::hypot(v[0], v[1], v[2]);
      return std::isfinite(size) && size > 0 ? "" : "falls back to no direction";
    }
    case BURIN_TEXT:
      return is_text(o.fallback.text) ? "" : "falls back to no text";
    default:
      return "is of a kind that there is not";
  }
}

std::string option_fault(const burin_option& o) {
  if (!is_option_name(o.name)) return "has a name that is not made of a-z, 0-9 and _";
  const std::string named = std::string("'") + o.name + "' ";
  if (!is_sentence(o.meaning)) return named + "has no meaning text";
  if (o.unit != nullptr && !is_text(o.unit)) return named + "has a unit that is no text";
  const std::string fault = value_fault(o);
  return fault.empty() ? fault : named + fault;
}

/// ".tiny .tny", or "tiny" where `dotted` is false.
bool are_suffixes(const char* text, bool dotted) {
  if (!is_text(text) || text[0] == '\0') return false;
  std::string_view rest = text;
  while (!rest.empty()) {
    std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(word.size() < rest.size() ? word.size() + 1 : rest.size());
    if (dotted && !word.starts_with('.')) return false;
    if (dotted) word.remove_prefix(1);
    if (word.empty() || word.size() > 16) return false;
    for (const char c : word) {
      if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))) return false;
    }
    if (!dotted) return rest.empty();
  }
  return true;
}

template <class T>
const T& functions_of(const burin_factory& f) {
  return *static_cast<const T*>(f.functions);
}

std::string functions_fault(const burin_factory& f) {
  const std::string_view id = f.id;
  const char* const lacking = "lacks a function";
  if (id == BURIN_DIRECTION_1) {
    const auto& d = functions_of<burin_direction_1>(f);
    return d.make != nullptr && d.directions != nullptr ? "" : lacking;
  }
  if (id == BURIN_LAW_1) {
    const auto& l = functions_of<burin_law_1>(f);
    return l.make != nullptr && l.reflectances != nullptr ? "" : lacking;
  }
  if (id == BURIN_STROKE_KIND_1) {
    const auto& k = functions_of<burin_stroke_kind_1>(f);
    if (k.most < 2 || k.most > 1024) return "has marks of fewer than 2 or more than 1024 points";
    return k.make != nullptr && k.marks != nullptr ? "" : lacking;
  }
  if (id == BURIN_FORM_1) {
    const auto& s = functions_of<burin_form_1>(f);
    const bool function = s.values != nullptr && s.bounds != nullptr;
    const bool patch = s.points != nullptr && s.domain != nullptr;
    if (s.values != nullptr && s.points != nullptr) return "is both a function and S(u,v)";
    return s.make != nullptr && (function || patch) ? "" : lacking;
  }
  if (id == BURIN_READER_1) {
    const auto& r = functions_of<burin_reader_1>(f);
    if (!are_suffixes(r.suffixes, true)) return "has no suffixes such as '.tiny .tny'";
    return r.read != nullptr ? "" : lacking;
  }
  const auto writer_fault = [&](const auto& w) -> std::string {
    if (!are_suffixes(w.suffix, false)) return "has no suffix such as 'txt'";
    return w.write != nullptr ? "" : lacking;
  };
  if (id == BURIN_WRITER_1) return writer_fault(functions_of<burin_writer_1>(f));
  if (id == BURIN_WRITER_2) return writer_fault(functions_of<burin_writer_2>(f));
  if (id == BURIN_SYMBOL_1) {
    return functions_of<burin_symbol_1>(f).draw != nullptr ? "" : lacking;
  }
  return {};
}

std::string factory_fault(const burin_factory& f) {
  if (!is_text(f.id) || f.id[0] == '\0') return "a factory has no id of an interface";
  if (!is_name(f.name)) return "a factory has a name that is not made of a-z, 0-9 and -";
  if (!is_known(f.id)) return {};
  const std::string named = std::string(f.id) + " '" + f.name + "' ";
  if (!is_sentence(f.meaning)) return named + "has no meaning text";
  if (f.functions == nullptr) return named + "has no functions";
  if (f.option_count > kMostOptions) return named + "has more than 64 options";
  if (f.option_count > 0 && f.options == nullptr)
    return named + "has a number but no array of options";
  for (std::size_t i = 0; i < f.option_count; ++i) {
    const std::string fault = option_fault(f.options[i]);
    if (!fault.empty()) return named + "has an option that " + fault;
    for (std::size_t k = 0; k < i; ++k) {
      if (std::strcmp(f.options[k].name, f.options[i].name) == 0) {
        return named + "has two options '" + f.options[i].name + "'";
      }
    }
  }
  const std::string fault = functions_fault(f);
  return fault.empty() ? fault : named + fault;
}

}  // namespace

bool is_known(std::string_view id) {
  for (const std::string_view known : kKnown) {
    if (id == known) return true;
  }
  return false;
}

bool is_name(const char* text) { return is_word(text, '-'); }
bool is_option_name(const char* text) { return is_word(text, '_'); }

std::string fault_of(const burin_plugin_table* table) {
  if (table == nullptr) return "it does not work with plug-ins of version 1";
  if (table->abi != BURIN_PLUGIN_ABI) {
    return "it is made for version " + std::to_string(table->abi) +
           " of plug-ins, this is version " + std::to_string(BURIN_PLUGIN_ABI);
  }
  if (!is_name(table->name)) return "it has no name made of a-z, 0-9 and -";
  if (!is_sentence(table->version)) return "it has no version";
  if (table->factory_count == 0 || table->factories == nullptr) return "it offers nothing";
  if (table->factory_count > kMostFactories) return "it has more than 64 factories";
  for (std::size_t i = 0; i < table->factory_count; ++i) {
    const burin_factory& f = table->factories[i];
    std::string fault = factory_fault(f);
    if (!fault.empty()) return fault;
    for (std::size_t k = 0; k < i; ++k) {
      const burin_factory& other = table->factories[k];
      if (std::strcmp(f.id, other.id) == 0 && std::strcmp(f.name, other.name) == 0) {
        return std::string("it has two of ") + f.id + " '" + f.name + "'";
      }
    }
  }
  return {};
}

}  // namespace burin::plugin
