#include "problems/io/hdf5/corpus.h"

#include <H5Cpp.h>
#include <gtest/gtest.h>

#include <limits>

#include "problems/io/errors.h"
#include "problems/published.h"
#include "tests/problems/cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

std::vector<Instance> all_kinds() {
  Instance contacts = make_instance("frames/0001", cases::with_contacts(),
                                    {{"scene", "two contacts"}, {"empty", ""}});
  contacts.active_contacts = 1;
  contacts.previous = cases::previous_of_contacts();
  Instance options =
      make_instance("options", cases::plain_with_all_options(), {{"note", "two\nlines, \xC3\xA9"}});
  options.known_solution = VectorXd{{-0.0, 2e-300}};
  options.previous = Start{};  // of an empty basis, without a point
  return {contacts, make_instance("frames/0002", cases::plain(), {}), options};
}

/// A file with two instances called a and b, the first with contacts, into whose bowels `change`
/// reaches.
std::string corpus_with(const files::TemporaryFolder& folder,
                        const std::function<void(H5::H5File&)>& change) {
  const std::string path = folder.file("corpus.hdf5");
  Instance contacts = make_instance("a", cases::with_contacts(), {});
  contacts.previous = cases::previous_of_contacts();
  write_corpus(path, {contacts, make_instance("b", cases::plain(), {})});
  H5::H5File file(path, H5F_ACC_RDWR);
  change(file);
  return path;
}

/// What is wrong with such a file, without its name in front.
std::string complaint_about(const std::function<void(H5::H5File&)>& change) {
  const files::TemporaryFolder folder;
  const std::string path = corpus_with(folder, change);
  const std::string message = files::message_of<UnreadableInput>([&] { read_corpus(path); });
  return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
}

void overwrite(H5::H5File& file, const std::string& dataset, Index position, double value) {
  H5::DataSet data = file.openDataSet(dataset);
  std::vector<double> numbers(static_cast<std::size_t>(data.getSpace().getSimpleExtentNpoints()));
  data.read(numbers.data(), H5::PredType::NATIVE_DOUBLE);
  numbers[static_cast<std::size_t>(position)] = value;
  data.write(numbers.data(), H5::PredType::NATIVE_DOUBLE);
}

/// Puts a dataset of these extents, without numbers, in the place of another.
void replace(H5::H5File& file, const std::string& dataset, const std::vector<hsize_t>& extents,
             const H5::DataType& type = H5::PredType::IEEE_F64LE) {
  file.unlink(dataset);
  H5::DSetCreatPropList settings;
  settings.setChunk(static_cast<int>(extents.size()),
                    std::vector<hsize_t>(extents.size(), 2).data());
  file.createDataSet(dataset, type, H5::DataSpace(static_cast<int>(extents.size()), extents.data()),
                     settings);
}

TEST(Hdf5Corpus, GivesBackEveryBitInOrderOfNames) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("corpus.hdf5");
  std::vector<Instance> written = all_kinds();
  write_corpus(path, {written[2], written[1], written[0]});
  const std::vector<Instance> read = read_corpus(path);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) expect_same(written[i], read[i]);
}

TEST(Hdf5Corpus, GivesBackThePublishedInstances) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("published.hdf5");
  std::map<std::string, Instance> written;
  std::vector<Instance> instances;
  for (const PublishedInstance& published : published_instances()) {
    written[published.instance.name] = published.instance;
    instances.push_back(published.instance);
  }
  write_corpus(path, instances);
  const std::vector<Instance> read = read_corpus(path);
  ASSERT_EQ(read.size(), written.size());
  for (const Instance& instance : read) expect_same(written.at(instance.name), instance);
}

TEST(Hdf5Corpus, GivesBackASingleInstanceAndAnEmptyProblem) {
  const files::TemporaryFolder folder;
  Problem empty;
  set_plain_scales(empty);
  for (const Instance& one : {all_kinds()[0], make_instance("empty", empty, {})}) {
    const std::string path = folder.file("one.hdf5");
    write_corpus(path, {one});
    const std::vector<Instance> read = read_corpus(path);
    ASSERT_EQ(read.size(), 1u);
    expect_same(one, read.front());
  }
}

