#include "source.h"

#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>
#include <burin/base/piped_input.h>
#include <burin/base/platform.h>

#include "bytes.h"
#include "packed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace burin {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path) : fd_(platform::open_to_read(path)) {}
  ~Descriptor() {
    if (fd_ >= 0) platform::close_file(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string reason(int error) {
  if (error == ENOENT || error == ENOTDIR) return "no such file; check the path";
  if (error == EACCES || error == EPERM) return "may not be read; check its permissions";
  return fmt::format("cannot be read: {}", std::generic_category().message(error));
}

std::size_t half_of_memory() {
  const std::uint64_t memory = platform::memory_bytes();
  return memory == 0 ? std::size_t{1} << 32 : static_cast<std::size_t>(memory / 2);
}

}  // namespace

namespace {

/// Bytes of a file with a NUL behind them.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view text() const { return {data.get(), size}; }
};

FileBytes copied(std::string_view bytes) {
  FileBytes out{std::make_unique_for_overwrite<char[]>(bytes.size() + 1), bytes.size()};
  std::memcpy(out.data.get(), bytes.data(), bytes.size());
  out.data[out.size] = '\0';
  return out;
}

[[noreturn]] void fail_file(const std::string& file, const std::string& what) {
  throw InputError(what, file);
}

FileBytes read_file(const std::filesystem::path& path, const RunContext& context) {
  const std::string file = path.string();
  const Descriptor in(path);
  if (in.get() < 0) {
    const int error = errno;
    if (error == ENOENT || error == ENOTDIR) throw MissingFile(reason(error), file);
    fail_file(file, reason(error));
  }
  platform::FileState state;
  if (!platform::state_of(in.get(), state)) fail_file(file, reason(errno));
  if (state.kind == platform::FileKind::Folder) fail_file(file, "is a folder; name a file in it");
  if (state.kind != platform::FileKind::Regular) {
    fail_file(file, "is not a regular file; save the data to one first");
  }
  const auto size = static_cast<std::size_t>(state.size);
  if (size > half_of_memory()) {
    fail_file(file, fmt::format("holds {} bytes, more than half of this machine's memory", size));
  }
  FileBytes out{std::make_unique_for_overwrite<char[]>(size + 1), 0};
  constexpr std::size_t kPiece = std::size_t{8} << 20;  // a poll for cancellation every few ms
  while (out.size < size) {
    context.check();
    const std::ptrdiff_t got =
        platform::read_some(in.get(), out.data.get() + out.size, std::min(kPiece, size - out.size));
    if (got < 0) fail_file(file, reason(errno));
    if (got == 0) break;  // the file shrank meanwhile
    out.size += static_cast<std::size_t>(got);
  }
  out.data[out.size] = '\0';
  return out;
}

FileBytes bytes_of(const std::filesystem::path& path, const RunContext& context) {
  FileBytes out;
  if (is_piped(path)) {
    out = copied(*piped_input(path, half_of_memory(), context));
  } else {
    InputFiles::opens(path);
    out = read_file(path, context);
  }
  if (out.size == 0) fail_file(path.string(), "is empty; export the model again");
  return out;
}

/// Downloads are packed a second time by servers; there are files that unpack to themselves.
constexpr int kMostLayers = 3;
constexpr const char* kTooDeep =
    "is packed by gzip over {} times; it is damaged or hostile, and was not unpacked";

/// What gzip packed, as long as it is no bomb.
FileBytes unpacked(const FileBytes& packed, const std::string& file, const RunContext& context) {
  const std::size_t most = std::min(most_unpacked(packed.size), half_of_memory());
  const auto in = unpacked_bytes(packed.text(), file, context);
  const std::string text = take(*in, most + 1, context);
  if (text.size() > most) {
    fail_file(
        file,
        fmt::format("is packed by gzip and holds over {} bytes in {}; it is damaged or hostile, or "
                    "too large for this machine, and was not unpacked",
                    most, packed.size));
  }
  if (text.empty()) fail_file(file, "is packed by gzip and holds nothing; export the model again");
  return copied(text);
}

}  // namespace

Source::Source(const std::filesystem::path& path, const RunContext& context)
    : file_(path.string()), context_(context) {
  FileBytes bytes = bytes_of(path, context);
  for (int layer = 0; is_gzip(bytes.text()); ++layer) {
    if (layer == kMostLayers) fail(fmt::format(kTooDeep, kMostLayers));
    bytes = unpacked(bytes, file_, context);
  }
  data_ = std::move(bytes.data);
  size_ = bytes.size;
}

Source::Source(std::string file, std::string_view bytes, const RunContext& context)
    : file_(std::move(file)), context_(context) {
  FileBytes copy = copied(bytes);
  data_ = std::move(copy.data);
  size_ = copy.size;
}

Source as_it_is(const std::filesystem::path& path, const RunContext& context) {
  const FileBytes bytes = bytes_of(path, context);
  return {path.string(), bytes.text(), context};
}

namespace {

/// The packed bytes may end in the middle: what came before that counts.
std::string unpacked_head(std::string_view packed, std::size_t most, const std::string& file,
                          const RunContext& context) {
  std::string unpacked;
  try {
    const auto in = unpacked_bytes(packed, file, context);
    std::string byte(1, '\0');
    while (unpacked.size() < most && in->read(byte.data(), 1) == 1) unpacked += byte;
  } catch (const InputError&) {  // its reader says so
  }
  return unpacked;
}

}  // namespace

std::string head_of(const std::filesystem::path& path, std::size_t most,
                    const RunContext& context) {
  std::string head;
  if (is_piped(path)) {
    head = *piped_input(path, half_of_memory(), context);
  } else {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};
    head.resize(most);
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
  }
  for (int layer = 0; layer < kMostLayers && is_gzip(head); ++layer) {
    head = unpacked_head(head, most, path.string(), context);
  }
  return head.substr(0, most);
}

std::int64_t Source::line_of(const char* where) const {
  std::int64_t line = 1;
  for (const char* p = data_.get(); p < where; ++p) {
    line += *p == '\n' || (*p == '\r' && p[1] != '\n');
  }
  return line;
}

void Source::fail(const std::string& what) const { throw InputError(what, file_); }

void Source::fail_at_line(const char* where, const std::string& what) const {
  throw InputError(what, file_, line_of(where));
}

void Source::fail_at_byte(std::size_t offset, const std::string& what) const {
  throw InputError(fmt::format("at byte {}: {}", offset, what), file_);
}

}  // namespace burin
