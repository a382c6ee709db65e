// The same bytes on every processor: drawings with Embree's code for old and for new ones.
#include <burin_test/command.h>
#include <burin_test/sanitized.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace burin {
namespace {

// Sets a variable of the environment that commands inherit.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    ::setenv(name, value.c_str(), 1);
  }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

std::string drawn(const test::Folder& folder, const std::string& sample, const std::string& style,
                  const std::string& embree) {
  const Variable library("LD_PRELOAD", BURIN_TEST_PROCESSOR), kind("BURIN_TEST_EMBREE", embree);
  const std::string out = folder / "out.svg";
  test::Command command(folder, {"draw", std::string(BURIN_SOURCE_DIR) + "/samples/" + sample,
                                 "--style", style, "--paper", "A6", "-o", out});
  EXPECT_EQ(command.wait(), 0) << command.std_err;
  std::string bytes = test::slurp(out);
  std::filesystem::remove(out);
  return bytes;
}

TEST(Processors, DrawTheSameBytes) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer wants to be loaded first";
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  const test::Folder folder;
  // Every kind of model with all that an engraving asks of rays (features, strokes, hidden spans);
  // strokes on points ask nothing else, so one model has them.
  const std::pair<const char*, const char*> cases[] = {
      {"spindle.stl", "engraving"},       {"bracket.off", "engraving"},
      {"bearing_stand.obj", "engraving"}, {"moai_scan.ply", "outline"},
      {"teapot.itd", "engraving"},        {"coupling.step", "engraving"},
      {"pump_cover.implicit", "outline"}, {"spindle.stl", "pencil"}};
  for (const auto& [sample, style] : cases) {
    const std::string old = drawn(folder, sample, style, "isa=sse2");
    EXPECT_FALSE(old.empty());
    EXPECT_TRUE(old == drawn(folder, sample, style, "isa=avx2")) << sample << ' ' << style;
  }
}

// Or the test above would compare a drawing with itself.
TEST(Processors, AreWhatEmbreeIsTold) {
  if (test::kSanitized) GTEST_SKIP() << "a sanitizer wants to be loaded first";
  const test::Folder folder;
  const Variable library("LD_PRELOAD", BURIN_TEST_PROCESSOR);
  const Variable kind("BURIN_TEST_EMBREE", "isa=sse2,verbose=1");
  test::Command command(folder, {"draw", std::string(BURIN_SOURCE_DIR) + "/samples/bracket.off",
                                 "--style", "outline", "-o", folder / "out.svg"});
  ASSERT_EQ(command.wait(), 0) << command.std_err;
  EXPECT_NE(command.std_out.find("ISA     : XMM SSE SSE2 \n"), std::string::npos)
      << command.std_out;
}

}  // namespace
}  // namespace burin
