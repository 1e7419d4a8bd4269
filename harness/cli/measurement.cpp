#include "harness/cli/measurement.h"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "harness/cli/interrupt.h"
#include "harness/cli/quantity.h"
#include "harness/cli/reading.h"
#include "harness/cli/verbs.h"
#include "harness/progress.h"
#include "harness/run_directory.h"
#include "harness/suites.h"
#include "problems/io/load.h"

namespace lcp::cli {

namespace {

std::vector<Instance> load(const std::vector<std::string>& corpora, const ReadOptions& reading) {
  std::vector<Instance> all;
  for (const std::string& corpus : corpora) {
    std::vector<Instance> loaded = load_instances(
        corpus, [](const std::string& line) { fmt::print(stderr, "left out: {}\n", line); },
        reading);
    std::move(loaded.begin(), loaded.end(), std::back_inserter(all));
  }
  return all;
}

RunPlan make_plan(const Measurement& measurement, std::vector<NamedSolver> solvers) {
  RunPlan plan;
  plan.timeout = parse_duration(measurement.timeout, "--timeout");
  plan.memory_bytes = parse_bytes(measurement.memory, "--memory");
  plan.tolerance = measurement.tolerance;
  plan.jobs = measurement.jobs;
  plan.max_contacts = measurement.max_contacts;
  plan.solvers = std::move(solvers);
  const std::string suite = suite_name(measurement);
  plan.instances = thinned(
      suite.empty() ? load(measurement.corpora, measurement.reading) : generate(find_suite(suite)),
      measurement.every, measurement.limit);
  return plan;
}

void print_pairs(const RunPlan& plan) {
  for (const Instance& instance : plan.instances)
    for (const NamedSolver& solver : plan.solvers)
      fmt::print("{} {}\n", instance.name, solver.spelling);
  fmt::print(stderr, "{} instances, {} solvers, {} pairs\n", plan.instances.size(),
             plan.solvers.size(), plan.instances.size() * plan.solvers.size());
}

}  // namespace

void add_options(CLI::App& page, Measurement& measurement) {
  CLI::Option* suite = page.add_option("--suite", measurement.suite,
                                       "Suite of instances (see: lcpbench list suites)");
  page.add_option("--corpus", measurement.corpora,
                  "Instances instead of a suite: FILE, FILE#NAME or directory, repeatable")
      ->excludes(suite);
  add_reading_option(page, measurement.reading);
  page.add_option("--start", measurement.start, "Starting basis")
      ->check(CLI::IsMember({"cold"}))
      ->capture_default_str();
  page.add_option("--tolerance", measurement.tolerance,
                  "Largest natural residual (scaled) that counts as solved")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page.add_option("--timeout", measurement.timeout, "Of one solve: number with ms, s or min")
      ->capture_default_str();
  page.add_option("--memory", measurement.memory,
                  "Resident memory of a worker: number with KiB, MiB or GiB")
      ->capture_default_str();
  page.add_option("--jobs", measurement.jobs, "Pairs solved at the same time; disturbs the times")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  page.add_option("--max-contacts", measurement.max_contacts,
                  "Larger instances become not-run rows")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  CLI::Option* limit =
      page.add_option("--limit", measurement.limit, "Only the first K instances of each corpus")
          ->check(CLI::PositiveNumber);
  page.add_option("--every", measurement.every, "Only every K-th instance of each corpus")
      ->check(CLI::PositiveNumber)
      ->excludes(limit);
  page.add_flag("--dry-run", measurement.dry_run, "Print the pairs (instance, solver) and stop");
  page.add_option("--out", measurement.out, "New directory for rows, table and chart");
}

std::string suite_name(const Measurement& measurement) {
  if (!measurement.suite.empty()) return measurement.suite;
  return measurement.corpora.empty() ? "default" : "";
}

int measure(const Measurement& measurement, std::vector<NamedSolver> solvers,
            const std::string& default_out) {
  const RunPlan plan = make_plan(measurement, std::move(solvers));
  if (measurement.dry_run) {
    print_pairs(plan);
    return done;
  }
  const std::string out = measurement.out.empty() ? default_out : measurement.out;
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::size_t rows = 0;
  {
    ProgressBar bar;
    rows = run_into(
        out, plan, [&](const Progress& progress) { bar.update(progress); }, interrupted);
  }
  if (interrupted) {
    fmt::print(stderr, "interrupted: {} of {} rows are in {}; lcpbench table {} counts them\n",
               rows, plan.instances.size() * plan.solvers.size(), out, out);
    return interrupted_by_user;
  }
  fmt::print("{}", render(write_tables(out), TableFormat::text));
  std::fflush(stdout);  // the table stands, whatever becomes of the chart
  write_chart(out);
  fmt::print(stderr, "rows, table, chart and environment are in {}\n", out);
  return done;
}

}  // namespace lcp::cli
