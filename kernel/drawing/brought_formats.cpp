#include <burin/base/catalogue.h>
#include <burin/drawing/brought_formats.h>

namespace burin {
namespace {

GrowingCatalogue<BroughtFormat>& all() {
  static GrowingCatalogue<BroughtFormat> formats({});
  return formats;
}

}  // namespace

std::span<const BroughtFormat> brought_formats() { return all().rows(); }

void add(BroughtFormat format) { all().add(std::move(format)); }

}  // namespace burin
