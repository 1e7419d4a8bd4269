#include "problems/io/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "problems/io/errors.h"
#include "tests/problems/cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

Instance named(const std::string& name) { return make_instance(name, cases::plain(), {}); }

std::vector<std::string> names_of(const std::vector<Instance>& instances) {
  std::vector<std::string> names;
  for (const Instance& instance : instances) names.push_back(instance.name);
  return names;
}

std::string complaint_about(const std::string& where) {
  return files::message_of<UnreadableInput>([&] { load_instances(where); });
}

using Names = std::vector<std::string>;

class Load : public testing::Test {
 protected:
  const files::TemporaryFolder folder;
};

TEST_F(Load, ChoosesTheFormatByTheEnding) {
  for (const std::string file : {"x.hdf5", "x.h5", "x.M.mtx", "x.json"}) {
    save_instances(folder.file(file), {named("x")});
    const std::vector<Instance> read = load_instances(folder.file(file));
    ASSERT_EQ(read.size(), 1u) << file;
    EXPECT_EQ(read.front().name, "x") << file;
    EXPECT_EQ(read.front().sha256, named("x").sha256) << file;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.file("x.q.mtx")));
}

TEST_F(Load, TakesOneInstanceByItsName) {
  save_instances(folder.file("c.hdf5"), {named("a/1"), named("a/2")});
  EXPECT_EQ(names_of(load_instances(folder.file("c.hdf5#a/2"))), Names{"a/2"});
  EXPECT_EQ(complaint_about(folder.file("c.hdf5#a")),
            folder.file("c.hdf5: holds no instance called 'a'"));
  EXPECT_EQ(complaint_about(folder.file("c.hdf5#")),
            folder.file("c.hdf5#: no name behind the '#', expected FILE#NAME"));
  save_instances(folder.file("x.M.mtx"), {named("x")});
  EXPECT_EQ(names_of(load_instances(folder.file("x.M.mtx#x"))), Names{"x"});
  EXPECT_EQ(complaint_about(folder.file("x.M.mtx#y")),
            folder.file("x.M.mtx: holds no instance called 'y'"));
}

TEST_F(Load, TakesAFileWhoseOwnNameHoldsTheSign) {
  save_instances(folder.file("c#1.hdf5"), {named("a")});
  EXPECT_EQ(names_of(load_instances(folder.file("c#1.hdf5"))), Names{"a"});
  EXPECT_EQ(names_of(load_instances(folder.file("c#1.hdf5#a"))), Names{"a"});
}

TEST_F(Load, NamesAnInstanceAfterItsFileWhereTheFileNamesNone) {
  files::put(folder.file("a.hdf5.dat"), "1 0 1 1 1 1 2 -3");
  files::put(folder.file("b.json"), R"({"M": [[2]], "q": [-3]})");
  EXPECT_EQ(names_of(load_instances(folder.path())), (Names{"a.hdf5", "b"}));
  EXPECT_EQ(names_of(load_instances(folder.file("b.json#b"))), Names{"b"});
  EXPECT_EQ(complaint_about(folder.file("a.hdf5.dat#b")),
            folder.file("a.hdf5.dat: holds no instance called 'b'"));
}

TEST_F(Load, TakesTheDirectionsOfContactsFromTheOptions) {
  const std::string path = folder.file("x.dat");
  files::put(path, "3 1  0 3 3 3 3  1 0 0 0 1 0 0 0 1  -1 2 3  0.5");
  EXPECT_EQ(load_instances(path).front().problem.size(), 1 + 8 + 1);
  EXPECT_EQ(load_instances(path, {}, {.directions = 4}).front().problem.size(), 1 + 4 + 1);
  for (const Index odd : {-2, 0, 1, 7})
    EXPECT_THROW(load_instances(path, {}, {.directions = odd}), std::invalid_argument) << odd;
}

TEST_F(Load, ReportsAnEmptyFileAndBinaryJunkInOneLine) {
  const std::string junk("\x89\0\r\n\xFF{[1 2\n", 11);
  for (const std::string ending : {"hdf5", "h5", "M.mtx", "dat", "json"})
    for (const std::string& bytes : {std::string(), junk}) {
      files::put(folder.file("x." + ending), bytes);
      const std::string message = complaint_about(folder.file("x." + ending));
      EXPECT_TRUE(message.starts_with(folder.file("x."))) << message;
      EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos) << message;
    }
}

TEST_F(Load, CollectsADirectoryAndWhatIsBelowIt) {
  std::filesystem::create_directory(folder.file("inner"));
  save_instances(folder.file("z.hdf5"), {named("c/2"), named("c/1")});
  save_instances(folder.file("inner/x.M.mtx"), {named("y")});
  files::put(folder.file("notes.txt"), "not an instance");
  EXPECT_EQ(names_of(load_instances(folder.path())), (Names{"inner/x", "c/1", "c/2"}));
}