TEST(Hdf5Corpus, PutsTheContactsOfASingleInstanceWhereFclibReadsThem) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("one.hdf5");
  write_corpus(path, {all_kinds()[0]});
  const H5::H5File file(path, H5F_ACC_RDONLY);
  const auto number = [&](const std::string& name) {
    int value = 0;
    file.openDataSet("/fclib_local/" + name).read(&value, H5::PredType::NATIVE_INT);
    return value;
  };
  EXPECT_EQ(number("spacedim"), 3);
  EXPECT_EQ(number("W/m"), 6);
  EXPECT_EQ(number("W/n"), 6);
  EXPECT_EQ(number("W/nz"), -2);
  // 6 on the diagonal, 20 off it (i and j at least 1), and the -0 at (0, 1).
  EXPECT_EQ(number("W/nzmax"), 27);
  std::vector<double> mu(2);
  file.openDataSet("/fclib_local/vectors/mu").read(mu.data(), H5::PredType::NATIVE_DOUBLE);
  EXPECT_EQ(mu, (std::vector<double>{0.6, 0}));
}

TEST(Hdf5Corpus, WritesTheSameBytesAgain) {
  const files::TemporaryFolder folder;
  write_corpus(folder.file("one.hdf5"), all_kinds());
  write_corpus(folder.file("two.hdf5"), all_kinds());
  EXPECT_EQ(files::content(folder.file("one.hdf5")), files::content(folder.file("two.hdf5")));
}

TEST(Hdf5Corpus, ReadsOneInstanceByItsName) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("corpus.hdf5");
  write_corpus(path, all_kinds());
  const std::vector<Instance> read = read_corpus(path, "frames/0002");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read.front().name, "frames/0002");
  EXPECT_EQ(files::message_of<UnreadableInput>([&] { read_corpus(path, "frames"); }),
            path + ": holds no instance called 'frames'");
}

TEST(Hdf5Corpus, RefusesNamesThatAreNoPlaces) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("corpus.hdf5");
  for (const std::string name : {"", "/a", "a/", "a//b", "a/./b", "a#b", "../a"})
    EXPECT_THROW(write_corpus(path, {make_instance(name, cases::plain(), {})}), UnwritableOutput)
        << name;
  const auto names = [&](const std::string& one, const std::string& two) {
    write_corpus(path,
                 {make_instance(one, cases::plain(), {}), make_instance(two, cases::plain(), {})});
  };
  EXPECT_THROW(names("a", "a"), UnwritableOutput);
  EXPECT_THROW(names("a/b", "a"), UnwritableOutput);
  EXPECT_THROW(write_corpus(path, {}), std::invalid_argument);
  EXPECT_TRUE(folder.empty());
  EXPECT_NO_THROW(names("a-b", "a"));
}

