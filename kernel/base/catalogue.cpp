#include <burin/base/catalogue.h>

namespace burin {
namespace {

std::atomic<std::uint64_t> g_growth{0};

}  // namespace

std::uint64_t catalogue_growth() { return g_growth; }

void note_catalogue_growth() { ++g_growth; }

}  // namespace burin
