#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include "kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace burin {
namespace {

using detail::Kind;

std::size_t digits_at_end(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[text.size() - 1 - n])) ++n;
  return n;
}

/// The name that all members have, if they have one.
template <class Get>
std::string common(const std::vector<std::size_t>& parts, const Get& get) {
  const std::string first(get(parts.front()));
  const auto same = [&](std::size_t i) { return get(i) == first; };
  return std::ranges::all_of(parts, same) ? first : std::string();
}

/// Whether the number at the end of a name belongs to it, as in M3x10 or M6: the word before it
/// holds a digit or is one letter.
bool number_is_meant(std::string_view name) {
  const std::string_view stem = name.substr(0, name.size() - digits_at_end(name));
  if (stem.size() == name.size() || stem.empty()) return false;
  const std::size_t blank = stem.find_last_of(" _-");
  const std::string_view word = blank == stem.npos ? stem : stem.substr(blank + 1);
  return word.size() == 1 || std::ranges::any_of(word, is_digit);
}

/// What a kind is called: as the input calls what all its members are instances of (members that
/// are none: as they are called), or what is common to these names, or as the first where its
/// number belongs to it.
std::string name_of(const Scene& scene, const Kind& kind) {
  const auto called = [&](std::size_t i) {
    const Part& part = detail::listed(scene.parts[i]);
    return part.definition.empty() ? std::string(name_as_read(part.name)) : part.definition;
  };
  if (std::string name = common(kind.parts, called); !name.empty()) return name;
  std::string first = called(kind.parts.front());
  if (number_is_meant(first)) return first;
  const auto stem = [&](std::size_t i) { return instance_stem(called(i)); };
  if (std::string name = common(kind.parts, stem); !name.empty()) return name;
  return kind.key;
}

/// Gives kinds of parts their numbers and names.
class Numbering {
 public:
  Numbering(const Scene& scene, const ItemNumbers& kept, Diagnostics& diagnostics)
      : scene_(scene), kept_(kept), diagnostics_(diagnostics) {}

  std::vector<Item> of(std::vector<Kind> kinds) {
    std::set<std::string> taken;
    std::map<std::string, int> same;
    for (Kind& kind : kinds) {
      Item& item = items_.emplace_back();
      item.name = name_of(scene_, kind);
      const std::string plain = item.name;
      while (!taken.insert(item.name).second) {
        item.name = fmt::format("{} ({})", plain, ++same[plain] + 1);
      }
      item.color =
          common(kind.parts, [&](std::size_t i) { return detail::listed(scene_.parts[i]).color; });
      item.source = common(kind.parts, [&](std::size_t i) { return scene_.parts[i].source; });
      item.parts = std::move(kind.parts);
    }
    take_selected();
    take_named();
    take_renamed();
    take_new();
    std::ranges::sort(items_, {}, &Item::number);
    return std::move(items_);
  }

 private:
  void give(Item& item, int number) {
    item.number = number;
    const auto kept = kept_.find(number);
    if (kept != kept_.end() && !kept->second.name.empty()) item.name = kept->second.name;
    used_.insert(number);
  }

  void take_selected() {
    for (const auto& [number, kept] : kept_) {
      if (kept.select.empty()) continue;
      std::vector<std::size_t> parts;
      try {
        parts = select(scene_, kept.select);
      } catch (const UsageError&) {
        continue;  // a hole
      }
      std::set<Item*> meant;
      for (Item& item : items_) {
        const auto holds = [&](std::size_t part) { return std::ranges::count(item.parts, part); };
        if (std::ranges::any_of(parts, holds)) meant.insert(&item);
      }
      const int other = meant.size() == 1 ? (*meant.begin())->number : 0;
      Item* own = other == 0 ? *meant.begin() : part_off(**meant.begin(), parts);
      if (meant.size() > 1 || !own) {
        throw UsageError(fmt::format("item {}: '{}' names parts of {}; name those of one alone",
                                     number, kept.select,
                                     meant.size() > 1 ? fmt::format("{} items", meant.size())
                                                      : fmt::format("item {}", other)));
      }
      give(*own, number);
    }
  }

