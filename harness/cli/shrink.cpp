#include "harness/studies/shrink/shrink.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "harness/cli/interrupt.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/reading.h"
#include "harness/cli/verbs.h"
#include "problems/io/errors.h"
#include "problems/io/load.h"

namespace lcp::cli {

namespace {

struct ShrinkArguments {
  std::string where;
  ReadOptions reading;
  std::string solver;
  std::string keep = "verdict";
  bool solvable = true;
  std::string reference = "best-first";
  bool by_rounding = false;
  double tolerance = 1e-6;
  std::string timeout = "10s", memory = "2GiB";
  Index max_solves = 20000;
  std::string out;
};

std::optional<PathRule> rule_to_keep(const ShrinkArguments& arguments) {
  if (!arguments.by_rounding) return std::nullopt;
  const std::optional<PathRule> rule = path_rule(make_solver(arguments.solver));
  if (!rule)
    throw std::invalid_argument(fmt::format(
        "--by-rounding: the rule of '{}' is not known in 113 bits, expected lemke, lemke-revised, "
        "lexicographic, lexicographic-pivot or lexicographic-revised",
        arguments.solver));
  return rule;
}

Invariant invariant_of(const ShrinkArguments& arguments) {
  return {.solver = make_solver(arguments.solver),
          .keep = arguments.keep == "failure" ? Invariant::Keep::failure : Invariant::Keep::verdict,
          .solvable = arguments.solvable,
          .reference = make_solver(arguments.reference),
          .by_rounding = rule_to_keep(arguments),
          .tolerance = arguments.tolerance};
}

std::string fared(const Trial& trial) {
  return fmt::format("{}{}, residual {:.2e}, {} pivots", to_string(trial.verdict),
                     trial.unclaimed ? " (although its z passes)" : "", trial.residual,
                     trial.pivots);
}

void print(const Shrunk& shrunk, const Instance& parent, const Invariant& invariant) {
  fmt::print("{} from {}\n", shrunk.instance.name, parent.name);
  for (const Reduction& each : shrunk.reductions)
    fmt::print("  {:<11} {:>4} -> {}\n", each.what, each.from, each.to);
  fmt::print("  {}\n    before    {}\n    after     {}\n", invariant.solver.spelling,
             fared(shrunk.before), fared(shrunk.after));
  fmt::print("  {:<11} {}\n", "reference",
             invariant.solvable
                 ? fmt::format("{}: {}", invariant.reference.spelling, fared(shrunk.reference))
                 : "none asked for: no solution known");
  fmt::print("  {:<11} {}; {}\n", "solves", shrunk.solves,
             shrunk.minimal ? "nothing more can be taken away" : "stopped: more may go");
}

/// Before the work is done rather than after.
void require_place(const std::string& out) {
  check_ending(out);
  const std::filesystem::path directory = std::filesystem::absolute(out).parent_path();
  if (!std::filesystem::is_directory(directory))
    throw UnwritableOutput(fmt::format("{}: no such directory", directory.string()));
}

int shrink_instance(const ShrinkArguments& arguments) {
  const Invariant invariant = invariant_of(arguments);
  ShrinkOptions options;
  options.limits = {parse_duration(arguments.timeout, "--timeout"),
                    parse_bytes(arguments.memory, "--memory")};
  options.max_solves = arguments.max_solves;
  require_place(arguments.out);
  const Instance parent = read_instance(arguments.where, arguments.reading);
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::optional<ProgressBar> bar(std::in_place);
  options.progress = [&](Index solves) {
    bar->update({static_cast<std::size_t>(solves), static_cast<std::size_t>(options.max_solves),
                 "solves, at most"});
  };
  const Shrunk shrunk = shrink(parent, invariant, options, interrupted);
  bar.reset();
  if (shrunk.after.verdict == Verdict::timeout || shrunk.after.verdict == Verdict::memory)
    fmt::print(stderr, "a {} depends on the machine: elsewhere something else may be left\n",
               to_string(shrunk.after.verdict));
  save_instances(arguments.out, {shrunk.instance});
  print(shrunk, parent, invariant);
  std::fflush(stdout);
  fmt::print(stderr, "{}it is in {}\n", interrupted ? "interrupted, the smallest so far: " : "",
             arguments.out);
  return interrupted ? interrupted_by_user : done;
}

void shrink_options(CLI::App& page, ShrinkArguments& arguments) {
  add(page, "INSTANCE", arguments.where, "FILE of one instance, or FILE#NAME")->required();
  add(page, "--solver", arguments.solver, "NAME[:key=value,...] that fails on it")->required();
  add_with_default(page, "--keep", arguments.keep,
                   "What has to stay: the same verdict, or any failure",
                   CLI::IsMember({"verdict", "failure"}));
  page.add_flag("--solvable,!--no-solvable", arguments.solvable,
                "Only what the reference solves and z = 0 does not (the default), or anything");
  add_with_default(page, "--reference", arguments.reference,
                   "NAME[:key=value,...] that shows what is left to have a solution");
  page.add_flag("--by-rounding", arguments.by_rounding,
                "Only what the same rule solves in 113 bits (lemke*, lexicographic*)");
  add_with_default(page, "--tolerance", arguments.tolerance,
                   "Largest natural residual (scaled) that counts as solved", CLI::PositiveNumber);
  add_with_default(page, "--timeout", arguments.timeout, "Of one solve: number with ms, s or min");
  add_with_default(page, "--memory", arguments.memory,
                   "Resident memory of a worker: number with KiB, MiB or GiB");
  add_with_default(page, "--max-solves", arguments.max_solves,
                   "Solves of both solvers before what is left is taken as it is",
                   CLI::PositiveNumber);
  add(page, "--out", arguments.out, "File to write: .hdf5, .json or NAME.M.mtx")->required();
  add_reading_option(page, arguments.reading);
}

}  // namespace

Verb add_shrink(CLI::App& program) {
  return make_verb<ShrinkArguments>(
      program, "shrink", "Reduce an instance on which a solver fails to what the failure needs",
      shrink_options, shrink_instance,
      "Takes away contacts, friction directions, rows and digits (delta debugging), each "
      "candidate\n"
      "solved in a process of its own, started cold. Same input, same name and content.\n"
      "Example:\n"
      "  lcpbench shrink squat.hdf5#squat-like/0009 --solver lemke --out small.hdf5\n"
      "  lcpbench shrink frame.hdf5 --solver lemke --by-rounding --out small.hdf5\n"
      "  lcpbench shrink frame.hdf5 --solver dart-lemke --keep failure --out small.hdf5");
}

}  // namespace lcp::cli
