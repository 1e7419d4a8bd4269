#include "problems/io/replace_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

TEST(ReplaceFile, WritesAndOverwrites) {
  const files::TemporaryFolder folder;
  replace_file(folder.file("x"), "a longer text");
  replace_file(folder.file("x"), std::string_view("a\0b", 3));
  EXPECT_EQ(files::content(folder.file("x")), std::string("a\0b", 3));
}

TEST(ReplaceFile, NamesTheFileInAFolderThatIsNotThere) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("missing/x");
  EXPECT_EQ(files::message_of<UnwritableOutput>([&] { replace_file(path, "text"); }),
            path + ": cannot write: No such file or directory");
}

TEST(ReplaceFile, DoesNotReplaceADirectory) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("directory");
  std::filesystem::create_directory(path);
  EXPECT_THROW(replace_file(path, "text"), UnwritableOutput);
  std::filesystem::remove(path);
  EXPECT_TRUE(folder.empty());
}

// A limit on the size of files stands for a full disk.
TEST(ReplaceFile, LeavesTheOldFileAndNothingElseWhenTheDiskIsFull) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("x");
  files::put(path, "old");
  const std::string message = files::message_of<UnreadableInput>([&] {
    try_in_child("writing", 60, [&] {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{1000, 1000};
      setrlimit(RLIMIT_FSIZE, &limit);
      replace_file(path, std::string(2000, 'x'));
      return std::string();
    });
  });
  EXPECT_EQ(message, path + ": cannot write: File too large");
  EXPECT_EQ(files::content(path), "old");
  std::filesystem::remove(path);
  EXPECT_TRUE(folder.empty());
}

TEST(MakeDirectories, MakesThoseAboveTooAndLeavesWhatIsThere) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("a/b");
  make_directories(path);
  files::put(path + "/x", "text");
  make_directories(path);
  EXPECT_EQ(files::content(path + "/x"), "text");
  EXPECT_EQ(files::message_of<UnwritableOutput>([&] { make_directories(path + "/x/y"); }),
            path + "/x/y: cannot create: Not a directory");
}

}  // namespace
}  // namespace lcp
