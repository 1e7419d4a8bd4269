#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/studies/paper/reproduce.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {

/// A small table of the paper, made in a directory of its own.
class ReproductionTest : public testing::Test {
 protected:
  ReproductionTest(PaperPlan plan, std::string directory)
      : plan_(std::move(plan)), name_(std::move(directory)) {}

  std::optional<PaperTable> run(const PaperPlan& plan) {
    return reproduce(plan, how(), interrupted_);
  }
  std::optional<PaperTable> run() { return run(plan_); }
  std::vector<std::string> missing(const PaperPlan& plan) { return missing_work(plan, how()); }
  std::vector<std::string> missing() { return missing(plan_); }
  Reproduction how() {
    Reproduction reproduction;
    reproduction.directory = path();
    return reproduction;
  }
  std::filesystem::path path() const { return directory_.file(name_); }
  /// When each simulation's file was written.
  std::map<std::filesystem::path, std::filesystem::file_time_type> written() const {
    std::map<std::filesystem::path, std::filesystem::file_time_type> times;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path() / "loop"))
      if (entry.path().extension() == ".json") times[entry.path()] = entry.last_write_time();
    return times;
  }
  std::atomic<bool> interrupted_ = false;

 private:
  PaperPlan plan_;
  std::string name_;
  TemporaryDirectory directory_;
};

}  // namespace lcp
