#include <burin/base/parallel.h>
#include <burin/drawing/ordered_text.h>

#include <ostream>
#include <vector>

namespace burin {
namespace {

constexpr std::size_t kPieceWeight = 4096;  // about 1 ms of work
constexpr std::size_t kPiecesAtOnce = 64;

}  // namespace

void write_ordered(std::size_t n, const std::function<std::size_t(std::size_t)>& weight,
                   const std::function<void(std::size_t, Buffer&)>& format, std::ostream& out,
                   const RunContext& context) {
  std::vector<std::size_t> starts;
  std::size_t next = 0;
  while (next < n) {
    starts.clear();
    while (next < n && starts.size() < kPiecesAtOnce) {
      starts.push_back(next);
      for (std::size_t w = 0; next < n && w < kPieceWeight; ++next) w += weight(next) + 1;
    }
    const std::size_t pieces = starts.size();
    starts.push_back(next);
    std::vector<Buffer> texts(pieces);
    const auto body = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        for (std::size_t i = starts[k]; i < starts[k + 1]; ++i) format(i, texts[k]);
      }
    };
    parallel_for(pieces, 1, body, &context);
    for (const Buffer& text : texts) {
      out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
  }
}

}  // namespace burin
