#pragma once
// At which scale pages of a step book are drawn; internal to the module.

#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// Of what is put together on a page (empty: the whole), and the largest scale at which it fits.
struct FittedPage {
  std::string assembly;
  double scale = 1;
};

struct PageScale {
  /// Paper mm a model mm.
  double value = 1;
  /// As the page says it; empty where the page before has the same scale.
  std::string told;
};

/// What is asked of the scales of a book.
struct AskedScale {
  /// Those of ISO 5455 alone.
  bool iso = false;
  /// Of all pages, unless one has no room for it.
  std::optional<double> given{};
};

/// One scale for the pages of one assembly, the smallest at which one of them fits; but a page that
/// would fit at more than twice that scale begins anew. Cost: linear.
std::vector<PageScale> common_scales(const std::vector<FittedPage>& pages, const AskedScale& asked);

}  // namespace burin::detail
