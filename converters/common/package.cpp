#include "package.h"

#include <burin/base/error.h>
#include <burin/base/platform.h>

#include "bytes.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

// A parsed document takes several times the bytes of its text.
constexpr std::size_t kShareOfMemory = 8;
// The first day that the format knows, 1980-01-01.
constexpr zip_uint16_t kDate = (1 << 5) | 1;

std::size_t largest_member() {
  const std::uint64_t memory = platform::memory_bytes();
  return memory == 0 ? std::size_t{1} << 29 : static_cast<std::size_t>(memory / kShareOfMemory);
}

struct CloseMember {
  void operator()(zip_file_t* f) const { zip_fclose(f); }
};

}  // namespace

namespace detail {
struct CloseArchive {
  void operator()(zip_t* z) const { zip_discard(z); }
};
}  // namespace detail

struct Package::Impl {
  std::unique_ptr<zip_t, detail::CloseArchive> archive;

  zip_int64_t locate(const std::string& name) const {
    const char* n = name.c_str();
    while (*n == '/') ++n;
    // Without regard to case libzip compares with every name of the archive.
    const zip_int64_t exact = zip_name_locate(archive.get(), n, 0);
    return exact >= 0 ? exact : zip_name_locate(archive.get(), n, ZIP_FL_NOCASE);
  }
};

Package::Package(const Source& source, std::string kind)
    : source_(source), kind_(std::move(kind)), impl_(std::make_unique<Impl>()) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* bytes =
      zip_source_buffer_create(source.bytes().data(), source.bytes().size(), 0, &error);
  if (bytes != nullptr) {
    impl_->archive.reset(zip_open_from_source(bytes, ZIP_RDONLY, &error));
    if (!impl_->archive) zip_source_free(bytes);
  }
  const std::string reason = impl_->archive ? std::string() : zip_error_strerror(&error);
  zip_error_fini(&error);
  if (!impl_->archive) {
    source_.fail(
        fmt::format("is a damaged zip archive ({}); it may be truncated, export it again", reason));
  }
}

Package::~Package() = default;

std::vector<std::string> Package::names() const {
  std::vector<std::string> out;
  const zip_int64_t count = zip_get_num_entries(impl_->archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(impl_->archive.get(), static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr) out.emplace_back(name);
  }
  return out;
}

bool Package::has(const std::string& name) const { return impl_->locate(name) >= 0; }

std::string Package::read(const std::string& name) const {
  const zip_int64_t found = impl_->locate(name);
  if (found < 0) source_.fail(fmt::format("the {} has no member {}; export it again", kind_, name));
  const auto index = static_cast<zip_uint64_t>(found);
  zip_stat_t info;
  zip_stat_init(&info);
  zip_stat_index(impl_->archive.get(), index, 0, &info);
  constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
  if ((info.valid & kNeeded) != kNeeded) {
    source_.fail(fmt::format("{} in the {} has no size; export it again", name, kind_));
  }
  const auto packed = static_cast<double>(info.comp_size), size = static_cast<double>(info.size);
  if (info.comp_size > source_.bytes().size() || is_bomb(packed, size)) {
    source_.fail(
        fmt::format("{} in the {} claims {} bytes packed into {}; it is damaged or "
                    "hostile and was not unpacked",
                    name, kind_, info.size, info.comp_size));
  }
  if (info.size > largest_member()) {
    source_.fail(fmt::format("{} in the {} holds {} bytes, too many for this machine's memory",
                             name, kind_, info.size));
  }
  const std::unique_ptr<zip_file_t, CloseMember> member(
      zip_fopen_index(impl_->archive.get(), index, 0));
  const auto fail = [&](const char* reason) {
    source_.fail(
        fmt::format("{} in the {} cannot be unpacked ({}); export it again", name, kind_, reason));
  };
  if (!member) fail(zip_strerror(impl_->archive.get()));
  std::string bytes(static_cast<std::size_t>(info.size), '\0');
  constexpr std::size_t kPiece = std::size_t{4} << 20;
  for (std::size_t done = 0; done < bytes.size();) {
    source_.context().check();
    const zip_int64_t got =
        zip_fread(member.get(), bytes.data() + done, std::min(kPiece, bytes.size() - done));
    if (got < 0) fail(zip_file_strerror(member.get()));
    if (got == 0) fail("it is shorter than it claims");
    done += static_cast<std::size_t>(got);
  }
  char more = 0;  // reading on to the end makes libzip compare the checksum
  if (zip_fread(member.get(), &more, 1) != 0) fail("its checksum or size is wrong");
  return bytes;
}

std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& members) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* whole = zip_source_buffer_create(nullptr, 0, 0, &error);
  const auto fail = [&](const char* why) {
    throw OutputError(fmt::format("no zip archive can be made: {}", why));
  };
  if (whole == nullptr) fail(zip_error_strerror(&error));
  std::unique_ptr<zip_t, detail::CloseArchive> archive(
      zip_open_from_source(whole, ZIP_CREATE | ZIP_TRUNCATE, &error));
  if (!archive) fail(zip_error_strerror(&error));
  zip_source_keep(whole);  // it outlives the archive, to be read
  for (const auto& [name, bytes] : members) {
    zip_source_t* source = zip_source_buffer(archive.get(), bytes.data(), bytes.size(), 0);
    const zip_int64_t at = zip_file_add(archive.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (at < 0) fail(zip_strerror(archive.get()));
    zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(at), 0, kDate, 0);
  }
  if (zip_close(archive.get()) != 0) fail(zip_strerror(archive.get()));
  static_cast<void>(archive.release());
  std::string out;
  zip_stat_t info;
  zip_stat_init(&info);
  if (zip_source_stat(whole, &info) == 0 && zip_source_open(whole) == 0) {
    out.resize(info.size);
    const zip_int64_t read = zip_source_read(whole, out.data(), out.size());
    out.resize(read < 0 ? 0 : static_cast<std::size_t>(read));
    zip_source_close(whole);
  }
  zip_source_free(whole);
  if (out.empty()) fail("it cannot be read back");
  return out;
}

}  // namespace burin
