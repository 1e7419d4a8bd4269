// Damaged files of every format, loaded as the program loads them: each gives instances that pass
// check() or one line, and this process survives. LCPBENCH_DAMAGED_FILES says how many of each kind;
// the fast tests try a hundred, test_corruption ten thousand. A file that breaks a rule is kept and
// named with its seed; after a crash it is the one left in the temporary folder.
//
// Every HDF5 file gets a child process of its own, as in the program: 10,000 forks take some minutes
// with sanitizers, and putting many files into one child would no longer test what the program does.

#include "tests/problems/io/corruption.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "problems/contact/friction_lcp.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/fclib_local.h"
#include "problems/io/load.h"
#include "tests/problems/cases.h"
#include "tests/problems/contact/contact_cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/text/siconos_files.h"

namespace lcp {
namespace {

constexpr std::uint64_t first_seed = 20080101;

/// A kind of file: how it ends, how to write a sound one, and which of its files is damaged.
struct Kind {
  const char* name;
  const char* file;
  std::function<void(const std::string&)> write;
  const char* other_file = nullptr;  ///< Where there are two, each is damaged in its turn.

  friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }
};

Problem two_contacts() {
  cases::Uniform uniform(3);
  return friction_lcp(cases::random_contacts({0.3, 0}, 10, uniform), {.directions = 4});
}

void save(const std::string& path, const Problem& problem) {
  Instance instance = make_instance("a", problem, {{"scene", "none"}});
  save_instances(path, {instance});
}

void save_fclib(const std::string& path) {
  H5::H5File file(path, H5F_ACC_TRUNC);
  H5::Group root = file.openGroup("/");
  write_fclib_local(root, *two_contacts().friction);
}

std::function<void(const std::string&)> text(const char* text) {
  return [text](const std::string& path) { files::put(path, text); };
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"Hdf5Plain", "x.hdf5", [](auto& path) { save(path, cases::plain()); }},
      {"Hdf5Friction", "x.hdf5", [](auto& path) { save(path, two_contacts()); }},
      {"Hdf5Fclib", "x.hdf5", save_fclib},
      {"MatrixMarket", "x.M.mtx", [](auto& path) { save(path, cases::plain()); }, "x.q.mtx"},
      {"SiconosLcpDense", "x.dat", text(siconos::dense_lcp)},
      {"SiconosLcpBlocks", "x.dat", text(siconos::block_lcp)},
      {"SiconosContactDense", "x.dat", text(siconos::dense_contact)},
      {"SiconosContactBlocks", "x.dat", text(siconos::block_contact)},
      {"SiconosContactCompressed", "x.dat", text(siconos::compressed_contact)},
      {"JsonPlain", "x.json", [](auto& path) { save(path, cases::plain_with_all_options()); }},
      {"JsonFriction", "x.json", [](auto& path) { save(path, two_contacts()); }},
  };
  return all;
}

class DamagedFiles : public testing::TestWithParam<Kind> {};

/// What breaks the rules about the file at `path`; empty if nothing does. Counts what was loaded.
std::string offence(const std::string& path, int& loaded) {
  try {
    const std::vector<Instance> instances = load_instances(path);
    for (const Instance& instance : instances) check(instance.problem, instance.name);
    ++loaded;
    return instances.empty() ? "no instance" : "";
  } catch (const UnreadableInput& error) {
    const std::string message = error.what();
    const bool one_line = message.find_first_of("\r\n") == std::string::npos;
    return one_line && message.find(": ") != std::string::npos ? "" : message;
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST_P(DamagedFiles, GiveSoundInstancesOrOneLine) {
  const Kind& kind = GetParam();
  const files::TemporaryFolder folder;
  const std::string path = folder.file(kind.file);
  kind.write(path);
  std::vector<std::string> names = {kind.file};
  if (kind.other_file != nullptr) names.push_back(kind.other_file);
  int loaded = 0;
  ASSERT_EQ(offence(path, loaded), "");
  ASSERT_EQ(loaded, 1);
  loaded = 0;
  std::vector<std::string> sound;
  for (const std::string& name : names) sound.push_back(files::content(folder.file(name)));
  for (std::uint64_t i = 0; i < LCPBENCH_DAMAGED_FILES; ++i) {
    const std::size_t which = i % names.size();
    files::put(folder.file(names[which]), corruption::damaged(sound[which], first_seed + i));
    const std::string wrong = offence(path, loaded);
    if (!wrong.empty()) {
      const auto kept = std::filesystem::temp_directory_path() /
                        (std::string("lcpbench-damaged-") + kind.name + "-" + names[which]);
      std::filesystem::copy_file(folder.file(names[which]), kept,
                                 std::filesystem::copy_options::overwrite_existing);
      FAIL() << "seed " << first_seed + i << ", kept as " << kept << ": " << wrong;
    }
    files::put(folder.file(names[which]), sound[which]);
  }
  std::cout << kind.name << ": " << loaded << " loaded, " << LCPBENCH_DAMAGED_FILES - loaded
            << " refused\n";
  EXPECT_LT(loaded, LCPBENCH_DAMAGED_FILES);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, DamagedFiles, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace lcp
