#include <burin/assembly/items.h>
#include <burin/base/ascii.h>
#include <burin/base/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace burin {
namespace {

std::size_t digits_at_end(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[text.size() - 1 - n])) ++n;
  return n;
}

/// Without " #2", which the readers add to the second part of a name.
std::string_view as_read(std::string_view name) {
  const std::size_t n = digits_at_end(name);
  std::string_view rest = name.substr(0, name.size() - n);
  return n > 0 && rest.size() > 2 && rest.ends_with(" #") ? rest.substr(0, rest.size() - 2) : name;
}

/// One shape, as far as it is known.
struct Shape {
  Definition definition;
  std::optional<ShapeMeasure> measure;
};

/// Parts that are alike, before they have a number.
struct Kind {
  std::string key;
  std::vector<Shape> shapes;
  std::vector<std::size_t> parts;
};

class Kinds {
 public:
  Kinds(const Scene& scene, Diagnostics& diagnostics, RunContext& context)
      : scene_(scene), diagnostics_(diagnostics), context_(context) {}

  std::vector<Kind> find() {
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      context_.check();
      add(i);
    }
    return std::move(kinds_);
  }

 private:
  void add(std::size_t index) {
    const Part& part = scene_.parts[index];
    const std::string key =
        part.definition.empty() ? instance_stem(part.name) : instance_stem(part.definition);
    std::vector<std::size_t>& of_name = by_name_[key];
    Shape shape{part.form->definition(), {}};
    for (const std::size_t k : of_name) {
      const auto same = [&](const Shape& s) { return s.definition.same(shape.definition); };
      if (std::ranges::any_of(kinds_[k].shapes, same)) return kinds_[k].parts.push_back(index);
    }
    // Measured only where a name has two shapes.
    for (const std::size_t k : of_name) {
      Shape& first = kinds_[k].shapes.front();
      if (!first.measure) first.measure = measured(kinds_[k].parts.front());
      if (!shape.measure) shape.measure = measured(index);
      if (!first.measure || !shape.measure || !first.measure->same(*shape.measure)) continue;
      kinds_[k].shapes.push_back(shape);
      return kinds_[k].parts.push_back(index);
    }
    of_name.push_back(kinds_.size());
    kinds_.push_back({key, {shape}, {index}});
  }

  std::optional<ShapeMeasure> measured(std::size_t index) {
    const Part& part = scene_.parts[index];
    try {
      return part.form->measure(context_);
    } catch (const GeometryError& e) {
      if (told_.insert(index).second) {
        diagnostics_.add(Severity::Warning, "items.not_measured", 1,
                         fmt::format("{}: counts as an item of its own, as it cannot be compared "
                                     "with others of its name: {}",
                                     part.name, e.what()));
      }
      return std::nullopt;
    }
  }

  const Scene& scene_;
  Diagnostics& diagnostics_;
  RunContext& context_;
  std::vector<Kind> kinds_;
  std::map<std::string, std::vector<std::size_t>> by_name_;
  std::set<std::size_t> told_;
};

/// The name that all members have, if they have one.
template <class Get>
std::string common(const std::vector<std::size_t>& parts, const Get& get) {
  const std::string first(get(parts.front()));
  const auto same = [&](std::size_t i) { return get(i) == first; };
  return std::ranges::all_of(parts, same) ? first : std::string();
}

/// What a kind is called: as the input calls what its members are instances of, or as all of them
/// are called, or what is common to their names.
std::string name_of(const Scene& scene, const Kind& kind) {
  const auto definition = [&](std::size_t i) { return scene.parts[i].definition; };
  if (std::string name = common(kind.parts, definition); !name.empty()) return name;
  const auto own = [&](std::size_t i) { return as_read(scene.parts[i].name); };
  if (std::string name = common(kind.parts, own); !name.empty()) return name;
  return kind.key;
}

}  // namespace

std::string instance_stem(std::string_view name) {
  std::string_view rest = as_read(name);
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
                             RunContext& context) {
  std::vector<Item> items;
  std::map<std::string, int> number_of, same;
  std::set<std::string> taken;
  for (const auto& [number, name] : kept) number_of.try_emplace(name, number);
  int next = kept.empty() ? 1 : kept.rbegin()->first + 1;
  for (Kind& kind : Kinds(scene, diagnostics, context).find()) {
    Item item;
    item.name = name_of(scene, kind);
    const std::string plain = item.name;
    while (!taken.insert(item.name).second)
      item.name = fmt::format("{} ({})", plain, ++same[plain] + 1);
    const auto known = number_of.find(item.name);
    item.number = known != number_of.end() ? known->second : next++;
    item.color = common(kind.parts, [&](std::size_t i) { return scene.parts[i].color; });
    item.source = common(kind.parts, [&](std::size_t i) { return scene.parts[i].source; });
    item.parts = std::move(kind.parts);
    items.push_back(std::move(item));
  }
  std::ranges::sort(items, {}, &Item::number);
  return items;
}

ItemNumbers numbers_of(const std::vector<Item>& items, const ItemNumbers& kept) {
  ItemNumbers all = kept;
  for (const Item& item : items) all.try_emplace(item.number, item.name);
  return all;
}

}  // namespace burin
