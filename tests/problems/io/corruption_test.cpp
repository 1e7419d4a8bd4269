// Damaged files of every format, loaded as the program loads them: each gives instances that pass
// check() or one line, and this process survives. The environment's LCPBENCH_DAMAGED_FILES says how
// many of each kind: a hundred unless it is set; the slow tests set ten thousand. A file that breaks a rule is kept and
// named with its seed; after a crash it is the one left in the temporary folder.
//
// The program reads every HDF5 file in a child process of its own. Here one child takes a batch of
// them, since with sanitizers a fork costs 13 ms and reading a file 2: it reads as the program's child
// does and unpacks as its parent does, so that what breaks either breaks the batch. The files of a
// broken batch are then loaded one by one as the program would.

#include "tests/problems/io/corruption.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "problems/contact/friction_lcp.h"
#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/corpus.h"
#include "problems/io/hdf5/fclib_local.h"
#include "problems/io/instance_image.h"
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
  bool in_batches = false;

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

/// Nothing but the numbers and names, so that changed ones are found by checks and not by a hash.
constexpr const char* json_without_hash = R"({"instances": [
  {"name": "a", "M": [[4, -0.25], [1e-3, 5]], "q": [-1, 0.5], "s_z": [1, 2], "c": [1, 1],
   "known_solution": [0.25, 0], "pivot_limit": 7, "provenance": {"scene": "none"}},
  {"name": "b", "q": [-1], "M": [[2]]}]})";

std::function<void(const std::string&)> text(const char* text) {
  return [text](const std::string& path) { files::put(path, text); };
}

Kind hdf5(const char* name, std::function<void(const std::string&)> write) {
  return {name, "x.hdf5", std::move(write), nullptr, true};
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      hdf5("Hdf5Plain", [](auto& path) { save(path, cases::plain()); }),
      hdf5("Hdf5Friction", [](auto& path) { save(path, two_contacts()); }),
      hdf5("Hdf5Fclib", save_fclib),
      {"MatrixMarket", "x.M.mtx", [](auto& path) { save(path, cases::plain()); }, "x.q.mtx"},
      {"SiconosLcpDense", "x.dat", text(siconos::dense_lcp)},
      {"SiconosLcpBlocks", "x.dat", text(siconos::block_lcp)},
      {"SiconosContactDense", "x.dat", text(siconos::dense_contact)},
      {"SiconosContactBlocks", "x.dat", text(siconos::block_contact)},
      {"SiconosContactCompressed", "x.dat", text(siconos::compressed_contact)},
      {"JsonWithoutHash", "x.json", text(json_without_hash)},
      {"JsonFriction", "x.json", [](auto& path) { save(path, two_contacts()); }},
  };
  return all;
}

class DamagedFiles : public testing::TestWithParam<Kind> {};

struct Count {
  std::uint64_t loaded = 0;
  std::uint64_t refused = 0;
  std::uint64_t fatal = 0;  ///< Of the refused: those that end the child process.
};

using Load = std::function<std::vector<Instance>()>;

/// What breaks the rules about a file; empty if nothing does.
std::string offence(const Load& load, Count& count) {
  try {
    const std::vector<Instance> instances = load();
    for (const Instance& instance : instances) check(instance.problem, instance.name);
    ++count.loaded;
    return instances.empty() ? "no instance" : "";
  } catch (const UnreadableInput& error) {
    const std::string message = error.what();
    ++count.refused;
    count.fatal += message.find(": reading it with the HDF5 library: ") != std::string::npos;
    const bool one_line = message.find_first_of("\r\n") == std::string::npos;
    return one_line && message.find(": ") != std::string::npos ? "" : message;
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// The sound files of a kind, damaged and loaded.
class Trial {
 public:
  explicit Trial(const Kind& kind) : kind_(kind), path_(folder_.file(kind.file)) {
    kind.write(path_);
    names_.push_back(kind.file);
    if (kind.other_file != nullptr) names_.push_back(kind.other_file);
    for (const std::string& name : names_) sound_.push_back(files::content(folder_.file(name)));
  }

  std::string offence_of_the_sound_file() {
    Count here;
    const std::string wrong = offence([&] { return load_instances(path_); }, here);
    return wrong.empty() && here.loaded == 0 ? "refused" : wrong;
  }

  /// The first offence among damaged files begin ... end - 1.
  std::string run(std::uint64_t begin, std::uint64_t end) {
    if (kind_.in_batches && batch_passes(begin, end)) return "";
    for (std::uint64_t i = begin; i < end; ++i) {
      const std::size_t which = i % names_.size();
      damage(i);
      const std::string wrong = offence([&] { return load_instances(path_); }, count);
      if (!wrong.empty()) return fmt::format("seed {}, {}: {}", first_seed + i, keep(which), wrong);
      files::put(folder_.file(names_[which]), sound_[which]);
    }
    return "";
  }

  Count count;

 private:
  void damage(std::uint64_t i) {
    const std::size_t which = i % names_.size();
    files::put(folder_.file(names_[which]), corruption::damaged(sound_[which], first_seed + i));
  }

  bool batch_passes(std::uint64_t begin, std::uint64_t end) {
    const auto read = [&] { return from_image(to_image(read_corpus(path_))); };
    const auto all = [&] {
      Count here;
      for (std::uint64_t i = begin; i < end; ++i) {
        damage(i);
        if (!offence(read, here).empty()) throw std::runtime_error("an offence");
      }
      return fmt::format("{}", here.loaded);
    };
    try {
      const std::uint64_t loaded = std::stoull(try_in_child("a batch", batch_seconds, all));
      count.loaded += loaded;
      count.refused += end - begin - loaded;
      return true;
    } catch (const UnreadableInput&) {
      return false;
    }
  }

  std::string keep(std::size_t which) const {
    const auto kept = std::filesystem::temp_directory_path() /
                      fmt::format("lcpbench-damaged-{}-{}", kind_.name, names_[which]);
    std::filesystem::copy_file(folder_.file(names_[which]), kept,
                               std::filesystem::copy_options::overwrite_existing);
    return "kept as " + kept.string();
  }

  static constexpr unsigned batch_seconds = 300;

  const Kind& kind_;
  const files::TemporaryFolder folder_;
  const std::string path_;
  std::vector<std::string> names_, sound_;
};

TEST_P(DamagedFiles, GiveSoundInstancesOrOneLine) {
  const char* wanted = std::getenv("LCPBENCH_DAMAGED_FILES");
  const std::uint64_t files = wanted != nullptr ? std::stoull(wanted) : 100, batch = 50;
  Trial trial(GetParam());
  ASSERT_EQ(trial.offence_of_the_sound_file(), "");
  for (std::uint64_t begin = 0; begin < files; begin += batch)
    ASSERT_EQ(trial.run(begin, std::min(files, begin + batch)), "");
  const Count& count = trial.count;
  std::cout << fmt::format("{}: {} loaded, {} refused, {} of them ended the child\n",
                           GetParam().name, count.loaded, count.refused, count.fatal);
  EXPECT_EQ(count.loaded + count.refused, files);
  EXPECT_GT(count.refused, 0u);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, DamagedFiles, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace lcp
