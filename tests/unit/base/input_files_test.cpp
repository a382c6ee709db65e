#include <burin/base/input_files.h>

#include <burin_test/folder.h>
#include <gtest/gtest.h>

#include <thread>

namespace burin {
namespace {

TEST(InputFiles, HearsOfFilesWhileItLives) {
  const test::Folder folder;
  const std::string a = folder.write("a", "1"), b = folder / "b";
  InputFiles::opens(a);  // nobody listens
  const InputFiles outer;
  EXPECT_TRUE(outer.stamps().empty());
  InputFiles::opens(a);
  {
    const InputFiles inner;
    InputFiles::opens(b);
    EXPECT_EQ(inner.stamps().size(), 1u);
    std::thread([&] { InputFiles::opens(folder / "c"); }).join();  // another thread's
  }
  ASSERT_EQ(outer.stamps().size(), 2u);
  EXPECT_TRUE(outer.stamps().at(a).there);
  EXPECT_EQ(outer.stamps().at(a).size, 1u);
  EXPECT_FALSE(outer.stamps().at(b).there);
}

TEST(InputFiles, AStampIsThatOfTheFirstOpening) {
  const test::Folder folder;
  const std::string a = folder.write("a", "1");
  const InputFiles files;
  InputFiles::opens(a);
  EXPECT_FALSE(changed(files.stamps()));
  folder.write("a", "12");
  InputFiles::opens(a);
  EXPECT_TRUE(changed(files.stamps()));
}

TEST(InputFiles, AnotherFileOfTheSameNameIsAnother) {
  const test::Folder folder;
  const std::string a = folder.write("a", "1"), b = folder.write("b", "1");
  InputFiles::Stamps stamps{{a, stamp_of(a)}};
  std::filesystem::rename(b, a);
  EXPECT_TRUE(changed(stamps));
  std::filesystem::remove(a);
  EXPECT_TRUE(changed(stamps));
  stamps[a] = stamp_of(a);
  EXPECT_FALSE(changed(stamps));  // it is still not there
}

}  // namespace
}  // namespace burin