TEST(Hdf5Corpus, ReportsATextThatHdf5CannotHold) {
  const files::TemporaryFolder folder;
  const Instance instance =
      make_instance("a", cases::plain(), {{"note", std::string(100'000, 'x')}});
  EXPECT_THROW(write_corpus(folder.file("corpus.hdf5"), {instance}), UnwritableOutput);
  EXPECT_TRUE(folder.empty());
}

TEST(Hdf5Corpus, ReportsContentThatDoesNotFitItsHash) {
  const std::string hash = make_instance("b", cases::plain(), {}).sha256;
  const std::string complaint =
      complaint_about([](H5::H5File& file) { overwrite(file, "/b/M", 0, 4.5); });
  EXPECT_TRUE(complaint.starts_with("/b/sha256: is " + hash + ", but the content has "))
      << complaint;
}

TEST(Hdf5Corpus, ReportsAPreviousSolutionThatIsNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(complaint_about([](H5::H5File& file) {
                overwrite(file, "/a/previous_z", 0, 4.5);
              }).starts_with("/a/previous_sha256: is "));
  EXPECT_EQ(complaint_about([](H5::H5File& file) { overwrite(file, "/a/previous_z", 0, nan); }),
            "/a: previous solution: z is not finite, expected finite numbers");
  EXPECT_EQ(complaint_about([](H5::H5File& file) { overwrite(file, "/a/previous_alpha", 1, 7); }),
            "/a: previous solution: alpha holds row 7, expected 0 ... 6");
  EXPECT_EQ(complaint_about([](H5::H5File& file) { replace(file, "/a/previous_z", {5}); }),
            "/a: previous solution: z has 5 entries, expected 7 or none");
  EXPECT_NE(complaint_about([](H5::H5File& file) {
              replace(file, "/a/previous_alpha", {8}, H5::PredType::STD_I64LE);
            }).find("/a/previous_alpha"),
            std::string::npos);
}

TEST(Hdf5Corpus, ReportsNumbersThatAreNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint_about([](H5::H5File& file) { overwrite(file, "/b/M", 3, nan); }),
            "/b: b: M(1, 0) is nan, expected a finite number");
  EXPECT_EQ(complaint_about(
                [](H5::H5File& file) { overwrite(file, "/a/fclib_local/vectors/q", 0, nan); }),
            "/a: a: vbar(0, 0) is nan, expected a finite number");
}

TEST(Hdf5Corpus, ReportsWrongShapesAndKinds) {
  EXPECT_EQ(complaint_about([](H5::H5File& file) {
              replace(file, "/b/M", {3, 4});
            }),
            "/b/M: is 3 x 4, expected 3 x 3");
  EXPECT_EQ(complaint_about([](H5::H5File& file) { replace(file, "/b/s_z", {5}); }),
            "/b/s_z: is 5, expected 3");
  EXPECT_EQ(complaint_about([](H5::H5File& file) { file.unlink("/b/M"); }),
            "/b/M: is missing, expected a dataset");
  EXPECT_EQ(complaint_about([](H5::H5File& file) {
              replace(file, "/b/M", {3, 3}, H5::StrType(H5::PredType::C_S1, 8));
            }),
            "/b/M: is text, expected real numbers");
  EXPECT_EQ(complaint_about([](H5::H5File& file) { file.unlink("/a/layout"); }),
            "/a/layout: is missing, expected a group");
}

TEST(Hdf5Corpus, AllocatesNothingForExtentsBeyondTheLimit) {
  constexpr hsize_t huge = hsize_t{1} << 40;
  EXPECT_EQ(complaint_about([](H5::H5File& file) { replace(file, "/b/q", {huge}); }),
            "/b/q: is 1099511627776, expected a vector of at most 16384 numbers");
  EXPECT_EQ(complaint_about([](H5::H5File& file) {
              replace(file, "/b/M", {huge, huge});
            }),
            "/b/M: is 1099511627776 x 1099511627776, expected 3 x 3");
  EXPECT_EQ(
      complaint_about([](H5::H5File& file) { replace(file, "/a/fclib_local/vectors/mu", {huge}); }),
      "/a/fclib_local/vectors/mu: is 1099511627776, expected a vector of at most 16384 "
      "numbers");
  EXPECT_EQ(
      complaint_about([](H5::H5File& file) { replace(file, "/a/fclib_local/vectors/mu", {100}); }),
      "/a/fclib_local/vectors/mu: has 100 contacts, expected at most 7");
}

TEST(Hdf5Corpus, ReportsCompressedRowsThatPointNowhere) {
  const auto set_first = [](const std::string& dataset, std::size_t position, int value) {
    return complaint_about([&](H5::H5File& file) {
      H5::DataSet data = file.openDataSet("/a/fclib_local/W/" + dataset);
      std::vector<int> numbers(static_cast<std::size_t>(data.getSpace().getSimpleExtentNpoints()));
      data.read(numbers.data(), H5::PredType::NATIVE_INT);
      numbers[position] = value;
      data.write(numbers.data(), H5::PredType::NATIVE_INT);
    });
  };
  EXPECT_EQ(set_first("i", 0, 6), "/a/fclib_local/W/i: entry 0 is 6, expected 0 ... 5");
  EXPECT_EQ(set_first("i", 0, -1), "/a/fclib_local/W/i: entry 0 is -1, expected 0 ... 5");
  EXPECT_EQ(set_first("p", 1, 1000),
            "/a/fclib_local/W/p: entry 1 is 1000 behind 0, expected ascending numbers up to 27");
  EXPECT_EQ(set_first("p", 6, 28),
            "/a/fclib_local/W/p: goes from 0 to 28, expected from 0 to at most 27");
  EXPECT_EQ(set_first("nzmax", 0, 1 << 30),
            "/a/fclib_local/W/nzmax: is 1073741824, expected 0 ... 36");
  EXPECT_EQ(set_first("nz", 0, -3), "/a/fclib_local/W/nz: is -3, expected -2 ... 36");
}

TEST(Hdf5Corpus, ReportsFilesThatAreNoCorpus) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.hdf5");
  for (const std::string bytes : {"", "this is text, not HDF5"}) {
    files::put(path, bytes);
    EXPECT_EQ(files::message_of<UnreadableInput>([&] { read_corpus(path); }),
              path + ": the HDF5 library cannot open it, expected a complete HDF5 file");
  }
  { H5::H5File(path, H5F_ACC_TRUNC).createGroup("fclib_local"); }
  EXPECT_EQ(files::message_of<UnreadableInput>([&] { read_corpus(path); }),
            path + ": /fclib_local/spacedim: is missing, expected a dataset");
}

/// What h5py makes of a few lines: groups and datasets of any type, attributes of variable length.
class ForeignCorpus : public testing::Test {
 protected:
  template <class Number>
  void put(H5::Group group, const std::string& name, const H5::DataType& type,
           const std::vector<hsize_t>& extents, const std::vector<Number>& numbers,
           const H5::DataType& memory) {
    group.createDataSet(name, type, H5::DataSpace(static_cast<int>(extents.size()), extents.data()))
        .write(numbers.data(), memory);
  }

  void put_plain(H5::Group group) {
    put<double>(group, "M", H5::PredType::IEEE_F32BE, {2, 2}, {2, 1, 0.5, 3},
                H5::PredType::NATIVE_DOUBLE);
    put<int>(group, "q", H5::PredType::STD_I16LE, {2}, {-5, -6}, H5::PredType::NATIVE_INT);
  }

  static void set_attribute(H5::Group group, const std::string& name, const std::string& text) {
    const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
    group.createAttribute(name, type, H5::DataSpace(H5S_SCALAR)).write(type, text);
  }

  std::string complaint() {
    const std::string message = files::message_of<UnreadableInput>([&] { read_corpus(path); });
    return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
  }

  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.hdf5");
};

TEST_F(ForeignCorpus, NeedsOnlyMAndQOfAnyType) {
  {
    H5::H5File file(path, H5F_ACC_TRUNC);
    put_plain(file.createGroup("/a"));
    put_plain(file.openGroup("/"));
  }
  const std::vector<Instance> read = read_corpus(path, "", {}, "stem");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, "stem");
  EXPECT_EQ(read[1].name, "a");
  Problem expected;
  expected.M = MatrixXd{{2, 1}, {0.5, 3}};
  expected.q = VectorXd{{-5, -6}};
  set_plain_scales(expected);
  expect_same(make_instance("a", expected, {}), read[1]);
}

TEST_F(ForeignCorpus, TakesScalesHashAndProvenanceWhereTheyAre) {
  Problem expected;
  expected.M = MatrixXd{{2, 1}, {0.5, 3}};
  expected.q = VectorXd{{-5, -6}};
  set_plain_scales(expected);
  expected.s_z = VectorXd{{0.5, 7}};
  const Instance instance = make_instance("a", expected, {{"scene", "by hand"}, {"time", "3"}});
  const auto write = [&](const std::string& hash) {
    H5::H5File file(path, H5F_ACC_TRUNC);
    H5::Group group = file.createGroup("/a");
    put_plain(group);
    put<double>(group, "s_z", H5::PredType::IEEE_F64LE, {2}, {0.5, 7}, H5::PredType::NATIVE_DOUBLE);
    set_attribute(group, "sha256", hash);
    H5::Group provenance = group.createGroup("provenance");
    set_attribute(provenance, "scene", "by hand");
    const std::int64_t time = 3;
    provenance.createAttribute("time", H5::PredType::STD_I64LE, H5::DataSpace(H5S_SCALAR))
        .write(H5::PredType::NATIVE_INT64, &time);
  };
  write(instance.sha256);
  expect_same(instance, read_corpus(path).front());
  write("0123");
  EXPECT_EQ(complaint(), "/a/sha256: is 0123, but the content has " + instance.sha256);
}

TEST_F(ForeignCorpus, SaysWhatIsMissingOrOfAnotherShape) {
  {
    H5::H5File file(path, H5F_ACC_TRUNC);
    put<int>(file.createGroup("/a"), "M", H5::PredType::STD_I32LE, {1, 1}, {1},
             H5::PredType::NATIVE_INT);
  }
  EXPECT_EQ(complaint(), "/a/q: is missing, expected a vector");
  {
    H5::H5File file(path, H5F_ACC_TRUNC);
    H5::Group group = file.createGroup("/a");
    put_plain(group);
    put<int>(group, "c", H5::PredType::STD_I32LE, {1}, {1}, H5::PredType::NATIVE_INT);
  }
  EXPECT_EQ(complaint(), "/a/c: is 1, expected 2");
}

TEST(Hdf5Corpus, ReportsAFileWithoutInstances) {
  EXPECT_EQ(complaint_about([](H5::H5File& file) {
              file.unlink("/a");
              file.unlink("/b");
            }),
            "holds no instance, expected a group with M and q or with fclib_local");
}

TEST(Hdf5Corpus, ReadsAGroupThatContainsItselfOnce) {
  const files::TemporaryFolder folder;
  const std::string path = corpus_with(folder, [](H5::H5File& file) {
    file.createGroup("/z");
    file.link(H5L_TYPE_HARD, "/", "/z/root");
  });
  EXPECT_EQ(read_corpus(path).size(), 2u);
}

}  // namespace
}  // namespace lcp
