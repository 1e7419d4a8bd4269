#include "harness/studies/frontier/frontier.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/measurement.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/stability/parts.h"
#include "harness/studies/frontier/frontier_pages.h"
#include "solvers/options.h"

namespace lcp::cli {

namespace {

namespace fs = std::filesystem;

struct FrontierArguments {
  std::string family, x, y;
  std::vector<std::string> solvers = {"own"};
  Measurement measurement;  ///< Its limits, dry_run, resume and out.
  FrontierPlan plan;
  std::optional<std::uint64_t> check_seed;
  std::string format = "text";
};

FrontierPlan frontier_plan(const FrontierArguments& arguments) {
  FrontierPlan plan = arguments.plan;
  plan.grid = {arguments.family, parse_axis(arguments.x, "--x"), parse_axis(arguments.y, "--y")};
  check_knobs(plan.grid);
  plan.limits.solvers = make_solvers(arguments.solvers);
  set_limits(plan.limits, arguments.measurement);
  if (plan.max_count < plan.count)
    throw std::invalid_argument(
        fmt::format("--max-count {}: expected at least --count, {}", plan.max_count, plan.count));
  if (arguments.check_seed == plan.seed)
    throw std::invalid_argument(
        fmt::format("--check-seed {} is --seed: name another", *arguments.check_seed));
  return plan;
}

/// The grid's corners and its middle.
std::vector<Instance> sample_of(const FrontierPlan& plan) {
  const std::size_t last_x = plan.grid.x.size() - 1, last_y = plan.grid.y.size() - 1;
  std::vector<Instance> sample;
  for (const std::size_t x : {std::size_t{0}, last_x})
    for (const std::size_t y : {std::size_t{0}, last_y})
      sample.push_back(draw_of_cell(plan.grid, x, y, plan.seed, 0));
  sample.push_back(draw_of_cell(plan.grid, last_x / 2, last_y / 2, plan.seed, 0));
  return sample;
}

/// Seconds that a pair takes, drawing included, going by the sample.
double seconds_per_pair(const FrontierPlan& plan) {
  const auto begin = std::chrono::steady_clock::now();
  RunPlan sample = plan.limits;
  sample.max_samples = 1;
  sample.instances = sample_of(plan);
  run(
      sample, [](const Record&) {}, [](const Progress&) {}, catch_interruptions());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return elapsed.count() / static_cast<double>(sample.instances.size() * sample.solvers.size());
}

/// Cells on stdout, pairs and time on stderr.
int dry_run(const FrontierPlan& plan, bool twice) {
  const std::size_t columns = plan.grid.x.size(), rows = plan.grid.y.size();
  for (std::size_t x = 0; x < columns; ++x)
    for (std::size_t y = 0; y < rows; ++y) fmt::print("{}\n", cell_spelling(plan.grid, x, y));
  const std::size_t solvers = plan.limits.solvers.size();
  const std::size_t least =
      columns * rows * solvers * static_cast<std::size_t>(plan.count) * (twice ? 2 : 1);
  const std::size_t most =
      least / static_cast<std::size_t>(plan.count) * static_cast<std::size_t>(plan.max_count);
  fmt::print(
      stderr, "{} cells, {} solvers, {} draws each{}: {} pairs, at most {} with --max-count {}\n",
      columns * rows, solvers, plan.count, twice ? ", two seeds" : "", least, most, plan.max_count);
  const double seconds = seconds_per_pair(plan);
  fmt::print(
      stderr,
      "expected: {} for these, {} for the most, going by a draw of each corner and the middle\n",
      printed_duration(seconds * static_cast<double>(least)),
      printed_duration(seconds * static_cast<double>(most)));
  return done;
}

/// Draws into `directory`; empty when interrupted.
std::optional<Frontier> draw(const fs::path& directory, const FrontierPlan& plan, bool resume) {
  ProgressBar bar;
  return run_frontier(
      directory, plan, resume ? Existing::resume : Existing::refuse,
      [](const std::string& line) { fmt::print(stderr, "{}\n", line); },
      [&](const Progress& progress) { bar.update(progress); }, catch_interruptions());
}

int frontier(const FrontierArguments& arguments) {
  const FrontierPlan plan = frontier_plan(arguments);
  if (arguments.measurement.dry_run) return dry_run(plan, arguments.check_seed.has_value());
  const fs::path out =
      !arguments.measurement.out.empty()
          ? arguments.measurement.out
          : fmt::format("runs/frontier-{}-{}-{}", parse_spelling(plan.grid.family).name,
                        plan.grid.x.knob, plan.grid.y.knob);
  const bool resume = arguments.measurement.resume;
  std::optional<Frontier> first = draw(out, plan, resume), second;
  if (first && arguments.check_seed) {
    FrontierPlan again = plan;
    again.seed = *arguments.check_seed;
    second = draw(out / fmt::format("seed-{}", again.seed), again, resume);
  }
  if (!first || second.has_value() != arguments.check_seed.has_value())
    return report_interruption("the rows so far", out);
  const FrontierReport report{std::move(*first), std::move(second)};
  write_pages(out, "frontier", described(report), arguments.format);
  fmt::print(stderr, "rows, tables, picture and environment are in {}\n", out.string());
  return done;
}

void frontier_options(CLI::App& page, FrontierArguments& arguments) {
  Measurement& measurement = arguments.measurement;
  FrontierPlan& plan = arguments.plan;
  add(page, "FAMILY", arguments.family, "NAME[:key=value,...] (see: lcpbench list families)")
      ->required();
  add(page, "--x", arguments.x,
      "KNOB=V,V,... or KNOB=FROM..TO/N, a column of cells each; ,log for a geometric axis")
      ->required();
  add(page, "--y", arguments.y, "The same: the knob along which a line is sought")->required();
  add(page, "--solver", arguments.solvers,
      "NAME[:key=value,...], pattern, own or all; repeatable. Default: own");
  add_with_default(page, "--count", plan.count, "Draws of a cell, and how many are added at a time",
                   CLI::Range(Index{1}, most_draws));
  add_with_default(page, "--max-count", plan.max_count,
                   "Draws of a cell at most, where a line is not known well enough",
                   CLI::Range(Index{1}, most_draws));
  add_with_default(
      page, "--band", plan.band,
      "Widest band asked for on a geometric y, in decades; a step of the grid will do too",
      CLI::PositiveNumber);
  add_with_default(page, "--seed", plan.seed, "Same seed, same draws");
  add(page, "--check-seed", arguments.check_seed,
      "Repeat it with this seed, and say how many columns agree");
  add_limits(page, measurement);
  add_with_default(page, "--format", arguments.format, "text, csv (a line per cell) or json",
                   CLI::IsMember({"text", "csv", "json"}));
  page.add_flag("--dry-run", measurement.dry_run,
                "Print the cells, the pairs (draw, solver) and the time expected");
  page.add_flag("--resume", measurement.resume, "Go on with the rows that DIR holds");
  add(page, "--out", measurement.out,
      "Directory for rows, tables and picture; default: runs/frontier-FAMILY-X-Y");
}

}  // namespace

Verb add_stability_frontier(CLI::App& stability) {
  return make_verb<FrontierArguments>(
      stability, "frontier",
      "Where in the plane of two knobs of a family each solver stops solving", frontier_options,
      frontier,
      "Writes DIR/{run.json, env.json, rows.jsonl, frontier.txt, frontier.csv, frontier.json, "
      "frontier.svg}.\n"
      "Example:\n"
      "  lcpbench stability frontier stack --x mu=0.1,0.5,1 --y mass_ratio=1..1000/7,log "
      "--check-seed 2");
}

}  // namespace lcp::cli
