#include <burin/assembly/pieces.h>

#include "selector_names.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace burin {
namespace {

std::vector<detail::NamePatterns> patterns_of(std::span<const std::string> selectors) {
  std::vector<detail::NamePatterns> patterns;
  for (const std::string& selector : selectors) {
    // What is wrong with others is told where they are to select something.
    if (selector.find_first_not_of('/') == selector.npos || selector.starts_with('@')) continue;
    patterns.emplace_back(selector);
  }
  return patterns;
}

bool any_piece_named(const Part& part, const std::vector<detail::NamePatterns>& patterns) {
  std::vector<std::string> names = detail::names_of(part);
  names.emplace_back();
  const auto named = [&](const std::string& name) {
    names.back() = name;
    return std::ranges::any_of(patterns, [&](const auto& p) { return p.lead_to_last(names); });
  };
  return std::ranges::any_of(part.pieces, [&](const Piece& piece) {
    return std::ranges::any_of(detail::names_of_piece(piece.name), named);
  });
}

/// Whether some bodies can be looked through and others not.
bool is_glazed(const Part& part) {
  const auto clear = [](const Piece& piece) { return piece.opacity < 1; };
  return std::ranges::any_of(part.pieces, clear) && !std::ranges::all_of(part.pieces, clear);
}

Part part_of(const std::shared_ptr<const Part>& all, const Piece& piece) {
  const Part& whole = *all;
  Part part;
  part.whole = all;
  // By itself it is not what the whole is an instance of.
  part.definition = (whole.definition.empty() ? whole.name : whole.definition) + ", " + piece.name;
  part.name = piece.name;
  part.source = whole.source;
  part.form = piece.form;
  part.assembly = detail::names_of(whole);
  const bool own = !piece.color.empty();
  part.color = own ? piece.color : whole.color;
  part.opacity = own ? piece.opacity : whole.opacity;
  part.face_colors = piece.face_colors;
  return part;
}

}  // namespace

std::string piece_name(const std::string& number, const std::string& given) {
  return given.empty() ? number : number + " (" + given + ")";
}

std::vector<std::size_t> split_pieces(Scene& scene, std::span<const std::string> selectors,
                                      bool glazed) {
  const std::vector<detail::NamePatterns> patterns = patterns_of(selectors);
  std::vector<Part> others;
  std::vector<std::size_t> from;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    Part& part = scene.parts[i];
    const bool wanted = any_piece_named(part, patterns) || (glazed && is_glazed(part));
    if (part.pieces.empty() || !wanted) continue;
    const auto whole = std::make_shared<const Part>(std::move(part));
    part = part_of(whole, whole->pieces.front());
    part.pmi = whole->pmi;  // once
    for (std::size_t k = 1; k < whole->pieces.size(); ++k) {
      others.push_back(part_of(whole, whole->pieces[k]));
      from.push_back(i);
    }
  }
  scene.parts.insert(scene.parts.end(), std::make_move_iterator(others.begin()),
                     std::make_move_iterator(others.end()));
  return from;
}

}  // namespace burin