  /// Copies of one thing that have numbers of their own: an item of these parts, beside the one
  /// that has them now. Null where that one would be left without the parts that its own selector
  /// names.
  Item* part_off(Item& whole, const std::vector<std::size_t>& parts) {
    const auto taken = [&](std::size_t part) { return std::ranges::count(parts, part) > 0; };
    for (const std::size_t part : select(scene_, kept_.at(whole.number).select)) {
      if (taken(part)) return nullptr;
    }
    Item off = whole;
    std::erase_if(whole.parts, taken);
    std::erase_if(off.parts, [&](std::size_t part) { return !taken(part); });
    const auto named = [&](const std::string& name) {
      return std::ranges::find(items_, name, &Item::name) != items_.end();
    };
    const std::string plain = off.name;
    for (int n = 2; named(off.name); ++n) off.name = fmt::format("{} ({})", plain, n);
    return &items_.emplace_back(std::move(off));
  }

  void take_named() {
    std::map<std::string_view, int> number_of;
    for (const auto& [number, kept] : kept_) {
      if (used_.contains(number) || kept.name.empty()) continue;
      number_of.try_emplace(kept.name, number);
    }
    for (Item& item : items_) {
      const auto known = number_of.find(item.name);
      if (item.number == 0 && known != number_of.end()) give(item, known->second);
    }
  }

  /// A name that nothing has, for a number that an item has by its place.
  void take_renamed() {
    std::string first;
    for (const auto& [number, kept] : kept_) {
      const auto at = static_cast<std::size_t>(number - 1);
      if (!kept.renames || used_.contains(number) || at >= items_.size()) continue;
      Item& item = items_[at];
      if (item.number != 0) continue;
      if (first.empty()) first = fmt::format("{}, '{}', is '{}'", number, item.name, kept.name);
      give(item, number);
      ++renamed_;
    }
    if (renamed_ == 0) return;
    // As many as there were: nothing but names has changed.
    const bool sure = kept_.size() <= items_.size();
    diagnostics_.add(
        sure ? Severity::Info : Severity::Warning, "items.renamed", renamed_,
        fmt::format("items take their names from the illustration, by number; the first: {}",
                    first));
  }

  void take_new() {
    int next = kept_.empty() ? 1 : kept_.rbegin()->first + 1;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (items_[i].number != 0) continue;
      const int own = static_cast<int>(i) + 1;
      const bool by_place = renamed_ > 0 && !kept_.contains(own) && !used_.contains(own);
      while (!by_place && used_.contains(next)) ++next;
      give(items_[i], by_place ? own : next++);
    }
  }

  const Scene& scene_;
  const ItemNumbers& kept_;
  Diagnostics& diagnostics_;
  std::vector<Item> items_;
  std::set<int> used_;
  std::int64_t renamed_ = 0;
};

}  // namespace

std::string stem_of(const Part& part) {
  return instance_stem(part.definition.empty() ? part.name : part.definition);
}

std::string_view name_as_read(std::string_view name) {
  const std::size_t n = digits_at_end(name);
  const std::string_view rest = name.substr(0, name.size() - n);
  return n > 0 && rest.size() > 2 && rest.ends_with(" #") ? rest.substr(0, rest.size() - 2) : name;
}

std::string instance_stem(std::string_view name) {
  std::string_view rest = name_as_read(name);
  std::string whole(rest);
  if (rest.ends_with(')')) {
    const std::string_view inner = rest.substr(0, rest.size() - 1);
    const std::size_t n = digits_at_end(inner);
    const std::string_view before = inner.substr(0, inner.size() - n);
    if (n > 0 && before.size() > 2 && before.ends_with(" (")) {
      return std::string(before.substr(0, before.size() - 2));
    }
    return whole;
  }
  const std::size_t n = digits_at_end(rest);
  std::string_view before = rest.substr(0, rest.size() - n);
  if (n == 0 || before.empty()) return whole;
  constexpr std::string_view kBetween = "_.:-# ";
  constexpr std::size_t kCounter = 3;  // FreeCAD's: Bolt001
  if (kBetween.find(before.back()) != kBetween.npos) {
    const std::size_t last = before.find_last_not_of(kBetween);
    if (last != before.npos) return std::string(before.substr(0, last + 1));
  } else if (n >= kCounter) {
    return std::string(before);
  }
  return whole;
}

std::vector<Item> find_items(const Scene& scene, const ItemNumbers& kept, Diagnostics& diagnostics,
                             RunContext& context, const std::vector<bool>& unlisted) {
  std::vector<Kind> kinds = detail::Kinds(scene, diagnostics, context).find(unlisted);
  return Numbering(scene, kept, diagnostics).of(std::move(kinds));
}

ItemNumbers numbers_of(const std::vector<Item>& items, const ItemNumbers& kept) {
  ItemNumbers all = kept;
  for (const Item& item : items) {
    KeptItem& one = all.try_emplace(item.number).first->second;
    if (one.name.empty()) one.name = item.name;
  }
  return all;
}

}  // namespace burin
