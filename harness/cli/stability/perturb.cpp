#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "harness/cli/interrupt.h"
#include "harness/cli/measurement.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/stability/parts.h"
#include "harness/studies/perturb/perturb_pages.h"
#include "harness/studies/suites.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp::cli {

namespace {

namespace fs = std::filesystem;

struct PerturbArguments {
  Measurement measurement;
  std::vector<std::string> solvers = {"own"};
  std::vector<std::string> kinds;
  PerturbOptions options;
  double same = 1e-6;
  std::string format = "text";
};

PerturbOptions options_of(const PerturbArguments& arguments) {
  PerturbOptions options = arguments.options;
  if (!arguments.kinds.empty()) options.kinds.clear();
  for (const std::string& name : arguments.kinds) {
    const DisturbanceKind kind = from_string<DisturbanceKind>(name);
    if (std::find(options.kinds.begin(), options.kinds.end(), kind) == options.kinds.end())
      options.kinds.push_back(kind);
  }
  return options;
}

/// Which disturbances a directory's rows are of: perturb.json, beside run.json.
fs::path options_file(const fs::path& out) { return out / "perturb.json"; }

/// Throws std::invalid_argument where a run that is to be resumed met other disturbances.
void require_same_options(const fs::path& out, const PerturbOptions& options) {
  const fs::path file = options_file(out);
  if (!fs::exists(file)) {
    if (fs::exists(out / "run.json"))
      throw std::invalid_argument(fmt::format(
          "{} holds a run without disturbances: name a new directory with --out", out.string()));
    return;
  }
  PerturbOptions begun;
  try {
    begun = nlohmann::json::parse(std::ifstream(file)).get<PerturbOptions>();
  } catch (const std::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (begun != options)
    throw std::invalid_argument(fmt::format(
        "{} was begun with other disturbances (then, now): {}, {}; name a new directory with --out",
        out.string(), nlohmann::json(begun).dump(), nlohmann::json(options).dump()));
}

/// The pairs to be run on stdout, how long they take at most on stderr.
int print_disturbed_pairs(const RunPlan& plan, const PerturbOptions& options,
                          const std::set<PairKey>& pairs_there) {
  std::set<std::tuple<std::string, std::string, std::string>> there;
  for (const PairKey& pair : pairs_there) there.insert({pair.instance, pair.solver, pair.start});
  std::size_t pairs = 0;
  for (std::size_t k = plan.shard.index; k < plan.instances.size(); k += plan.shard.count) {
    std::vector<std::string> names = {plan.instances[k].name};
    for (const Disturbance& each : disturbances_of(plan.instances[k], options))
      names.push_back(plan.instances[k].name + "~" + each.label);
    for (const std::string& name : names)
      for (const NamedSolver& solver : plan.solvers)
        for (const StartKind start : plan.starts) {
          if (there.contains({name, solver.spelling, to_string(start)})) continue;
          fmt::print("{} {}{}\n", name, solver.spelling,
                     plan.starts.size() > 1 ? " " + to_string(start) : "");
          ++pairs;
        }
  }
  const double seconds =
      std::chrono::duration<double>(plan.timeout).count() * static_cast<double>(pairs) / plan.jobs;
  fmt::print(stderr, "{} instances, {} solvers, {} pairs to run: at most {}\n",
             plan.instances.size(), plan.solvers.size(), pairs, printed_duration(seconds));
  return done;
}

int perturb(const PerturbArguments& arguments) {
  const PerturbOptions options = options_of(arguments);
  const Measurement& measurement = arguments.measurement;
  const std::string suite = suite_name(measurement);
  RunPlan plan = make_plan(measurement, make_solvers(arguments.solvers));
  plan.max_samples = 1;  // times do not matter
  plan.keep_answers = true;
  const fs::path out = !measurement.out.empty() ? measurement.out : "runs/perturb";
  if (measurement.resume) require_same_options(out, options);
  if (measurement.dry_run)
    return print_disturbed_pairs(plan, options,
                                 measurement.resume ? pairs_done(out) : std::set<PairKey>{});

  const std::atomic<bool>& interrupted = catch_interruptions();
  const Origin origin{suite, measurement.corpora, measurement.every, measurement.limit};
  RunReport report;
  {
    ProgressBar bar;
    bool noted = fs::exists(options_file(out));
    report = run_into(
        out, plan, expansion(options), origin,
        measurement.resume ? Existing::resume : Existing::refuse,
        [](const std::string& line) { fmt::print(stderr, "{}\n", line); },
        [&](const Progress& progress) {
          if (!noted) {
            replace_file(options_file(out).string(), nlohmann::json(options).dump(1) + "\n");
            noted = true;
          }
          bar.update(progress);
        },
        interrupted);
  }
  if (measurement.resume)
    fmt::print(stderr, "{} rows were there, {} are new\n", report.rows_before, report.rows);
  if (interrupted)
    return report_interruption(fmt::format("{} rows", report.rows_before + report.rows), out);
  const Flips flips = count_flips(plan.instances, read_run(out), options, arguments.same);
  write_pages(out, "flips", described(flips), arguments.format);
  fmt::print(stderr, "rows, flips, picture and environment are in {}\n", out.string());
  return done;
}

void perturb_options(CLI::App& page, PerturbArguments& arguments) {
  PerturbOptions& options = arguments.options;
  add(page, "--solver", arguments.solvers,
      "NAME[:key=value,...], pattern, own or all; repeatable. Default: own");
  add(page, "--kind", arguments.kinds, "Disturbance; repeatable. Default: all of them",
      CLI::IsMember(all_names<DisturbanceKind>()));
  add_with_default(
      page, "--trials", options.trials,
      "Disturbed versions of each instance, of each kind (units: 3, scale-q: 12 at most)",
      CLI::PositiveNumber);
  add_with_default(page, "--seed", options.seed, "Of the draws");
  add_with_default(page, "--last-bits", options.last_bits,
                   "noise: numbers are multiplied by 1 + k 2^-52, |k| at most this",
                   CLI::Range(1, 1 << 30));
  add(page, "--angle", options.angle,
      "rotation: by random angles up to this (degrees), which is another polygon and so another "
      "problem. Default: multiples of the directions' spacing, the same polygon with other labels",
      CLI::Range(0.0, 180.0));
  add_with_default(page, "--same", arguments.same,
                   "Two z are one solution if |dz_i| / s_z,i is at most this (w likewise)",
                   CLI::PositiveNumber);
  add_with_default(page, "--format", arguments.format, "How the flips are printed",
                   CLI::IsMember({"csv", "json", "text"}));
  add_options(page, arguments.measurement);
}

}  // namespace

Verb add_stability_perturb(CLI::App& page) {
  return make_verb<PerturbArguments>(
      page, "perturb",
      "How often a verdict flips when the data change in ways that should not matter",
      perturb_options, perturb,
      "Kinds: noise (last bits of M and q), permutation (rows, contacts), units (mm, kN, both),\n"
      "rotation (tangent axes), scale-q (q times 1e-6 ... 1e6). A flip is solved <-> not solved.\n"
      "Writes DIR/{run.json, env.json, perturb.json, rows.jsonl, flips.txt, flips.csv, "
      "flips.json,\n"
      "flips.svg}; DIR is runs/perturb unless --out names it. Each pair is solved once.\n"
      "Example:\n"
      "  lcpbench stability perturb --suite contact --every 10 --solver lemke --solver best-first\n"
      "  lcpbench stability perturb --corpus mine.hdf5 --kind noise --last-bits 4 --trials 20");
}

}  // namespace lcp::cli
