#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "problems/io/read_options.h"

namespace lcp::cli {

/// Options that `run` and `sweep` have in common: on which instances, how far, and where the rows go.
struct Measurement {
  std::string suite;
  std::vector<std::string> corpora;
  ReadOptions reading;
  std::vector<std::string> starts = {"cold"};
  double tolerance = 1e-6;
  std::string timeout = "10s";
  std::string memory = "2GiB";
  int jobs = 1;
  std::optional<Index> max_contacts;  ///< The suite's, or 60, where it is not given.
  Index limit = 0;
  Index every = 1;
  bool dry_run = false;
  bool resume = false;
  std::string shard = "1/1";
  std::string out;
};

/// Adds --tolerance, --timeout, --memory, --jobs and --max-contacts to a verb's page.
void add_limits(CLI::App& page, Measurement& measurement);
/// Sets the same in its plan; max_contacts is left alone where it is not given. Throws
/// std::invalid_argument.
void set_limits(RunPlan& plan, const Measurement& measurement);

/// Adds the options of `measurement` to a verb's page.
void add_options(CLI::App& page, Measurement& measurement);

/// Name of the suite to run: the default one where neither suite nor corpus is given, else empty.
std::string suite_name(const Measurement& measurement);

/// The plan of measuring `solvers` on the instances asked for. Throws std::invalid_argument and
/// UnreadableInput.
RunPlan make_plan(const Measurement& measurement, std::vector<NamedSolver> solvers);

/// Measures `solvers` on the instances asked for, writes the run directory (`out`, or `default_out`)
/// and prints the table; or, with dry_run, prints the pairs. Returns an ExitStatus.
int measure(const Measurement& measurement, std::vector<NamedSolver> solvers,
            const std::string& default_out);

}  // namespace lcp::cli
