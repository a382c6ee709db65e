#include "repeated_calls.h"

#include "marks.h"
#include "parts.h"
#include "solid_store.h"

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

// The tree is written with six digits: places that differ by less are one.
constexpr double kComparedDigits = 1e6;

using Place = std::array<std::int64_t, 12>;

Place place_of(const csg::Matrix& m) {
  Place out{};
  std::size_t i = 0;
  for (const auto& row : m.row) {
    for (const double x : row) out[i++] = std::llround(kComparedDigits * x);
  }
  return out;
}

/// What stands around the nodes up to `end`: the innermost call, and what moves and colours them
/// within it.
struct Scope {
  std::uint32_t end = 0, call = 0;
  csg::Matrix at;
  std::string colors;
  /// Whether nothing else is said of them.
  bool plain = true;
};

class RepeatFinder {
 public:
  RepeatFinder(const csg::Tree& tree, const TreeCalls& calls) : tree_(tree), calls_(calls) {}

  std::set<std::uint32_t> run() {
    for (std::uint32_t n = 0; n < tree_.nodes.size();) {
      while (!scopes_.empty() && scopes_.back().end <= n) scopes_.pop_back();
      n = visit(n) ? n + 1 : tree_.nodes[n].end;
    }
    return std::move(found_);
  }

 private:
  /// False where nothing below the node is looked at.
  bool visit(std::uint32_t n) {
    const csg::Node& node = tree_.nodes[n];
    if (!is_open(node.module)) return false;
    Scope scope = scopes_.empty() ? Scope{} : scopes_.back();
    scope.end = node.end;
    scope.plain = scope.plain && !node.background && !node.highlight && !mark_of_group(tree_, n);
    if (calls_.at(n)) {
      const bool fresh = !scope.plain || seen_
                                             .emplace(scope.call, place_of(scope.at), scope.colors,
                                                      key_of(std::string(tree_.text_of(n))))
                                             .second;
      if (!fresh) {
        found_.insert(n);
        return false;
      }
      scope = {.end = node.end, .call = n, .at = {}, .colors = {}};
    } else if (node.module == csg::Module::Multmatrix) {
      scope.at = scope.at * csg::matrix_of(tree_, n);
    } else if (node.module == csg::Module::Color && n + 1 < node.end) {
      scope.colors.append(tree_.source, node.begin, tree_.nodes[n + 1].begin - node.begin);
    }
    scopes_.push_back(std::move(scope));
    return true;
  }

  const csg::Tree& tree_;
  const TreeCalls& calls_;
  std::vector<Scope> scopes_;
  std::set<std::tuple<std::uint32_t, Place, std::string, std::string>> seen_;
  std::set<std::uint32_t> found_;
};

}  // namespace

std::set<std::uint32_t> repeated_calls(const csg::Tree& tree, const TreeCalls& calls) {
  return RepeatFinder(tree, calls).run();
}

}  // namespace burin::detail
