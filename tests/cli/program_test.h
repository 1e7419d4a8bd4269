#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {

/// Runs the program as its user does, in a directory of the test's own.
class ProgramTest : public testing::Test {
 protected:
  /// With words that stand before the arguments of every run: a verb.
  explicit ProgramTest(std::vector<std::string> verb = {}) : verb_(std::move(verb)) {}

  Ran run(const std::vector<std::string>& arguments, const std::string& interrupt_when = "") {
    return run_other(LCPBENCH, arguments, interrupt_when);
  }
  /// The same of another program.
  Ran run_other(const std::string& program, std::vector<std::string> arguments,
                const std::string& interrupt_when = "") {
    arguments.insert(arguments.begin(), verb_.begin(), verb_.end());
    return run_program(program, arguments, directory_.path(), interrupt_when);
  }

  /// Expects the status and a single line on stderr that holds `words`.
  template <class... Words>
  static void expect_complaint(const Ran& ran, int status, const Words&... words) {
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    for (const std::string& word : {std::string(words)...})
      EXPECT_NE(ran.err.find(word), std::string::npos) << word << " in: " << ran.err;
  }
  /// The same of a run that prints nothing on stdout; the line begins with the program's name.
  template <class... Words>
  void expect_complaint(const std::vector<std::string>& arguments, int status,
                        const Words&... words) {
    const Ran ran = run(arguments);
    expect_complaint(ran, status, words...);
    EXPECT_EQ(ran.err.rfind("lcpbench", 0), 0u) << ran.err;
    EXPECT_EQ(ran.out, "");
  }

  const std::string& directory() const { return directory_.path(); }
  std::string file(const std::string& name) const { return directory_.file(name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(file(name)); }
  /// Lines of rows.jsonl of a run.
  std::ptrdiff_t rows(const std::string& run_directory) const {
    const std::string text = read_text(file(run_directory + "/rows.jsonl"));
    return std::count(text.begin(), text.end(), '\n');
  }

 private:
  std::vector<std::string> verb_;
  TemporaryDirectory directory_;
};

}  // namespace lcp
