#include "harness/cli/measurement.h"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "harness/cli/interrupt.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/reading.h"
#include "harness/cli/start.h"
#include "harness/cli/verbs.h"
#include "harness/runs/history.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/sheet/sheet_files.h"
#include "harness/studies/suites.h"
#include "harness/studies/table/table.h"

namespace lcp::cli {

namespace {

std::vector<Instance> load(const std::vector<std::string>& corpora, const ReadOptions& reading) {
  std::vector<Instance> all;
  for (const std::string& corpus : corpora) {
    std::vector<Instance> loaded = read_instances(corpus, reading);
    std::move(loaded.begin(), loaded.end(), std::back_inserter(all));
  }
  return all;
}

/// The pairs to be run on stdout, how long they should take on stderr.
void print_pairs(const RunPlan& plan) {
  const std::vector<PairKey> pairs = open_pairs(plan);
  for (const PairKey& pair : pairs)
    fmt::print("{} {}{}\n", pair.instance, pair.solver,
               plan.starts.size() > 1 ? " " + pair.start : "");
  fmt::print(stderr, "{} instances, {} solvers, {}{} pairs to run\n", plan.instances.size(),
             plan.solvers.size(),
             plan.starts.size() > 1 ? fmt::format("{} starts, ", plan.starts.size()) : "",
             pairs.size());
  const Forecast expected = forecast(plan, past_runs({"runs"}));
  if (expected.known > 0)
    fmt::print(stderr, "expected: {} for {} of them, going by past runs below runs/\n",
               printed_duration(expected.seconds), expected.known);
  if (expected.unknown > 0)
    fmt::print(stderr,
               "{} that no run below runs/ has measured: at most {} (the time limit of each)\n",
               expected.unknown, printed_duration(expected.most_seconds));
}

}  // namespace

void add_limits(CLI::App& page, Measurement& measurement) {
  add_with_default(page, "--tolerance", measurement.tolerance,
                   "Largest natural residual (scaled) that counts as solved", CLI::PositiveNumber);
  add_with_default(page, "--timeout", measurement.timeout,
                   "Of one solve: number with ms, s or min");
  add_with_default(page, "--memory", measurement.memory,
                   "Resident memory of a worker: number with KiB, MiB or GiB");
  add_with_default(page, "--jobs", measurement.jobs,
                   "Pairs solved at the same time; disturbs the times", CLI::Range(1, 1024));
  add(page, "--max-contacts", measurement.max_contacts,
      "Larger instances become not-run rows. Default: the suite's, or 60", CLI::NonNegativeNumber);
}

void set_limits(RunPlan& plan, const Measurement& measurement) {
  plan.timeout = parse_duration(measurement.timeout, "--timeout");
  plan.memory_bytes = parse_bytes(measurement.memory, "--memory");
  plan.tolerance = measurement.tolerance;
  plan.jobs = measurement.jobs;
  if (measurement.max_contacts) plan.max_contacts = *measurement.max_contacts;
}

void add_options(CLI::App& page, Measurement& measurement) {
  CLI::Option* suite =
      add(page, "--suite", measurement.suite, "Suite of instances (see: lcpbench list suites)");
  page.add_option("--corpus", measurement.corpora,
                  "Instances instead of a suite: FILE, FILE#NAME or directory, repeatable")
      ->excludes(suite);
  add_reading_option(page, measurement.reading);
  add_start_option(page, measurement.starts);
  add_limits(page, measurement);
  CLI::Option* limit = add(page, "--limit", measurement.limit,
                           "Only the first K instances of each corpus", CLI::PositiveNumber);
  add(page, "--every", measurement.every, "Only every K-th instance of each corpus",
      CLI::PositiveNumber)
      ->excludes(limit);
  page.add_flag("--dry-run", measurement.dry_run,
                "Print the pairs (instance, solver) that would be run and the expected time");
  add_with_default(page, "--shard", measurement.shard,
                   "I/N: only the I-th of N parts; lcpbench merge joins them");
  page.add_flag("--resume", measurement.resume,
                "Go on with what DIR holds: run the pairs without a row");
  add(page, "--out", measurement.out, "Directory for rows, table, sheet and pictures");
}

std::string suite_name(const Measurement& measurement) {
  if (!measurement.suite.empty()) return measurement.suite;
  return measurement.corpora.empty() ? "default" : "";
}

RunPlan make_plan(const Measurement& measurement, std::vector<NamedSolver> solvers) {
  RunPlan plan;
  set_limits(plan, measurement);
  plan.starts = start_kinds(measurement.starts);
  plan.solvers = std::move(solvers);
  plan.shard = parse_shard(measurement.shard);
  const std::string suite = suite_name(measurement);
  if (!measurement.max_contacts && !suite.empty())
    plan.max_contacts = find_suite(suite).max_contacts;
  plan.instances = thinned(
      suite.empty() ? load(measurement.corpora, measurement.reading) : generate(find_suite(suite)),
      measurement.every, measurement.limit);
  return plan;
}

int measure(const Measurement& measurement, std::vector<NamedSolver> solvers,
            const std::string& default_out) {
  RunPlan plan = make_plan(measurement, std::move(solvers));
  const std::size_t pairs = open_pairs(plan).size();
  const std::string out =
      !measurement.out.empty() ? measurement.out
      : plan.shard.count > 1
          ? fmt::format("{}-{}of{}", default_out, plan.shard.index + 1, plan.shard.count)
          : default_out;
  if (measurement.dry_run) {
    if (measurement.resume) plan.done = pairs_done(out);
    print_pairs(plan);
    return done;
  }
  const std::atomic<bool>& interrupted = catch_interruptions();
  const Origin origin{suite_name(measurement), measurement.corpora, measurement.every,
                      measurement.limit};
  RunReport report;
  {
    ProgressBar bar;
    report = run_into(
        out, plan, origin, measurement.resume ? Existing::resume : Existing::refuse,
        [](const std::string& line) { fmt::print(stderr, "{}\n", line); },
        [&](const Progress& progress) { bar.update(progress); }, interrupted);
  }
  if (measurement.resume)
    fmt::print(stderr, "{} rows were there, {} are new\n", report.rows_before, report.rows);
  if (interrupted) {
    fmt::print(stderr,
               "interrupted: {} of {} rows are in {}; the same command with --resume goes on\n",
               report.rows_before + report.rows, pairs, out);
    return interrupted_by_user;
  }
  fmt::print("{}", render(write_tables(out), TableFormat::text));
  std::fflush(stdout);  // the table stands, whatever becomes of the pictures
  write_sheet(out, {}, out);
  fmt::print(stderr, "rows, table, sheet, pictures and environment are in {}\n", out);
  return done;
}

}  // namespace lcp::cli