TEST_F(Load, TakesOneInstanceOfADirectoryByItsName) {
  save_instances(folder.file("a.hdf5"), {named("one"), named("two")});
  save_instances(folder.file("b.hdf5"), {named("three")});
  EXPECT_EQ(names_of(load_instances(folder.path() + "#three")), Names{"three"});
  EXPECT_EQ(complaint_about(folder.path() + "#four"),
            folder.path() + ": holds no instance called 'four'");
}

TEST_F(Load, ReportsTheUnreadableFilesOfADirectoryOrLeavesThemOutOnRequest) {
  save_instances(folder.file("good.hdf5"), {named("a")});
  files::put(folder.file("bad.hdf5"), "not HDF5");
  const std::string line =
      folder.file("bad.hdf5: the HDF5 library cannot open it, expected a complete HDF5 file");
  EXPECT_EQ(complaint_about(folder.path()), line);
  Names skipped;
  const std::vector<Instance> read =
      load_instances(folder.path(), [&](const std::string& reason) { skipped.push_back(reason); });
  EXPECT_EQ(names_of(read), Names{"a"});
  EXPECT_EQ(skipped, Names{line});
}

TEST_F(Load, RefusesTwoInstancesOfOneNameInADirectory) {
  save_instances(folder.file("one.hdf5"), {named("a")});
  save_instances(folder.file("two.hdf5"), {named("a")});
  EXPECT_EQ(complaint_about(folder.path()), folder.file("two.hdf5") + ": holds 'a' like " +
                                                folder.file("one.hdf5") +
                                                ", expected different names");
}

TEST_F(Load, ReportsWhatIsNoInstance) {
  EXPECT_EQ(complaint_about(folder.path()),
            folder.path() +
                ": no readable instance in this directory, expected .hdf5, .h5, .M.mtx "
                "(with .q.mtx beside it), .dat, .json");
  EXPECT_EQ(complaint_about(folder.file("x.hdf5")),
            folder.file("x.hdf5: no such file or directory"));
  EXPECT_EQ(complaint_about(folder.file("x.hdf5#a")),
            folder.file("x.hdf5: no such file or directory"));
  files::put(folder.file("x.txt"), "{}");
  EXPECT_EQ(complaint_about(folder.file("x.txt")),
            folder.file("x.txt: unknown ending, expected .hdf5, .h5, .M.mtx (with .q.mtx beside "
                        "it), .dat, .json"));
  EXPECT_EQ(complaint_about("/dev/null"), "/dev/null: no such file or directory");
  files::put(folder.file("x.hdf5"), "");
  EXPECT_EQ(complaint_about(folder.file("x.hdf5")),
            folder.file("x.hdf5: the HDF5 library cannot open it, expected a complete HDF5 file"));
}

TEST_F(Load, RefusesToSaveWhatTheEndingDoesNotAllow) {
  for (const char* file : {"x.dat", "x.txt"})
    EXPECT_THROW(save_instances(folder.file(file), {named("x")}), std::invalid_argument) << file;
  EXPECT_THROW(save_instances(folder.file("x.M.mtx"), {named("x"), named("y")}),
               std::invalid_argument);
  EXPECT_THROW(save_instances(folder.file("missing/x.hdf5"), {named("x")}), UnwritableOutput);
  EXPECT_TRUE(folder.empty());
}

// A file cut anywhere, or with any byte changed, is either refused in one line or still holds what
// was written; the child process keeps us alive whatever the HDF5 library makes of it.
class DamagedCorpus : public testing::Test {
 protected:
  DamagedCorpus() {
    Instance frame = make_instance("a/1", cases::with_contacts(), {{"scene", "none"}});
    save_instances(path, {frame, named("a/2")});
    bytes = files::content(path);
    written = load_instances(path);
  }

  /// True if the file was refused.
  bool refuses(const std::string& damaged) {
    files::put(path, damaged);
    try {
      const std::vector<Instance> read = load_instances(path);
      for (const Instance& instance : read) {
        const auto same = [&](const Instance& one) { return one.sha256 == instance.sha256; };
        EXPECT_TRUE(std::any_of(written.begin(), written.end(), same)) << instance.name;
      }
      return false;
    } catch (const UnreadableInput& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return true;
    }
  }

  const files::TemporaryFolder folder;
  const std::string path = folder.file("corpus.hdf5");
  std::string bytes;
  std::vector<Instance> written;
};

TEST_F(DamagedCorpus, IsRefusedWhereverItIsCut) {
  constexpr std::size_t cuts = 20;
  for (std::size_t i = 0; i < cuts; ++i)
    EXPECT_TRUE(refuses(bytes.substr(0, bytes.size() * i / cuts))) << i;
}

TEST_F(DamagedCorpus, NeverYieldsOtherNumbers) {
  std::mt19937 generator(1);
  int refused = 0;
  for (int i = 0; i < 25; ++i) {
    std::string damaged = bytes;
    damaged[generator() % damaged.size()] ^= static_cast<char>(1 << generator() % 8);
    refused += refuses(damaged);
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace lcp
